#!/usr/bin/env bash
# Drives that outlive their daemon: killed in a rapid, the drives' watchdogs stop the axes, and the
# next daemon moves nothing; ended by SIGTERM in a rapid, the axes stop along the path and the
# drives are off before the daemon goes.
#
# usage: orphaned_drives_test.sh STANOKD STANOK STANOK_DRIVES
set -euo pipefail
readonly stanok_drives=$3
machine=$(mktemp)
set -- "$1" "$2" "$machine"
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/running_daemon.sh"
readonly drive_choice=real
machine_file=$machine # written below
drives=
end_all() {
  if [[ -n $drives ]]; then kill -KILL "$drives" 2>/dev/null || true; fi
  rm -f "$machine"
  stop_daemon
}
trap end_all EXIT

{
  printf '[machine]\nname = "two axes"\n'
  for axis in X Y; do
    printf '[[axis]]\nname = "%s"\nkind = "linear"\nmin = -500\nmax = 500\nvelocity_max = 250\n' "$axis"
    printf 'acceleration_max = 2500\njerk_max = 50000\n'
  done
  printf '[[channel]]\nid = 1\nname = "work"\naxes = ["X", "Y"]\n'
  # The watchdogs of these drives are twice this: a loaded computer may starve them for as long.
  printf '[drives]\nbus = "modbus-tcp"\nhost = "127.0.0.1"\nport = 1502\ntimeout_ms = 1000\n'
} >"$machine"

"$stanok_drives" --machine "$machine" --json >"$folder/units.json" &
drives=$!
for ((k = 0; k < 100; ++k)); do
  grep -qs port "$folder/units.json" && break
  sleep 0.05
done
port=$(grep -o '"port":[0-9]*' "$folder/units.json" | cut -d: -f2)
sed -i "s/^port = .*/port = $port/" "$machine"

# 250 mm/s over 1.6 s each.
printf 'G21 G90 G17 G54\nG0 X-200 Y-100\nG0 X200 Y100\nG0 X-200 Y-100\nG0 X200 Y100\nM30\n' >"$folder/rapid.nc"

# drive_positions: those that the drives tell, in one line.
drive_positions() { "${operate[@]}" drive status --json | grep -o '"position":[-0-9.]*' | tr '\n' ' '; }

# begin_rapid: until the axes are in line 3. Drives that were starved (see switch_on) end the run, and an operator
# begins again.
begin_rapid() {
  local k begun
  for ((k = 0; k < 10; ++k)); do
    switch_on
    expect_exit 0 program run rapid.nc
    begun=$SECONDS
    while ((SECONDS - begun < 20)); do
      expect_exit 0 channel status --json
      [[ $output == *'"line":3,'* ]] && return
      [[ $output == *'"alarm":null'* ]] || break
      sleep 0.05
    done
    expect_exit 0 program reset
  done
  fail "the rapid never came to line 3"
}

expect_rest() {
  local before after k
  for ((k = 0; k < 100; ++k)); do
    before=$(drive_positions)
    sleep 0.3
    after=$(drive_positions)
    [[ -n $before && $before == "$after" ]] && return
  done
  fail "$1: the axes still move: $before then $after"
}

start_daemon
begin_rapid
kill -KILL "$daemon"
expect_end 137
sleep 4 # twice the longest watchdog
start_daemon
for ((k = 0; k < 100; ++k)); do
  expect_exit 0 drive status --json
  [[ $output != *'"in_contact":false'* ]] && break
  sleep 0.05
done
expect_output '"state":"fault"' "drives whose daemon was killed"
rest=$(drive_positions)
sleep 1
[[ $(drive_positions) == "$rest" ]] || fail "an axis moves after the daemon was killed: $rest"
expect_exit 1 program run rapid.nc # nothing moves until an operator says so

expect_exit 0 program reset
begin_rapid
kill -TERM "$daemon"
for ((k = 0; k < 100; ++k)); do # 5 s
  kill -0 "$daemon" 2>/dev/null || break
  sleep 0.05
done
if kill -0 "$daemon" 2>/dev/null; then fail "the daemon has not ended 5 s after SIGTERM"; fi
expect_end 0
start_daemon
for ((k = 0; k < 100; ++k)); do
  expect_exit 0 drive status --json
  [[ $output != *'"in_contact":false'* ]] && break
  sleep 0.05
done
[[ $output != *'"state":"fault"'* ]] || fail "a drive in fault after an orderly end: $output"
[[ $output != *'"state":"operation_enabled"'* ]] || fail "a drive is on after an orderly end: $output"
expect_rest "after SIGTERM"
echo "orphaned drives: passed"
