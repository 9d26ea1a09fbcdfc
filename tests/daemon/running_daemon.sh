# Sourced by the tests that operate a real daemon with the real `stanok`: a temporary folder, a daemon
# in it, and expectations that say what went wrong.
#
# usage of those tests: TEST STANOKD STANOK MACHINE_FILE
# shellcheck shell=bash
# shellcheck source=tests/support/patient_machine.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/patient_machine.sh"
readonly stanokd=$1
folder=$(mktemp -d)
readonly folder
machine_file=$(patient_machine "$3" "$folder")
operate=("$2" --socket "$folder/op.sock")
daemon=

stop_daemon() {
  if [[ -n $daemon ]]; then kill -KILL "$daemon" 2>/dev/null || true; fi
  rm -rf "$folder"
}
trap stop_daemon EXIT

fail() {
  "${operate[@]}" channel status --json >&2 || true
  if [[ -f $folder/stanokd.err ]]; then cat "$folder/stanokd.err" >&2; fi
  printf 'FAILED: %s\n' "$1" >&2
  exit 1
}

# start_daemon [ARGUMENT...]: returns when it answers; its drives are $drive_choice, else embedded, its
# LCM URL $lcm, else none.
# shellcheck disable=SC2120
start_daemon() {
  "$stanokd" --machine "$machine_file" --drives "${drive_choice:-embedded}" --lcm "${lcm:-off}" \
    --state "$folder/state" --socket "$folder/op.sock" --program-root "$folder" "$@" 2>>"$folder/stanokd.err" &
  daemon=$!
  local k
  for ((k = 0; k < 600; ++k)); do
    "${operate[@]}" system info >/dev/null 2>&1 && return
    kill -0 "$daemon" 2>/dev/null || fail "the daemon did not start"
    sleep 0.05
  done
  fail "the daemon does not answer"
}

# expect_end CODE: the daemon has ended, or does so before ctest loses patience, which says less.
expect_end() {
  local -r begun=$SECONDS
  local code=0
  while kill -0 "$daemon" 2>/dev/null; do
    ((SECONDS - begun < 120)) || fail "the daemon does not end"
    sleep 0.02
  done
  wait "$daemon" || code=$?
  daemon=
  [[ $code == "$1" ]] || fail "the daemon ended with $code, not $1"
}

# expect_exit CODE ARGUMENT...: what `stanok ARGUMENT...` printed goes to $output.
expect_exit() {
  local wanted=$1 code=0
  shift
  output=$("${operate[@]}" "$@" 2>"$folder/stanok.err") || code=$?
  [[ $code == "$wanted" ]] || fail "stanok $*: exit code $code, not $wanted: $(cat "$folder/stanok.err")"
}

# reset_channels: both of a machine that has two; ends faults of drives.
reset_channels() {
  "${operate[@]}" program reset >/dev/null 2>&1 || true
  "${operate[@]}" program reset --channel 2 >/dev/null 2>&1 || true
}

# switch_on: a computer that is loaded may starve the drives inside the daemon, which is told as a drive that does
# not answer (A3001) or as its fault (A3002); an operator resets (E6004) and switches on again.
switch_on() {
  local k
  for ((k = 0; k < 10; ++k)); do
    output=$("${operate[@]}" machine on 2>"$folder/stanok.err") && return
    grep -qE 'A300[12]|E6004' "$folder/stanok.err" || break
    sleep 0.5
    reset_channels
  done
  fail "stanok machine on: $(cat "$folder/stanok.err")"
}

# run_through PROGRAM [OPTION...]: to its end. Drives that were starved in the run (see switch_on) fault (A3...), and an
# operator begins again.
run_through() {
  local k
  for ((k = 0; k < 10; ++k)); do
    output=$("${operate[@]}" program run "$@" --wait 2>"$folder/stanok.err") && return
    grep -q A3 "$folder/stanok.err" || break
    reset_channels
    switch_on
  done
  fail "stanok program run $1: $(cat "$folder/stanok.err")"
}

# wait_for TEXT...: until `channel status --json` contains one of the texts; gives up well before ctest would, which
# says less.
wait_for() {
  local -r begun=$SECONDS
  local text
  while ((SECONDS - begun < 120)); do
    expect_exit 0 channel status --json
    for text in "$@"; do [[ $output != *"$text"* ]] || return 0; done
    sleep 0.05
  done
  fail "channel status never showed $*"
}

# positions: all that stand in $output, of a status of a channel. What else it says may change at rest, as
# predictions do.
positions() {
  grep -o '"position":[^,}]*[^}]*' <<<"$output"
}

expect_output() {
  [[ $output == *"$1"* ]] || fail "$2: no $1 in: $output"
}
