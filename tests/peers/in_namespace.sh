# Sourced by the tests that let stanok multicast: the script begins again in a network namespace of its own, in
# which LCM's packets go round on the loopback and nowhere else. It needs the right to make one, as root or by
# user namespaces; without it, or without a tool, the test is skipped (exit code 77).
#
# usage of those tests: TEST STANOKD STANOK MACHINE_FILE [...]; they set needed_tools before they source this
# and find $stanokd, $stanok, $machine_file, $url of LCM and $folder, which is removed at the end.
# shellcheck shell=bash

skip() {
  echo "skipped: $1"
  exit 77
}

if [[ ${STANOK_IN_NAMESPACE:-no} == no ]]; then
  # shellcheck disable=SC2154
  for tool in unshare ip "${needed_tools[@]}"; do
    command -v "$tool" >/dev/null || skip "$tool is not installed"
  done
  enter=(unshare --net)
  "${enter[@]}" true 2>/dev/null || enter=(unshare --map-root-user --net)
  "${enter[@]}" true 2>/dev/null || skip "unshare is refused: no network namespace"
  STANOK_IN_NAMESPACE=yes exec "${enter[@]}" "$0" "$@"
fi
ip link set lo up multicast on || skip "the loopback of the namespace cannot be set up"
ip route add 224.0.0.0/4 dev lo || skip "no multicast route in the namespace"

here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=tests/support/patient_machine.sh
source "$here/../support/patient_machine.sh"
readonly here stanokd=$1 stanok=$2
readonly url='udpm://239.255.76.67:7667?ttl=0'
folder=$(mktemp -d)
machine_file=$(patient_machine "$3" "$folder")
readonly folder machine_file
started=()

end_all() {
  for pid in "${started[@]}"; do kill -KILL "$pid" 2>/dev/null || true; done
  rm -rf "$folder"
}
trap end_all EXIT

fail() {
  cat "$folder"/*.err >&2
  printf 'FAILED: %s\n' "$1" >&2
  exit 1
}

operate() {
  "$stanok" --socket "$folder/op.sock" "$@" || fail "stanok $*"
}

# start_daemon: one that publishes and writes a log to $folder/log; its pid goes to $daemon.
start_daemon() {
  "$stanokd" --machine "$machine_file" --drives embedded --lcm "$url" --state "$folder/state" \
    --socket "$folder/op.sock" --program-root "$folder" --log "$folder/log" 2>"$folder/stanokd.err" &
  daemon=$!
  started+=("$daemon")
  local k
  for ((k = 0; k < 600; ++k)); do
    [[ -S $folder/op.sock ]] && return
    kill -0 "$daemon" 2>/dev/null || fail "the daemon did not start"
    sleep 0.05
  done
}
