# SPDX-License-Identifier: Apache-2.0
# Sourced by tools/demo and tools/test: runs stages of work with one line of output each.
# shellcheck shell=bash
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 3
# A first build finds nothing in the cache of the compiler. In this mode, ccache does not run the preprocessor for each
# miss, which took a tenth of the build.
export CCACHE_DEPEND=1

# stage TITLE COMMAND...: prints one line with the elapsed seconds; the output only on failure.
stage() {
  local title=$1 log start=$SECONDS
  shift
  log=$(mktemp)
  printf '%-58s ' "$title"
  if "$@" >"$log" 2>&1; then
    rm -f "$log"
    printf '%4d s\n' $((SECONDS - start))
  else
    local status=$?
    printf 'FAILED after %d s\n' $((SECONDS - start))
    tail -n 60 "$log" >&2
    echo "Stage '$title' failed: $*" >&2
    echo "The complete output is in $log" >&2
    exit "$status"
  fi
}

# show TITLE COMMAND...: runs a stage whose output is shown.
show() {
  local title=$1 start=$SECONDS
  shift
  echo "$title"
  "$@" || {
    local status=$?
    echo "Stage '$title' failed: $*" >&2
    exit "$status"
  }
  printf '%-58s %4d s\n' "$title: done" $((SECONDS - start))
}
