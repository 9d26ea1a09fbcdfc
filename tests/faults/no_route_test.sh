#!/usr/bin/env bash
# No network, in a network namespace: without a multicast route the daemon publishes nothing and says so, a
# route that is taken away in a run costs messages, which are counted. The machine works all the same.
# Exit code 77 (skipped) where network namespaces are not to be had.
#
# usage: no_route_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail

skip() {
  echo "skipped: $1"
  exit 77
}
if [[ ${STANOK_IN_NAMESPACE:-no} == no ]]; then
  command -v ip >/dev/null || skip "ip is not installed"
  enter=(unshare --net)
  "${enter[@]}" true 2>/dev/null || enter=(unshare --map-root-user --net)
  "${enter[@]}" true 2>/dev/null || skip "no network namespace"
  STANOK_IN_NAMESPACE=yes exec "${enter[@]}" "$0" "$@"
fi
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"

lcm='udpm://239.255.76.67:7667?ttl=0'
printf 'G21 G90 G17 G53\nG1 X20 F6000\nM30\n' >"$folder/short.nc"
printf 'G21 G90 G17 G53\nG1 X400 F600\nM30\n' >"$folder/long.nc"

# count NAME: a number of `log status`.
count() {
  expect_exit 0 log status --json
  [[ $output =~ \"$1\":([0-9]+) ]] || fail "no $1 in $output"
  echo "${BASH_REMATCH[1]}"
}

# await_more NAME THAN
await_more() {
  local k
  for ((k = 0; k < 200; ++k)); do
    (($(count "$1") > $2)) && return
    sleep 0.05
  done
  fail "$1 does not grow beyond $2: $output"
}

# From the start. The simulated drives want a loopback.
ip link set lo up multicast on || skip "the loopback of the namespace cannot be set up"
start_daemon
switch_on
run_through short.nc
[[ $(grep -c 'cannot be opened; nothing is published' "$folder/stanokd.err") == 1 ]] ||
  fail "the missing route is not told, or more than once"
expect_exit 0 log status --json
expect_output '"open":false' "LCM without a route"
[[ $(count sent) == 0 ]] || fail "something was sent without a route"

# A route that comes later.
ip route add 224.0.0.0/4 dev lo || skip "no multicast route in the namespace"
await_more sent 0
grep -q 'is open now' "$folder/stanokd.err" || fail "it is not told that LCM is open"
expect_exit 0 system shutdown
expect_end 0

# In a run.
start_daemon
switch_on
expect_exit 0 program run long.nc
await_more sent 0
lost=$(count lost)
ip route del 224.0.0.0/4 dev lo
await_more lost "$lost"
wait_for '"program_status":"Running"'
expect_exit 0 program stop
expect_exit 0 program reset
ip route add 224.0.0.0/4 dev lo
sent=$(count sent)
run_through short.nc
await_more sent "$sent"
expect_exit 0 system shutdown
expect_end 0
echo "no route: passed"
