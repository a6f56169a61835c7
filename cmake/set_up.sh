# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by deploy/run and tests/run: prepares a fresh Debian 12 or 13 machine for a build, and prints what it does. Steps that are
# already done are skipped.

# packages_of RELEASE: packages in cmake/debian_packages.txt for Debian 12 or 13, one per line.
packages_of() { sed -nE -e '/^[a-z][^ ]*$/p' -e "s/^$1 //p" cmake/debian_packages.txt; }

# install_packages: installs the packages in cmake/debian_packages.txt that are missing.
install_packages() {
  local missing=() package as_root=() release
  if ! command -v dpkg-query > /dev/null; then
    echo "This is not Debian: the packages of cmake/debian_packages.txt are taken to be there."
    return
  fi
  release=$(. /etc/os-release && echo "${ID:-} ${VERSION_ID:-}")
  case "$release" in
    "debian 12" | "debian 13") ;;
    *) echo "This is neither Debian 12 nor 13 ($release): the packages of Debian 13 are tried." ;;
  esac
  while read -r package; do
    if [ "$(dpkg-query -W -f '${Status}' "$package" 2> /dev/null)" != "install ok installed" ]; then
      missing+=("$package")
    fi
  done < <(packages_of "$([ "$release" = "debian 12" ] && echo 12 || echo 13)")
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
  echo "Installing missing Debian packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# build_preset NAME [TARGET...]: configures when there is no build yet, then builds.
build_preset() {
  local preset=$1
  shift
  if [ ! -f "build/$preset/build.ninja" ]; then
    echo "Configuring build/$preset"
    cmake --preset "$preset" > /dev/null
  fi
  echo "Building build/$preset"
  if [ $# -gt 0 ]; then cmake --build --preset "$preset" --target "$@"; else cmake --build --preset "$preset"; fi
}
