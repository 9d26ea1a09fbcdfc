#!/usr/bin/env bash
# Killed at random moments while tables are changed, and started again: the state always loads, and holds
# the last value that was answered, or the one behind it. Nothing moves before an operator says so.
#
# usage: kills_test.sh STANOKD STANOK MACHINE_FILE [KILLS]   (default 50)
set -euo pipefail
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"
readonly kills=${4:-50}
RANDOM=4711

# The offset as it is now; it counts up by one with each command.
read_offset() {
  expect_exit 0 offset list --json
  [[ $output =~ \"X\":([0-9]+)\.0 ]] && echo "${BASH_REMATCH[1]}" || echo 0
}

value=0
for ((life = 1; life <= kills; ++life)); do
  start_daemon
  found=$(read_offset)
  ((found <= value)) || fail "life $life: $found was never set, the last one was $value"
  ((value - found <= 1)) || fail "life $life: $value was answered, $found is there"
  value=$found
  expect_exit 0 machine status --json
  expect_output '"on":false' "life $life"
  (
    trap - EXIT
    sleep "0.$(printf '%03d' $((RANDOM % 700)))"
    kill -KILL "$daemon"
  ) &
  killer=$!
  while "${operate[@]}" offset set G54 X $((value + 1)) --confirmed 1 >/dev/null 2>&1; do value=$((value + 1)); done
  value=$((value + 1)) # it may have been taken and not answered
  wait "$killer"
  expect_end 137
  grep -qi 'terminate\|assert\|sanitizer' "$folder/stanokd.err" && fail "it did not die of the kill"
done
start_daemon
expect_exit 0 system shutdown
expect_end 0
echo "kills: $kills passed, the last value was $value"
