#!/usr/bin/env bash
# Damaged files in the state directory: the copy before is used and told; without one, and for files of
# a newer version, the daemon does not start, says what to do, and leaves the file alone.
#
# usage: damaged_state_test.sh STANOKD STANOK MACHINE_FILE
set -euo pipefail
# shellcheck source=tests/daemon/running_daemon.sh disable=SC2119
source "$(dirname "${BASH_SOURCE[0]}")/../daemon/running_daemon.sh"

tables=$folder/state/tables.toml

# keep OFFSET: a life of the daemon in which an offset is set.
keep() {
  start_daemon
  expect_exit 0 offset set G54 X "$1"
  expect_exit 0 system shutdown
  expect_end 0
}
keep 1.5
keep 2.5
cp -a "$folder/state" "$folder/sound"

# Damages of the file: each a command that gets its name.
cut_short() { truncate -s 100 "$1"; }
make_empty() { : >"$1"; }
fill_with_garbage() { head -c 4096 /dev/urandom >"$1"; }
flip_a_value() { sed -i 's/^X = .*/X = 99.5/' "$1"; }
take_away() { rm "$1"; }
make_newer() { sed -i '1s/tables [0-9]*/tables 99/' "$1"; }

# Of the newest copy alone: the one before is used.
for damage in cut_short make_empty fill_with_garbage flip_a_value take_away; do
  rm -rf "$folder/state"
  cp -a "$folder/sound" "$folder/state"
  "$damage" "$tables"
  start_daemon
  expect_exit 0 offset list --json
  expect_output '"X":1.5' "$damage: the copy before"
  grep -q 'its previous copy is used' "$folder/stanokd.err" || fail "$damage is not told"
  expect_exit 0 system shutdown
  expect_end 0
  : >"$folder/stanokd.err"
done

# expect_refusal TEXT: the daemon does not start, says so, and changes nothing.
expect_refusal() {
  local code=0 before
  before=$(md5sum "$folder"/state/tables.toml*)
  timeout 20 "$stanokd" --machine "$machine_file" --lcm off --drives embedded --socket "$folder/op.sock" \
    --state "$folder/state" --program-root "$folder" 2>"$folder/refusal" || code=$?
  [[ $code == 1 ]] || fail "$2: $code"
  grep -q "$1" "$folder/refusal" || fail "$2: $(cat "$folder/refusal")"
  [[ $(md5sum "$folder"/state/tables.toml*) == "$before" ]] || fail "$2: the file was changed"
}
for damage in cut_short make_empty fill_with_garbage flip_a_value; do
  rm -rf "$folder/state"
  cp -a "$folder/sound" "$folder/state"
  "$damage" "$tables"
  "$damage" "$tables.previous"
  expect_refusal 'restore it, or move it away' "both copies: $damage"
done
rm -rf "$folder/state"
cp -a "$folder/sound" "$folder/state"
make_newer "$tables"
expect_refusal 'newer than this stanok supports' "a newer version"
echo "damaged state: passed"
