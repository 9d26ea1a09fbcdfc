#!/usr/bin/env bash
# System calls of a save that fail, and kills at each of them, injected by strace: the daemon goes on, tries
# again, and what a restart finds is the old state or the new one, never half of it.
# Exit code 77 (skipped) where strace is not there or may not trace.
#
# usage: injected_faults_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail

command -v strace >/dev/null || {
  echo "skipped: strace is not installed"
  exit 77
}
strace -qq -o /dev/null -e inject=fsync:error=EIO true 2>/dev/null || {
  echo "skipped: strace may not trace processes here"
  exit 77
}
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"

tables=$folder/state/tables.toml
# The search for leaks at the end of a sanitized daemon does not work in a process that is traced.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0

# A tracer that is killed leaves what it traced running.
stop_traced() {
  if [[ -n $daemon ]]; then
    local traced
    for traced in $(pgrep -P "$daemon"); do kill -KILL "$traced" 2>/dev/null || true; done
  fi
  stop_daemon
}
trap stop_traced EXIT
value=1

# start_traced FILE CALL FAULT: the daemon under strace, which makes the call fail once at this file.
start_traced() {
  local k filter=(--seccomp-bpf)       # faster: the other calls are not looked at
  [[ $3 == signal=* ]] && filter=()    # signals are injected without it only
  strace -f "${filter[@]}" -qq -o "$folder/trace" -P "$1" -e trace=openat,write,fsync,unlink,link,rename \
    -e "inject=$2:$3:when=1" "$stanokd" --machine "$machine_file" --drives embedded --lcm off \
    --state "$folder/state" --socket "$folder/op.sock" --program-root "$folder" 2>>"$folder/stanokd.err" &
  daemon=$!
  for ((k = 0; k < 600; ++k)); do
    "${operate[@]}" system info >/dev/null 2>&1 && return
    # At the start the folder is synchronised for the queue.
    [[ $3 != signal=* ]] || kill -0 "$daemon" 2>/dev/null || return 0
    sleep 0.05
  done
  fail "the traced daemon does not answer"
}

# await_kept VALUE
await_kept() {
  local k
  for ((k = 0; k < 1200; ++k)); do # a minute: strace is slow on a loaded computer
    grep -q "X = $1.0" "$tables" 2>/dev/null && return
    sleep 0.05
  done
  fail "$2: $1 was not kept: $(cat "$tables")"
}

# expect_kept OLD NEW WHAT: after a restart it is one of the two.
expect_kept() {
  start_daemon
  expect_exit 0 offset list --json
  [[ $output == *"\"X\":$1.0"* || $output == *"\"X\":$2.0"* ]] || fail "$3: neither $1 nor $2 in $output"
  value=$(grep -o '"X":[0-9]*' <<<"$output" | head -n 1 | grep -o '[0-9]*$')
  expect_exit 0 system shutdown
  expect_end 0
}

start_daemon
expect_exit 0 offset set G54 X 1
await_kept 1 "at first"
expect_exit 0 system shutdown
expect_end 0

# The calls of a save, in their order, with the file that each concerns.
calls=("$tables.new openat" "$tables.new write" "$tables.new fsync" "$tables.link unlink" "$tables.link link"
  "$tables.link rename" "$tables.new rename" "$folder/state openat" "$folder/state fsync")

# A call that fails once: who changed it is told, unless it was kept all the same; tried again, kept.
expect_retry() {
  local told
  start_traced "$@"
  told=$("${operate[@]}" offset set G54 X $((value + 1)) 2>&1) || [[ $told == *E9025* ]] || fail "$*: $told"
  await_kept $((value + 1)) "$*"
  expect_exit 0 system shutdown
  expect_end 0
  grep -q INJECTED "$folder/trace" || fail "$* was never injected: $(cat "$folder/trace")"
  expect_kept $((value + 1)) $((value + 1)) "$*"
}
for call in "${calls[@]}"; do
  # shellcheck disable=SC2086 # a file and a call
  expect_retry $call error=EIO
done
expect_retry "$tables.new" openat error=EROFS
expect_retry "$tables.new" write error=ENOSPC
expect_retry "$tables.new" write error=EINTR
expect_retry "$tables.new" write retval=0

# Killed at each of them.
for call in "${calls[@]}"; do
  # shellcheck disable=SC2086 # a file and a call
  start_traced $call signal=KILL
  "${operate[@]}" offset set G54 X $((value + 1)) >/dev/null 2>&1 || true # it dies before the answer
  for ((k = 0; k < 200; ++k)); do
    kill -0 "$daemon" 2>/dev/null || break
    sleep 0.05
  done
  ((k < 200)) || fail "$call: not killed: $(cat "$folder/trace")"
  code=0
  wait "$daemon" || code=$?
  daemon=
  [[ $code == 137 ]] || fail "$call: not killed but ended with $code: $(cat "$folder/trace")"
  expect_kept "$value" $((value + 1)) "kill at $call"
done

# A file that is there and cannot be opened is not taken for one that is missing.
expect_exit_of_daemon() {
  local code=0
  timeout 20 strace -f --seccomp-bpf -qq -o /dev/null -P "$tables" -P "$tables.previous" -e trace=openat \
    -e inject=openat:error=EIO "$stanokd" --machine "$machine_file" --drives embedded --lcm off \
    --state "$folder/state" --socket "$folder/op.sock" --program-root "$folder" 2>"$folder/refusal" || code=$?
  [[ $code == "$1" ]] || fail "tables that cannot be opened: $code: $(cat "$folder/refusal")"
}
expect_exit_of_daemon 1
grep -q 'Input/output error' "$folder/refusal" || fail "no reason: $(cat "$folder/refusal")"
echo "injected faults: passed"
