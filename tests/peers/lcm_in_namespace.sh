#!/usr/bin/env bash
# The LCM stream of the daemon against LCM's own tools, in a network namespace with a loopback only.
#
# lcm-logger records what stanokd publishes on the default URL while a program runs; missing
# sequence numbers of the setpoints are counted and printed, not judged: UDP may lose under load.
# Then lcm-logplayer plays the recorder's own log file, and must hand on every event of it.
# Exit code 77 (skipped) where namespaces or LCM's tools are not to be had.
#
# usage: lcm_in_namespace.sh STANOKD STANOK MACHINE_FILE [SECONDS]   (length of the program, default 4)
set -euo pipefail

readonly needed_tools=(lcm-logger lcm-logplayer python3)
# shellcheck source=tests/peers/in_namespace.sh
source "$(dirname "${BASH_SOURCE[0]}")/in_namespace.sh"
readonly seconds=${4:-4}

summary() {
  python3 "$here/log_summary.py" "$@" || fail "$1 cannot be read"
}

# count FILE WORD: number of messages on the channels that contain WORD.
count() {
  summary "$@" | awk '$1 == "sum" { print $3 }'
}

# A line of 0.8 s and half a circle of 1.26 s, there and back.
{
  printf 'G21 G90 G17 G54\nG0 X0 Y0\nG64 P0.01\n'
  for ((k = 0; k < (seconds + 3) / 4; ++k)); do printf 'G1 X40 F3000\nG3 X0 Y0 I-20\nG1 X40\nG3 X0 Y0 I-20\n'; done
  printf 'M30\n'
} >"$folder/part.nc"

lcm-logger --quiet --lcm-url="$url" "$folder/peer.lcm" 2>"$folder/logger.err" &
logger=$!
started+=("$logger")
start_daemon

operate machine on
operate program run part.nc --wait --json
operate log status --json
operate system shutdown
wait "$daemon" || fail "the daemon ended with $?"
sleep 0.5 # lcm-logger writes to its file ten times a second
kill -INT "$logger"
wait "$logger" || true

echo "recorded by lcm-logger:"
summary "$folder/peer.lcm"
[[ $(count "$folder/peer.lcm" SETPOINT) -gt 0 ]] || fail "nothing was recorded"
printf 'setpoints: '
summary "$folder/peer.lcm" SETPOINT | tail -n 1

own=$(ls "$folder"/log/*.lcm)
echo "written by the recorder:"
summary "$own"
lcm-logplayer --speed=1000 --lcm-url="file://$folder/played.lcm?mode=w" "$own" \
  >"$folder/player.out" 2>"$folder/player.err" || fail "lcm-logplayer cannot play the log"
wanted=$(count "$own" "")
played=$(count "$folder/played.lcm" "")
echo "lcm-logplayer: $played of $wanted events of the recorder's log"
[[ $played == "$wanted" ]] || fail "lcm-logplayer lost events of a file"
