#!/usr/bin/env bash
# `stanok workpiece follow` beside a running daemon, in a network namespace with a loopback only.
#
# Before they are allowed, announcements stay with the daemon. Then a program runs with a follower on
# the bus, and the log that the daemon has written is followed afterwards. Both must cut what
# `simulate` cuts: the log exactly but for rounding, the bus nearly so, since UDP may lose.
# Exit code 77 (skipped) where namespaces are not to be had.
#
# usage: workpiece_follow.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail

readonly needed_tools=(python3)
# shellcheck source=tests/peers/in_namespace.sh
source "$(dirname "${BASH_SOURCE[0]}")/in_namespace.sh"

expect() {  # TEXT in the output of a command
  local wanted=$1
  shift
  grep -q "$wanted" <<<"$(operate "$@" --json)" || fail "stanok $* does not say $wanted"
}

# A groove of 6 x 2 round a square, and a rapid through the corner of the block.
cat >"$folder/part.nc" <<'PROGRAM'
G21 G90 G17 G40 G49 G80 G54
#workpiece (0, 0.5, 0, 40, 40, 10, 20, 20, 10)
T3 M6
S9000 M3
G0 X-10 Y-10
G43 H3 Z5
G1 Z-2 F1500
X10
Y10
X-10
Y-10
G0 Z5
G0 X-30 Y-18
G0 Z-1
G0 X-15
G0 Z100
M30
PROGRAM

"$stanok" simulate "$folder/part.nc" --machine "$machine_file" --workpiece-report \
  "$folder/simulated.json" >/dev/null 2>"$folder/simulate.err" || fail "simulate"

follow_a_run() {
  start_daemon
  expect '"allowed":false' workpiece status
  expect '"allowed":true' workpiece allow
  "$stanok" workpiece follow "$url" --machine "$machine_file" --out "$folder/bus" --every 2 \
    >"$folder/follow.out" 2>"$folder/follow.err" &
  follower=$!
  started+=("$follower")
  sleep 1 # until it listens
  operate machine on
  operate program run part.nc --channel 1 --wait --json
  expect '"shape":"box"' workpiece status
  # The run takes some 9 s of machine time; a follower on a loaded computer lags behind.
  for ((k = 0; k < 1200; ++k)); do
    grep -q '1[2-9]\.000 s' "$folder/follow.out" "$folder/follow.err" && break
    sleep 0.05
  done
  kill -INT "$follower"
  wait "$follower" || fail "the follower ended with $?"
  operate system shutdown
  wait "$daemon" || fail "the daemon ended with $?"
  "$stanok" workpiece follow "$folder"/log/*.lcm --out "$folder/log_parts" >/dev/null \
    2>"$folder/follow_log.err" || fail "the log cannot be followed"
}

readonly attempts=6
for ((attempt = 1; attempt <= attempts; ++attempt)); do
  rm -rf "$folder/log" "$folder/log_parts" "$folder/bus" "$folder/state"
  follow_a_run
  grep -q 'W720' "$folder/follow_log.err" || break
  cat "$folder/follow_log.err"
done
((attempt <= attempts)) || fail "the recorder lost setpoints in each of $attempts runs"

python3 - "$folder" <<'PYTHON' || fail "the parts differ"
import glob, json, sys
folder = sys.argv[1]
wanted = json.load(open(folder + "/simulated.json"))
places = lambda part: [(f["code"], f["file"], f["line"]) for f in part["findings"]]
assert places(wanted) == [("W921", "part.nc", 15)], places(wanted)
for name, share in ("log_parts", 1e-3), ("bus", 2e-2):
    part = json.load(open(f"{folder}/{name}/part.json"))
    print(f"{name}: {part['removed_mm3']:.2f} mm3, simulated {wanted['removed_mm3']:.2f} mm3")
    assert abs(part["removed_mm3"] / wanted["removed_mm3"] - 1.0) < share
    assert places(part) == places(wanted), places(part)
    for file in "part.png", "part.stl":
        assert len(open(f"{folder}/{name}/{file}", "rb").read()) > 10000, file
assert glob.glob(folder + "/bus/part-*.png"), "no pictures at intervals"
PYTHON
