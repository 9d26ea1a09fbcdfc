#!/usr/bin/env bash
# The whole daemon in real time, operated by the real `stanok`: on, run, hold, resume, estop, a
# program with errors, shutdown. Embedded drives, no LCM; everything lives in a temporary folder.
#
# usage: end_to_end_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail

# shellcheck source=tests/daemon/running_daemon.sh
source "$(dirname "${BASH_SOURCE[0]}")/running_daemon.sh"

printf 'G21 G90 G17 G54\nG0 X1 Y1\nG1 X3 F600\nM30\n' >"$folder/short.nc"
printf 'G21 G90 G17 G54\nG0 X0 Y0\nG1 X200 F600\nM30\n' >"$folder/long.nc"
printf 'G21 G90\nG1 X1 F\nM30\n' >"$folder/wrong.nc"

start_daemon --log "$folder/log"

expect_exit 0 channel status --json
expect_output '"state":"Reset"' "before anything was asked"
expect_exit 1 program run short.nc # the machine is off

# A second daemon is refused, by state directory and by name of the first.
second=0
"$stanokd" --machine "$machine_file" --drives embedded --lcm off --state "$folder/state" \
  --socket "$folder/second.sock" --program-root "$folder" 2>"$folder/second.err" || second=$?
[[ $second == 1 ]] || fail "a second daemon ended with $second"
grep -q "pid $daemon" "$folder/second.err" || fail "the second daemon does not name the first"

switch_on
run_through short.nc --json
expect_output '"ok":true' "the short program"
expect_output '"blocks":' "the short program"
expect_exit 0 channel status --json
expect_output '"state":"Reset"' "after the run"
expect_output '"X":3.0,' "end of the run, programmed X"
expect_output '"program":"short.nc"' "after the run"

expect_exit 6 program run wrong.nc --wait --json
expect_output '"file":"wrong.nc"' "a program with errors"
expect_output '"line":2,' "a program with errors"

expect_exit 0 program run long.nc
wait_for '"line":3,'
expect_exit 0 program hold
wait_for '"program_status":"Interrupted"'
wait_for '"speed_mm_s":0.0,'
held=$(positions)
sleep 0.2
expect_exit 0 channel status --json
[[ -n $held && $(positions) == "$held" ]] || fail "the axes move while held: $held, then $(positions)"
expect_exit 0 program resume
wait_for '"program_status":"Running"'

expect_exit 0 machine estop
wait_for '"program_status":"Canceled"'
wait_for '"code":"A1001"'
for ((k = 0; k < 200; ++k)); do
  expect_exit 0 machine status --json
  [[ $output == *'"on":false'* ]] && break
  sleep 0.05
done
expect_output '"on":false' "after the emergency stop"

# From there back to work: every channel has the alarm.
expect_exit 1 machine on
expect_exit 0 program reset
expect_exit 0 program reset --channel 2
switch_on
run_through short.nc

expect_exit 0 system shutdown
expect_end 0
[[ ! -e $folder/op.sock ]] || fail "the socket is still there"
log=$(find "$folder/log" -name '*.lcm' ! -name '*-flight-*')
flight=$(find "$folder/log" -name '*-flight-*.lcm')
[[ -s $log ]] || fail "no log was written"
[[ -s $flight ]] || fail "the emergency stop left no record of its last seconds"
"$2" log info "$flight" >/dev/null || fail "the flight record cannot be read"
# What happened in real time, with all that was commanded, comes out the same from the log.
verified=0
"$2" log verify "$log" >"$folder/verified" || verified=$?
if [[ $verified == 8 && ${STANOK_REPEATED:-0} -lt 5 ]]; then
  # A computer with too much to do starved the recorder for a second, and the log says so (W720): all over again.
  rm -rf "$folder"
  STANOK_REPEATED=$((${STANOK_REPEATED:-0} + 1)) exec "$0" "$@"
fi
[[ $verified == 0 ]] || fail "the log cannot be verified: $(cat "$folder/verified")"
grep -q 'are the same, bit for bit' "$folder/verified" || fail "log verify says: $(cat "$folder/verified")"
expect_exit 3 machine status # nobody is there any more
echo "end to end: passed"
