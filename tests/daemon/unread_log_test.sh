#!/usr/bin/env bash
# Standard error that nobody reads, a full pipe from before the start: the daemon starts, works, stops on request, and
# ends in order in a move, by each of the signals that used to kill it.
#
# usage: unread_log_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/running_daemon.sh"

printf 'G21 G90 G17 G54\nG1 X400 F600\nM30\n' >"$folder/long.nc"
mkfifo "$folder/unread"
exec 9<>"$folder/unread"
timeout 2 cat /dev/zero >"$folder/unread" || true # until the pipe is full

for signal in HUP USR1 USR2 QUIT; do
  # Background jobs of a script ignore SIGQUIT; the daemon does not.
  "$stanokd" --machine "$machine_file" --drives embedded --lcm off --state "$folder/state" \
    --socket "$folder/op.sock" --program-root "$folder" 2>"$folder/unread" &
  daemon=$!
  for ((k = 0; k < 600; ++k)); do
    "${operate[@]}" system info >/dev/null 2>&1 && break
    sleep 0.05
  done
  switch_on
  for ((k = 0; k < 25; ++k)); do # each is a line of the log
    "${operate[@]}" override feed 100 >/dev/null
  done &
  talk=$!
  expect_exit 0 program run long.nc
  wait_for '"line":2,'
  expect_exit 0 program hold
  wait_for '"program_status":"Interrupted"'
  expect_exit 0 machine estop
  wait_for '"enabled":false'
  wait "$talk" || fail "an override was refused"
  expect_exit 0 program reset
  switch_on
  expect_exit 0 program run long.nc
  wait_for '"line":2,'
  kill -"$signal" "$daemon"
  expect_end 0
  [[ ! -e $folder/op.sock ]] || fail "the socket is still there after SIG$signal"
done
echo "unread log: passed"
