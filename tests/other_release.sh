# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by tests/run.

# Time limit for downloading a Debian and its packages.
download_limit_s=900

# skip_other_release REASON: for test_other_release.
skip_other_release() {
  echo "Skipped on the other Debian release: $1"
  rm -f "$log"
  skipped=$((skipped + 1))
}

# other_release_within SECONDS COMMAND...: the exit code is 137 when the time was not enough. Everything that COMMAND has started ends
# with it (deploy/chroot).
other_release_within() { timeout --foreground --signal=KILL "$@"; }

# test_other_release [END_S [FOLDER]]: runs tests/run --brief on the Debian release that this machine does not have, in build/chroot
# (deploy/chroot), to show that the tree works there, and counts its tests. It counts one skipped test where no chroot can be set up,
# when the mirror is too slow, or when it is not done END_S seconds after the script's start.
test_other_release() {
  local release enter log total status=0 end_s=${1:-} left_s=0
  case "$(. /etc/os-release && echo "${ID:-} ${VERSION_ID:-}")" in
    "debian 12") release=trixie ;;
    *) release=bookworm ;;
  esac
  enter=(deploy/chroot --folder "${2:-build/chroot/$release}" "$release")
  log=$(mktemp)
  if [ -n "$end_s" ]; then
    left_s=$((end_s - SECONDS))
    if [ $left_s -lt $download_limit_s ]; then download_limit_s=$((left_s > 1 ? left_s : 1)); fi
  fi
  echo "Preparing Debian $release in ${2:-build/chroot/$release}"
  other_release_within $download_limit_s "${enter[@]}" bash -ec '
    . cmake/set_up.sh
    install_packages
    # It only speeds up the build, so it is not a package of the project.
    if [ -n "${CCACHE_DIR:-}" ] && ! command -v ccache; then apt-get install -q -y --no-install-recommends ccache; fi
  ' > "$log" 2>&1 || status=$?
  case $status in
    0) ;;
    137)
      skip_other_release "Debian $release and its packages did not come within $download_limit_s s: $(tail -n 1 "$log")"
      return
      ;;
    *)
      skip_other_release "$(tail -n 1 "$log")"
      return
      ;;
  esac
  if [ -n "$end_s" ]; then left_s=$((end_s - SECONDS > 1 ? end_s - SECONDS : 1)); fi
  other_release_within $left_s "${enter[@]}" tests/run --brief > >(tee "$log" | sed -u "s/^/[$release] /") 2>&1 || status=$?
  wait $! || true
  if [ "$status" -eq 137 ]; then
    skip_other_release "not done in the $left_s s that were left for it"
    return
  fi
  total=$(tail -n 1 "$log" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed, ([0-9]+) skipped$/\1 \2 \3/p')
  if [ -z "$total" ]; then total="0 1 0"; fi
  set -- $total
  passed=$((passed + $1))
  failed=$((failed + $2))
  skipped=$((skipped + $3))
  rm -f "$log"
}
