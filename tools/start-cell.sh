# shellcheck shell=bash
# Sourced by ./start for --cell: three simulated machines, a broker, the gateway with a history, and a page of all.
#
# Everything is on loopback and in build/cell, and ends with this script. What `start` gives: say, fail, $bin.
# shellcheck disable=SC2154  # jobs comes from tools/environment.sh, bin from start
readonly cell=build/cell
readonly cell_machines=(mill lathe trunnion)
declare -rA cell_configuration=([mill]=mill3 [lathe]=lathe [trunnion]=trunnion)
declare -rA cell_program=([mill]=square_and_circle.nc [lathe]=lathe.nc [trunnion]=trunnion.nc)
declare -A cell_runs=([mill]=0 [lathe]=0 [trunnion]=0)
readonly cell_faulty=beyond.nc  # every third run of the mill: what an alarm looks like
cell_processes=()

end_cell() {
  local pid
  for pid in ${cell_processes[@]+"${cell_processes[@]}"}; do kill -TERM "$pid" 2>/dev/null || true; done
  for pid in ${cell_processes[@]+"${cell_processes[@]}"}; do wait "$pid" 2>/dev/null || true; done
  cell_processes=()
}

cell_operator() {
  local member="$1"
  shift
  "$bin/stanok" --socket "$cell/$member.sock" "$@"
}

# begin NAME COMMAND...: in the background, its log in $cell/NAME.log.
begin() {
  local name="$1"
  shift
  "$@" >"$cell/$name.log" 2>&1 &
  cell_processes+=("$!")
}

# wait_for NAME CONDITION...: until it holds, while the last process that was begun lives.
wait_for() {
  local name="$1"
  shift
  for _ in {1..200}; do
    "$@" >/dev/null 2>&1 && return 0
    kill -0 "${cell_processes[-1]}" 2>/dev/null || break
    sleep 0.1
  done
  tail -n 20 "$cell/$name.log" >&2
  fail "$name does not answer"
}

answers() { (: <"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }

start_broker() {
  local program
  program="$(command -v mosquitto || echo /usr/sbin/mosquitto)"
  [[ -x "$program" ]] || fail "mosquitto is not installed: apt install mosquitto"
  for broker_port in 1883 11883 21883 31883; do answers "$broker_port" || break; done
  cat >"$cell/mosquitto.conf" <<TEXT
listener $broker_port 127.0.0.1
allow_anonymous true
persistence false
TEXT
  begin mosquitto "$program" -c "$cell/mosquitto.conf"
  wait_for mosquitto answers "$broker_port"
}

start_machine() {
  local member="$1"
  mkdir -p "$cell/programs/$member"
  cp "programs/examples/${cell_program[$member]}" "$cell/programs/$member/"
  printf 'G1 X0 F3000\nX100000\nM30\n' >"$cell/programs/$member/$cell_faulty"
  begin "$member" "$bin/stanokd" --machine "config/machines/${cell_configuration[$member]}.toml" --drives embedded \
    --lcm off --socket "$cell/$member.sock" --state "$cell/state-$member" --program-root "$cell/programs/$member"
  wait_for "$member" cell_operator "$member" system info
  cell_operator "$member" machine on >/dev/null
}

# One page shows all machines.
start_cell_page() {
  local member sockets=()
  for member in "${cell_machines[@]}"; do sockets+=(--socket "$cell/$member.sock"); done
  "$bin/stanok-web" --listen 127.0.0.1:0 "${sockets[@]}" --history "$cell/gateway/history.sqlite" \
    >"$cell/page.address" 2>"$cell/page.log" &
  cell_processes+=("$!")
  wait_for page test -s "$cell/page.address"
}

say_what_to_look_at() {
  say "What to look at, each in its own terminal"
  cat <<TEXT
page        $("$bin/stanok" panel --socket "$cell/mill.sock" --no-open 2>/dev/null)   (valid once: $bin/stanok panel --socket $cell/mill.sock prints another)
            its view "Cell" shows the three machines and their history
messages    mosquitto_sub -p $broker_port -t 'cell/#' -v
history     $bin/stanok history oee --since 1h --database $cell/gateway/history.sqlite
            also runs, alarms, tools, drift
a machine   $bin/stanok --socket $cell/mill.sock watch
OPC UA      node opcua/stanok-opcua.js --daemon mill=$cell/mill.sock --port 0    (docs/integrator/opc-ua.md)
logs        $cell/*.log
TEXT
}

# next_run MACHINE: begins its program when nothing runs; an alarm is there to be seen until the next look.
next_run() {
  local member="$1" status program="${cell_program[$1]}"
  status="$(cell_operator "$member" channel status --channel 1 --json 2>/dev/null)" || return 0
  case "$status" in
    *'"program_status":"Canceled"'*) cell_operator "$member" program reset >/dev/null 2>&1 || true ;;
    *'"program_status":"Stopped"'*)
      if [[ "$member" == mill ]] && ((cell_runs[mill] % 3 == 2)); then program="$cell_faulty"; fi
      cell_runs[$member]=$((cell_runs[$member] + 1))
      cell_operator "$member" program run "$program" --channel 1 --no-wait >/dev/null 2>&1 || true
      ;;
  esac
}

run_cell_until_interrupted() {
  local member pid stopped=no
  say "The machines work until Ctrl-C"
  trap 'stopped=yes' INT TERM
  while [[ $stopped == no ]]; do
    for member in "${cell_machines[@]}"; do next_run "$member"; done
    for pid in "${cell_processes[@]}"; do
      kill -0 "$pid" 2>/dev/null || [[ $stopped == yes ]] || fail "a process has ended; see $cell/*.log"
    done
    sleep 2 &
    wait $! || true
  done
  trap - INT TERM
}

run_cell() {
  local member named=()
  rm -rf "$cell"
  mkdir -p "$cell"
  trap end_cell EXIT
  say "Starting three machines, broker, gateway and page"
  start_broker
  for member in "${cell_machines[@]}"; do
    start_machine "$member"
    named+=(--daemon "$member=$cell/$member.sock")
  done
  begin gateway "$bin/stanok-gateway" "${named[@]}" --broker "127.0.0.1:$broker_port" --topic cell --state "$cell/gateway"
  wait_for gateway test -s "$cell/gateway/history.sqlite"
  start_cell_page
  say_what_to_look_at
  run_cell_until_interrupted
  end_cell
  say "Summary of the history"
  "$bin/stanok" history oee --since 1h --database "$cell/gateway/history.sqlite"
  echo "Everything has ended; logs and history remain in $cell."
}
