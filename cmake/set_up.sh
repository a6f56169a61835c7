# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by deploy/run and tests/run: brings a fresh Debian 12 machine to a build, saying what it does. Nothing
# is done that is done already.

# install_packages: what cmake/debian_packages.txt names and dpkg does not know as installed.
install_packages() {
  local missing=() package as_root=()
  if ! command -v dpkg-query > /dev/null; then
    echo "This is not Debian: the packages of cmake/debian_packages.txt are taken to be there."
    return
  fi
  while read -r package; do
    if [ "$(dpkg-query -W -f '${Status}' "$package" 2> /dev/null)" != "install ok installed" ]; then
      missing+=("$package")
    fi
  done < <(grep -v -e '^#' -e '^$' cmake/debian_packages.txt)
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
