#!/usr/bin/env bash
# Runs a folder of part programs from elsewhere through check and interpret and, where rs274 is installed,
# through the comparison with it. Prints a table; the programs stay where they are.
#
# usage: corpus.sh STANOK FOLDER
#
# A program whose name begins with or contains "lathe", "g76" or "thread" runs on the lathe of
# config/machines, all others on the mill of the peer comparison. A faulty program is a row, not a failure:
# the exit code is 1 only when stanok itself fails (a signal, or no answer within two minutes).
set -euo pipefail

if (($# != 2)); then
  sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
stanok="$(realpath "$1")"
folder="$(realpath "$2")"
root="$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")"
output="$(mktemp)"
trap 'rm -f "$output"' EXIT
failed=0

machine_for() {
  case "${1,,}" in
    *lathe* | *g76* | *thread*) echo "$root/config/machines/lathe.toml" ;;
    *) echo "$root/tests/peers/rs274/mill6.toml" ;;
  esac
}

# run COMMAND...: its output in $output; the words that describe how it ended in $result.
run() {
  local code=0
  timeout 120 "$@" >"$output" 2>&1 </dev/null || code=$?
  case "$code" in
    0) result="ok" ;;
    6) result="$(grep -m1 -oE '^error\[[^]]*\]: .{0,60}' "$output" || echo "errors")" ;;
    124) result="no answer" failed=1 ;;
    *) result="exit $code" ;;
  esac
  if ((code > 128)); then failed=1; fi
}

compared() {
  if ! command -v rs274 >/dev/null; then
    echo "-"
  elif "$root/tests/peers/rs274/compare.py" "$stanok" "$1" >"$output" 2>&1; then
    echo "same"
  else
    head -n 1 "$output" | sed 's/^[^:]*: //' | cut -c1-60
  fi
}

printf '%-28s %-68s %-68s %s\n' program check interpret rs274
while IFS= read -r program; do
  name="$(basename "$program")"
  machine="$(machine_for "$name")"
  run "$stanok" check --machine "$machine" "$program"
  checked="$result"
  run "$stanok" interpret --quiet --machine "$machine" "$program"
  printf '%-28s %-68s %-68s %s\n' "$name" "$checked" "$result" "$(compared "$program")"
done < <(find "$folder" -type f \( -name '*.ngc' -o -name '*.nc' -o -name '*.gcode' \) | sort)
exit "$failed"
