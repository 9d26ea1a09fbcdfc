#!/usr/bin/env bash
# Odd surroundings: another language and time zone, no privileges, a wall clock that jumps by days, a client
# that dies while it jogs, a stop of the process for a few milliseconds, too little memory for a program.
#
# A locale with a decimal comma is made by localedef (package locales) where that is there.
#
# usage: surroundings_test.sh STANOKD STANOK MACHINE_FILE JUMPING_CLOCK
set -euo pipefail
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"
readonly jumping_clock=$4

printf 'G21 G90 G17 G54\nG1 X20.5 F6000\nM30\n' >"$folder/short.nc"
printf 'G21 G90 G17 G54\nG1 X400 F600\nM30\n' >"$folder/long.nc"

# is_sanitized: its run-time library wants to be the first one, and all of the address space.
is_sanitized() {
  grep -qaE '__(asan|tsan)_init' "$stanokd"  # clang links it into the program, g++ beside it
}

mkdir "$folder/locales"
if localedef --inputfile de_DE --charmap UTF-8 "$folder/locales/de_DE.UTF-8" 2>"$folder/localedef.err"; then
  export LOCPATH=$folder/locales
  locale=de_DE.UTF-8
else
  echo "no locale with a decimal comma: $(cat "$folder/localedef.err")"
  locale=C
fi

# The same bits whatever locale and time zone say.
"$2" simulate "$folder/short.nc" --machine "$machine_file" --axis-trace "1=$folder/plain.csv" >/dev/null
LC_ALL=$locale TZ=Pacific/Chatham "$2" simulate "$folder/short.nc" --machine "$machine_file" \
  --axis-trace "1=$folder/odd.csv" >/dev/null
cmp "$folder/plain.csv" "$folder/odd.csv" || fail "the trace depends on the locale"

# A whole life of the daemon under them, with a wall clock that goes back and forth by a day at each look.
export LC_ALL=$locale TZ=Pacific/Chatham
if is_sanitized; then start_daemon; else LD_PRELOAD=$jumping_clock start_daemon; fi
switch_on
run_through short.nc
expect_exit 0 channel status --json
expect_output '"X":20.5' "numbers have points"

# A stop of 5 ms, five cycles: counted, nothing else.
count_skipped() {
  expect_exit 0 machine status --json
  [[ $output =~ '"periods_skipped":'([0-9]+) ]] || fail "no count of periods in $output"
  skipped=${BASH_REMATCH[1]}
}
expect_exit 0 program run long.nc
wait_for '"line":2,'
count_skipped
before=$skipped
kill -STOP "$daemon"
sleep 0.005
kill -CONT "$daemon"
for ((k = 0; k < 100; ++k)); do # figures are at most 100 ms old
  count_skipped
  ((skipped >= before + 3)) && break
  sleep 0.05
done
((skipped >= before + 3)) || fail "a stop of 5 ms is not counted: $skipped, $before before"
wait_for '"program_status":"Running"'
expect_exit 0 program stop

# start_jog: X is moving, at the hand of the process $client.
start_jog() {
  expect_exit 0 channel status --json
  before=$(positions)
  "${operate[@]}" jog X --velocity 5 >/dev/null 2>&1 &
  client=$!
  for ((k = 0; k < 200; ++k)); do
    expect_exit 0 channel status --json
    [[ $(positions) != "$before" ]] && return
    sleep 0.05
  done
  fail "the jog does not move its axis"
}

# A client that dies while it jogs.
start_jog
kill -KILL "$client"
wait "$client" 2>/dev/null || true
sleep 0.5
expect_exit 0 channel status --json
position=$(positions)
sleep 0.3
expect_exit 0 channel status --json
[[ $position == "$(positions)" ]] || fail "the axis still moves without its client"
expect_exit 0 system shutdown
expect_end 0
unset LC_ALL LOCPATH TZ

# Where umask lets others write, what the daemon makes does not.
umask_before=$(umask)
umask 000
rm -r "$folder/state"
start_daemon --log "$folder/logs"
umask "$umask_before"
expect_exit 0 system shutdown
expect_end 0
found=$(find "$folder/state" "$folder/logs" -perm /022)
[[ -z $found ]] || fail "others may write: $found"

# A program that the memory does not hold is refused; the next one runs.
if ! is_sanitized; then
  head -c 90m < <(yes '; a line of a comment that is as long as lines of comments are, again and again') \
    >"$folder/large.nc"
  start_daemon
  switch_on
  address_space=$(awk '$1 == "VmSize:" { print $2 * 1024 }' "/proc/$daemon/status")
  prlimit --pid "$daemon" --as=$((address_space + 40 * 1024 * 1024))
  expect_exit 6 program load large.nc
  grep -q E8002 "$folder/stanok.err" || fail "a program without memory for it: $(cat "$folder/stanok.err")"
  run_through short.nc
  expect_exit 0 system shutdown
  expect_end 0
fi

# Memory that ends where no program is to blame: feed hold, drives off, and an end that says so.
if ! is_sanitized; then
  # Of all texts of a megabyte, as long as one may be, the one that takes most memory to read: some 100 MB.
  { printf 'tool = [' && head -c 990000 < <(yes '{},' | tr -d '\n') && printf ']\n'; } >"$folder/large.toml"
  start_daemon
  switch_on
  start_jog # a table is not read at all while a program runs
  # Of what may be written to, not of addresses: each thread has some of those in reserve.
  prlimit --pid "$daemon" --data="$(awk '$1 == "VmData:" { print $2 * 1024 }' "/proc/$daemon/status")"
  "${operate[@]}" tool load "$folder/large.toml" >/dev/null 2>&1 || true # it has no answer to give
  expect_end 7
  wait "$client" 2>/dev/null || true
  grep -q 'bad_alloc; the machine is stopped' "$folder/stanokd.err" || fail "the end does not say why"
  grep -q 'feed hold, then drives off' "$folder/stanokd.err" || fail "the end is not an orderly one"
fi

# Without any privilege: it runs, and says once what it has not got.
plain=()
if [[ $(id -u) == 0 ]]; then
  plain=(setpriv --reuid 65534 --regid 65534 --clear-groups --inh-caps=-all --bounding-set=-all)
  chmod 777 "$folder"
fi
: >"$folder/stanokd.err"
"${plain[@]}" prlimit --rtprio=0 "$stanokd" --machine "$machine_file" --drives embedded --lcm off \
  --state "$folder/other" --socket "$folder/op.sock" --program-root "$folder" 2>>"$folder/stanokd.err" &
daemon=$!
for ((k = 0; k < 200; ++k)); do
  "${operate[@]}" system info >/dev/null 2>&1 && break
  sleep 0.05
done
switch_on
run_through short.nc
[[ $(grep -c 'no FIFO scheduling' "$folder/stanokd.err") == 1 ]] || fail "the missing right is not told, or not once"
expect_exit 0 machine status --json
expect_output 'no FIFO scheduling' "the status"
expect_exit 0 system shutdown
expect_end 0
echo "surroundings: passed"
