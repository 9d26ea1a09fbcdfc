#!/usr/bin/env bash
# The drive side against peers that know nothing of stanok: mbpoll and pymodbus as clients of
# stanok-drives over TCP and over a serial line, and stanokd against a pymodbus server that has the
# register maps of docs/integrator/drives.md.
#
# usage: acceptance.sh STANOK_DRIVES STANOKD STANOK SOURCE_FOLDER
# Exit code 77 (skipped) where mbpoll or pymodbus is not installed.
set -euo pipefail

skip() {
  echo "skipped: $1"
  exit 77
}

command -v mbpoll >/dev/null || skip "mbpoll is not installed"
python=''
for candidate in python3 /usr/bin/python3; do
  if "$candidate" -c 'import pymodbus' 2>/dev/null; then python=$candidate && break; fi
done
[[ -n $python ]] || skip "pymodbus is not installed (python3-pymodbus)"

readonly stanok_drives=$1 stanokd=$2 stanok=$3 source=$4 python
here=$(dirname "${BASH_SOURCE[0]}")
folder=$(mktemp -d)
readonly here folder
started=()

end_all() {
  for pid in "${started[@]}"; do
    kill -KILL "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
  done
  rm -rf "$folder"
}
trap end_all EXIT

fail() {
  echo "failed: $1" >&2
  exit 1
}

# until_true SECONDS COMMAND...
until_true() {
  local tries=$(($1 * 20))
  shift
  for ((k = 0; k < tries; ++k)); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.05
  done
  return 1
}

# Simulated drives of the machine file; their port in $port.
"$stanok_drives" --machine "$source/config/machines/e7106mf4.toml" --json >"$folder/units.json" &
started+=($!)
until_true 60 grep -q port "$folder/units.json" || fail "stanok-drives does not say its port"
port=$(grep -o '"port":[0-9]*' "$folder/units.json" | cut -d: -f2)
readonly port

# mbpoll UNIT REGISTER COUNT [VALUE...]
registers() {
  local unit=$1 first=$2 count=$3
  shift 3
  if (($# > 0)); then
    mbpoll -m tcp -p "$port" -a "$unit" -0 -r "$first" -1 -q 127.0.0.1 "$@"
  else
    mbpoll -m tcp -p "$port" -a "$unit" -0 -r "$first" -c "$count" -1 -q 127.0.0.1
  fi
}

grep -q '^\[100\]' <<<"$(registers 1 100 17)" || fail "mbpoll cannot read the status block"
registers 247 1 1 6 >/dev/null || fail "mbpoll cannot inject a fault" # the second drive trips
[[ "$(registers 2 110 1)" == *8976* ]] || fail "no over-current fault (2310h)"
echo "mbpoll: reads the status block, makes a drive trip, reads its fault code"

"$python" "$here/client.py" tcp "$port" || fail "pymodbus over TCP"

# The same over a serial line: two pseudo terminals, joined.
"$python" "$here/cable.py" "$folder/one" "$folder/other" &
started+=($!)
until_true 60 test -e "$folder/other" || fail "no pseudo terminals"
"$stanok_drives" --machine "$source/config/machines/e7106mf4.toml" --rtu "$folder/one" >"$folder/rtu.txt" &
started+=($!)
until_true 60 grep -q '^line' "$folder/rtu.txt" || fail "stanok-drives does not serve the line"
"$python" "$here/client.py" rtu "$folder/other" || fail "pymodbus over RTU"

# stanokd with real drives, which are a pymodbus server with the maps of the document.
operate() { "$stanok" --socket "$folder/op.sock" "$@"; }

all_in_contact() { operate drive status --json | "$python" -c 'import json, sys
axes = json.load(sys.stdin)["axes"]
sys.exit(0 if len(axes) == 3 and all(axis["in_contact"] for axis in axes) else 1)'; }

ended() { [[ "$(operate program history --json)" == *'"ended":true'* ]]; }

# sees TEXT: the server has said so, in $seen.
sees() { grep -q "$1" "$seen"; }

# run_on_peer NAME [DEVICE]: a program on the machine in $folder/machine.toml, whose drives are the server.
run_on_peer() {
  seen="$folder/$1.txt"
  local daemon
  until_true 60 test -s "$folder/ready" || fail "no pymodbus server: $(cat "$seen")"
  "$stanok" machine check "$folder/machine.toml" >/dev/null || fail "the machine of the document is refused"
  # It rests until the server has seen the spindle and the coil: how long that takes is the line's and the computer's.
  printf 'M3 S1500\nG1 X10 Y-0 F1200\nM64 P0\nM0\nM65 P0\nM5\nM30\n' >"$folder/part.nc"
  "$stanokd" --machine "$folder/machine.toml" --drives real --lcm off --state "$folder/state-$1" \
    --socket "$folder/op.sock" --program-root "$folder" 2>"$folder/stanokd.txt" &
  daemon=$!
  started+=("$daemon")
  until_true 60 all_in_contact || fail "no contact with all drives: $(operate drive status)"
  operate machine on >/dev/null || fail "machine on"
  until_true 60 operate program run part.nc ||
    fail "the program does not start: $(operate program run part.nc 2>&1; operate drive status)"
  until_true 60 sees 'spindle runs at 50.00 Hz' || fail "the server does not see the spindle: $(cat "$seen")"
  until_true 60 sees 'coil 0 on' || fail "the server does not see the output: $(cat "$seen")"
  until_true 60 operate program start || fail "the program does not continue: $(operate program start 2>&1)"
  until_true 60 ended || fail "the program does not end"
  [[ "$(operate program history --json)" == *'"ok":true'* ]] || fail "the program fails: $(operate alarm history)"
  operate drive status
  operate drive status --json | "$python" -c 'import json, sys
status = json.load(sys.stdin)
axes = {axis["axis"]: axis for axis in status["axes"]}
assert abs(axes["X"]["position"] - 10.0) < 1e-3, axes["X"]
errors = status["errors"]
assert errors["mangled"] == 0 and errors["implausible"] == 0, errors
print("round trip in us:", status["round_trip_us"], "exchanges:", status["exchanges"])'
  until_true 60 sees 'spindle stopped' || fail "the spindle was not stopped: $(cat "$seen")"
  until_true 60 sees 'coil 0 off' || fail "the output was not switched off: $(cat "$seen")"
  kill -TERM "$daemon"
  wait "$daemon" || fail "the daemon ended with an error: $(cat "$folder/stanokd.txt")"
}

"$python" "$here/machine.py" "$source/docs/integrator/drives.md" "$folder" >/dev/null
"$python" "$here/server.py" "$folder/ready" >"$folder/tcp_peer.txt" 2>&1 &
started+=($!)
until_true 60 test -s "$folder/ready" || fail "no pymodbus server: $(cat "$folder/tcp_peer.txt")"
sed -i "s/^port = .*/port = $(cat "$folder/ready")/" "$folder/machine.toml"
run_on_peer tcp_peer
echo "stanokd: drives a pymodbus server with the maps of docs/integrator/drives.md over TCP"

"$python" "$here/cable.py" "$folder/daemon_end" "$folder/peer_end" &
started+=($!)
until_true 60 test -e "$folder/peer_end" || fail "no pseudo terminals"
rm "$folder/ready"
"$python" "$here/server.py" "$folder/ready" "$folder/peer_end" >"$folder/rtu_peer.txt" 2>&1 &
started+=($!)
# A serial line in Python takes its time: longer waits than over TCP.
sed -i -e '/^port = /d' -e "s|^host = .*|device = \"$folder/daemon_end\"|" -e 's/^bus = .*/bus = "modbus-rtu"/' \
  -e 's/^poll_ms = .*/poll_ms = 50/' -e 's/^timeout_ms = .*/timeout_ms = 900/' \
  -e 's/^watchdog_ms = .*/watchdog_ms = 2000/' "$folder/machine.toml"
run_on_peer rtu_peer
echo "stanokd: the same over RTU"
