#!/usr/bin/env bash
# Disks that are full or read-only, in a mount namespace with tiny file systems: the machine goes on, what
# could not be written is said, and written as soon as it can be.
# Exit code 77 (skipped) where mount namespaces are not to be had.
#
# usage: disks_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail

if [[ ${STANOK_IN_NAMESPACE:-no} == no ]]; then
  enter=(unshare --mount)
  "${enter[@]}" mount -t tmpfs none /tmp 2>/dev/null || enter=(unshare --map-root-user --mount)
  "${enter[@]}" mount -t tmpfs none /tmp 2>/dev/null || {
    echo "skipped: no mount namespace"
    exit 77
  }
  STANOK_IN_NAMESPACE=yes exec "${enter[@]}" "$0" "$@"
fi
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"

printf 'G21 G90 G17 G54\nG1 X500 F600\nM30\n' >"$folder/long.nc" # a minute
printf 'G21 G90 G17 G53\nG0 X1\nM30\n' >"$folder/short.nc"
mkdir "$folder/log" "$folder/state"
leave_disks() {
  umount --lazy "$folder"/{log,state,programs} 2>/dev/null || true
  stop_daemon
}
trap leave_disks EXIT
mount -t tmpfs -o size=3m none "$folder/log"
mount -t tmpfs -o size=64k none "$folder/state"

# await_line TEXT: until the daemon has said so.
await_line() {
  local k
  for ((k = 0; k < 200; ++k)); do
    grep -q "$1" "$folder/stanokd.err" && return
    sleep 0.05
  done
  fail "the daemon never said: $1"
}

# Its own disk is all that the log may fill here: nothing of it has to stay free.
printf '\n[recorder]\nfree_space_min_gb = 0\n' >>"$machine_file"

# The log fills its disk: logging stops and says so, motion goes on.
start_daemon --log "$folder/log"
switch_on
expect_exit 0 program run long.nc
await_line 'logging has stopped'
expect_exit 0 log status --json
expect_output 'No space left on device' "a full disk of the log"
wait_for '"program_status":"Running"'
expect_exit 0 channel status --json
[[ $output =~ '"speed_mm_s":'0\.0, ]] && fail "the axes stand: $output"
expect_exit 0 program stop
# What is on the disk is read up to the cut.
code=0
"$2" log info "$folder"/log/*.lcm >"$folder/info" 2>&1 || code=$?
[[ $code == 0 || $code == 1 ]] || fail "log info of a cut log: $code"
grep -q SETPOINT "$folder/info" || fail "nothing is read from the cut log: $(cat "$folder/info")"

# The state fills its disk: who changes it is told, and the log once; tried again, kept when there is room.
head -c 1m /dev/zero >"$folder/state/filler" 2>/dev/null || true
expect_exit 1 offset set G54 X 12.5 --json
expect_output 'E9025' "a change that the disk does not keep"
expect_exit 0 offset list --json
expect_output '"X":12.5' "it is in force all the same"
await_line 'tables cannot be saved.*No space left'
run_through short.nc
rm "$folder/state/filler"
await_line 'tables are being saved again'
grep -q 'X = 12.5' "$folder/state/tables.toml" || fail "the offset was not kept"

expect_exit 0 system shutdown
expect_end 0

# Read-only from the start: refused before anything has power, with the reason.
mount -o remount,ro "$folder/state"
code=0
timeout 20 "$stanokd" --machine "$machine_file" --lcm off --drives embedded --socket "$folder/op.sock" \
  --state "$folder/state" --program-root "$folder" 2>"$folder/refusal" || code=$?
[[ $code == 1 ]] || fail "a read-only state directory: $code"
grep -q 'stanokd.lock: Read-only file system' "$folder/refusal" || fail "no reason: $(cat "$folder/refusal")"

# Programs may well be on a read-only disk.
mount -o remount,rw "$folder/state"
mkdir "$folder/programs"
cp "$folder/short.nc" "$folder/programs/fixed.nc"
mount --bind "$folder/programs" "$folder/programs"
mount -o remount,ro,bind "$folder/programs"
start_daemon
switch_on
run_through fixed.nc
expect_exit 0 system shutdown
expect_end 0
echo "disks: passed"
