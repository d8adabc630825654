# Sourced by tools/demo and tools/test: runs a stage of the work quietly, one line each.
# shellcheck shell=bash
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 3

# stage TITLE COMMAND...: one line with the seconds it took; its output only when it fails.
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
    echo "All it said is in $log" >&2
    exit "$status"
  fi
}

# show TITLE COMMAND...: the same for a stage whose output is the point.
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
