#!/usr/bin/env bash
# A library of generated programs, checked one after the other and by a cluster under Slurm of two
# computers of which one is lost in between: the results are the same, byte for byte, but for wall
# times. Then what goes wrong: a batch that is cancelled, tasks that somebody ends, a machine file
# that is not the one any more.
#
# usage: batch_on_slurm_test.sh STANOK GENERATE_PROGRAMS SOURCE_FOLDER PROGRAMS CHUNK
set -euo pipefail

# shellcheck source=tests/support/slurm_cluster.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/slurm_cluster.sh"
readonly stanok=$1 generate_programs=$2 source_folder=$3 programs=$4 chunk=$5
readonly library=$folder/library machine=$folder/mill3.toml

# A step of the test, with the seconds since its beginning.
now_ms() { echo $((${EPOCHREALTIME/./} / 1000)); }
seconds_since() {
  local -r ms=$(($(now_ms) - $1))
  printf '%d.%03d' $((ms / 1000)) $((ms % 1000))
}
say() { printf '%8s s  %s\n' "$(seconds_since "$begin")" "$1"; }
begin=$(now_ms)
readonly begin

without_times() { sed -E 's/"seconds":[-+.0-9e]+/"seconds":0/g' "$1"; }
same_as_serial() {
  cmp <(without_times "$folder/serial.json") <(without_times "$1") ||
    fail "$1 is not what one process gives"
}
# expect_code CODE COMMAND...
expect_code() {
  local -r wanted=$1
  local code=0
  shift
  "$@" || code=$?
  [[ $code == "$wanted" ]] || fail "exit code $code instead of $wanted: $*"
}
submit() {
  local -r work=$1
  shift
  "$stanok" batch submit "$library" --machine "$machine" --work "$work" --chunk "$chunk" \
    --engine slurm "$@" >>"$folder/stanok.log" || fail "batch submit to $work"
}
state() { "$stanok" batch status "$1" --json 2>>"$folder/stanok.err" || true; }
number_of() { state "$1" | python3 -c 'import json, sys; print(json.load(sys.stdin)[sys.argv[1]])' "$2"; }
is_past_first_chunk_on_n2() {
  (($(number_of "$1" "done") >= 1)) && [[ -n $(squeue --noheader --states=RUNNING --nodelist=n2) ]]
}

has_no_task() { [[ $(number_of "$1" pending) == 0 ]]; }

cp "$source_folder/config/machines/mill3.toml" "$machine"
while read -r named; do # files that the machine file names, beside it
  [[ ! -e $source_folder/config/machines/$named ]] || cp -r "$source_folder/config/machines/$named" "$folder"
done < <(grep -oE '"[^"]+\.[a-z]+"' "$machine" | tr -d '"')
mkdir "$folder/workload"
"$generate_programs" --out "$folder/workload" --scale small >/dev/null
python3 "$(dirname "$0")/generated_library.py" "$folder/workload/0003_MB_3D.nc" "$library" "$programs"
start_cluster
say "the cluster is up"

serial_begin=$(now_ms)
expect_code 6 "$stanok" check "$library" --machine "$machine" --json >"$folder/serial.json" 2>"$folder/serial.err"
say "$programs programs checked one after the other in $(seconds_since "$serial_begin") s"

# Its task is there when it is lost, however fast the other computer is.
hold_computer n2
cluster_begin=$(now_ms)
submit "$folder/work"
wait_until "a chunk is done and n2 works" is_past_first_chunk_on_n2 "$folder/work"
end_computer n2
release_computer n2
say "n2 is lost after $(number_of "$folder/work" "done") of $(number_of "$folder/work" chunks) chunks"
expect_code 1 "$stanok" batch results "$folder/work" --json >/dev/null 2>>"$folder/stanok.err"
expect_code 0 "$stanok" batch status "$folder/work" --wait >>"$folder/stanok.log" 2>>"$folder/stanok.err"
say "done by the cluster in $(seconds_since "$cluster_begin") s"
expect_code 6 "$stanok" batch results "$folder/work" --json >"$folder/cluster.json"
same_as_serial "$folder/cluster.json"
say "the results are the same"

grep -qi "requeue" "$folder/controller.log" || fail "no task was begun again after the loss of n2"
start_computer n2
wait_until "both computers are idle again" idle_computers 2

# Cancelled before it began, and gone on with.
submit "$folder/cancelled" --sbatch=--hold
[[ $(number_of "$folder/cancelled" pending) == "$(number_of "$folder/cancelled" chunks)" ]] ||
  fail "not every chunk of a held batch waits"
"$stanok" batch cancel "$folder/cancelled" >>"$folder/stanok.log" || fail "batch cancel"
wait_until "no task is left" has_no_task "$folder/cancelled"
expect_code 1 "$stanok" batch status "$folder/cancelled" >>"$folder/stanok.log"
say "a batch is cancelled"

# A machine file that is another one when the tasks begin: no result, and why.
submit "$folder/changed" --sbatch=--hold
printf '\n# changed\n' >>"$machine"
scontrol release "$(squeue --noheader --format=%F | sort -u | head -n 1)"
expect_code 1 "$stanok" batch status "$folder/changed" --wait >"$folder/changed.log" 2>&1
grep -q "are not those that the batch was submitted with" "$folder/changed.log" ||
  fail "nobody is told of the changed machine file"
say "a changed machine file is told of"

expect_code 1 env SLURM_CONF=/dev/null "$stanok" batch submit --work "$folder/cancelled" --engine slurm \
  2>"$folder/no_cluster.log"
grep -q "sinfo" "$folder/no_cluster.log" || fail "no remedy where the cluster does not answer"
expect_code 1 env PATH=/nowhere "$stanok" batch submit --work "$folder/cancelled" --engine slurm \
  2>"$folder/no_slurm.log"
grep -q "slurm-client" "$folder/no_slurm.log" || fail "no remedy where Slurm is not installed"
say "the end"
