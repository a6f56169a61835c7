# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by tests/run.

# test_other_release: on the Debian release that this machine does not have, in build/chroot (deploy/chroot), what shows that
# the tree works there: tests/run --brief. Counts its tests; where no chroot can be made, as one that is skipped.
test_other_release() {
  local release log total
  case "$(. /etc/os-release && echo "${ID:-} ${VERSION_ID:-}")" in
    "debian 12") release=trixie ;;
    *) release=bookworm ;;
  esac
  log=$(mktemp)
  if ! deploy/chroot "$release" true 2> "$log"; then
    echo "Skipped on Debian $release: $(tail -n 1 "$log")"
    skipped=$((skipped + 1))
    return
  fi
  echo "On Debian $release, in build/chroot/$release:"
  # Only the build gains by it, so it is no package of the project's.
  if command -v ccache > /dev/null; then
    deploy/chroot "$release" sh -c 'command -v ccache || { apt-get update -q && apt-get install -q -y --no-install-recommends ccache; }' > "$log" 2>&1 ||
      tail -n 3 "$log"
  fi
  deploy/chroot "$release" tests/run --brief 2>&1 | tee "$log" | sed 's/^/[other release] /' || true
  total=$(tail -n 1 "$log" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed(, ([0-9]+) skipped)?$/\1 \2 \4/p')
  if [ -z "$total" ]; then total="0 1 0"; fi
  set -- $total
  passed=$((passed + $1))
  failed=$((failed + $2))
  skipped=$((skipped + ${3:-0}))
  rm -f "$log"
}
