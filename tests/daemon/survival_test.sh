#!/usr/bin/env bash
# What a daemon survives, and what survives a daemon: killed in a move and started again, ended in a
# move, stopped and continued, clients that go away, many clients at once, folders that are none.
#
# usage: survival_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/running_daemon.sh"

printf 'G21 G90 G17 G54\nG0 X0 Y0\nG1 X200 F6000\nM30\n' >"$folder/move.nc" # 2 s
printf 'G21 G90 G17 G54\nG0 X0 Y0\nG1 X200 F60\nM30\n' >"$folder/long.nc"   # 200 s

# Drives that were starved on the way to the beginning fault, and an operator begins again.
begin_long_program() {
  local k
  for ((k = 0; k < 10; ++k)); do
    switch_on
    expect_exit 0 program run long.nc
    wait_for '"line":3,' '"code":"A3'
    [[ $output == *'"code":"A3'* ]] || return 0
    reset_channels
  done
  fail "long.nc does not begin"
}

# Killed in a move: what it leaves, the socket included, does not keep the next one from starting.
start_daemon
begin_long_program
kill -KILL "$daemon"
expect_end 137
[[ -S $folder/op.sock ]] || fail "a killed daemon cannot have removed its socket"
expect_exit 3 machine status
start_daemon
expect_exit 0 channel status --json
expect_output '"state":"Reset"' "after a daemon that was killed"
expect_exit 1 program run move.nc # nothing moves until an operator says so

# Where the axes stood is there again: at rest, after a run that moved them.
switch_on
run_through move.nc
printf 'G28.1\nM30\n' >"$folder/store.nc"
run_through store.nc
expect_exit 0 channel status --json
[[ $output =~ '"axes":{'([^=]*)'"begins_at"' ]] || fail "no axes in: $output"
position_of() { grep -o "\"$1\":{[^}]*\"position\":[-0-9.e]*" <<<"$output" | grep -o '[-0-9.e]*$'; }
stood=$(position_of X)
for ((k = 0; k < 100; ++k)); do
  grep -qs "X = $stood" "$folder/state/positions.toml" && grep -qs G28 "$folder/state/tables.toml" && break
  sleep 0.05
done
kill -KILL "$daemon"
expect_end 137
start_daemon
expect_exit 0 channel status --json
[[ $(position_of X) == "$stood" ]] || fail "X stands at $(position_of X), it stood at $stood"
expect_exit 0 tool save
expect_output '[reference_point.1.G28]' "a reference point that was stored"

# The job lives in the daemon: clients that give up, are interrupted or are killed change nothing.
begin_long_program
expect_exit 0 program stop
expect_exit 4 program run long.nc --wait --timeout 0.5
wait_for '"program_status":"Running"'
expect_exit 0 program stop
"${operate[@]}" program run long.nc --wait &
client=$!
wait_for '"line":3,'
kill -KILL "$client"
code=0
wait "$client" || code=$?
[[ $code == 137 ]] || fail "the client ended with $code"
wait_for '"program_status":"Running"'

# Many operators at once: each is answered.
clients=()
for ((k = 0; k < 20; ++k)); do
  "${operate[@]}" override feed $((50 + k)) &
  clients+=($!)
done
for client in "${clients[@]}"; do wait "$client" || fail "one of many operators was not served"; done

# Stopped for a second and continued, longer than lost periods are made up for: they are counted, and the drives,
# which are those of the machine file and no patient ones now, left alone for longer than their watchdog
# of half a second allows, have stopped: a fault that a reset ends.
expect_exit 0 program stop
kill -TERM "$daemon"
expect_end 0
: >"$folder/stanokd.err"
machine_file=$3
start_daemon
begin_long_program
kill -STOP "$daemon"
sleep 1
kill -CONT "$daemon"
for ((k = 0; k < 100; ++k)); do # figures are at most 100 ms old
  expect_exit 0 machine status --json
  [[ $output =~ '"periods_skipped":'[1-9][0-9][0-9] ]] && break
  sleep 0.05
done
[[ $output =~ '"periods_skipped":'[1-9][0-9][0-9] ]] || fail "no skipped periods in: $output"
wait_for '"code":"A3'
wait_for '"speed_mm_s":0.0,'
expect_exit 0 program reset
expect_exit 0 program reset --channel 2
begin_long_program

# SIGTERM in a move: feed hold, drives off, an orderly end.
kill -TERM "$daemon"
expect_end 0
grep -q 'ending by SIGTERM' "$folder/stanokd.err" || fail "the end does not say why"
[[ ! -e $folder/op.sock ]] || fail "the socket is still there"

# Wrong folders and files: said at once, before anything starts.
expect_refusal() {
  local code=0
  timeout 20 "$stanokd" --lcm off --drives embedded --socket "$folder/op.sock" "$@" 2>"$folder/refusal" || code=$?
  [[ $code == 1 ]] || fail "stanokd $*: $code, not 1: $(cat "$folder/refusal")"
}
touch "$folder/file"
expect_refusal --machine "$machine_file" --state "$folder/file"
expect_refusal --machine "$machine_file" --state "$folder/state" --log "$folder/file/log"
expect_refusal --machine "$folder/no_such_machine.toml" --state "$folder/state"
grep -q no_such_machine.toml "$folder/refusal" || fail "the refusal does not name the machine file"
[[ ! -e $folder/op.sock ]] || fail "a refused daemon leaves a socket"
"$stanokd" --machine "$machine_file" --check-config >/dev/null || fail "--check-config of a sound machine file"
echo "survival: passed"
