#!/usr/bin/env bash
# The commands of docs/tutorial/first-job.md, run as they stand.
#
# usage: first_job_test.sh FOLDER_OF_PROGRAMS SOURCE_FOLDER
set -euo pipefail
readonly programs=$1 source=$2
# shellcheck source=tests/support/patient_machine.sh
source "$source/tests/support/patient_machine.sh"
folder=$(mktemp -d)
daemon_of() { cat "$folder/state/stanokd.lock" 2>/dev/null || true; }
finish() {
  local pid
  pid=$(daemon_of)
  if [[ -n $pid ]]; then kill -KILL "$pid" 2>/dev/null || true; fi
  rm -rf "$folder"
}
trap finish EXIT

{
  echo 'set -euo pipefail'
  # shellcheck disable=SC2016
  sed -n '/^```sh$/,/^```$/p' "$source/docs/tutorial/first-job.md" | sed '/^```/d'
} >"$folder/walk.sh"
for machine in "$source"/config/machines/*.toml; do patient_machine "$machine" "$folder" >/dev/null; done
export PATH="$programs:$PATH" MACHINES="$folder/machine"
if ! (cd "$folder" && timeout 280 bash walk.sh >walk.log 2>&1); then
  echo "FAILED: $(tail -n 30 "$folder/walk.log")" >&2
  exit 1
fi
grep -q 'are the same, bit for bit' "$folder/walk.log" || {
  echo "FAILED: nothing was verified: $(cat "$folder/walk.log")" >&2
  exit 1
}
[[ -n $(find "$folder/pictures" -name '*.png') ]] || {
  echo "FAILED: no pictures" >&2
  exit 1
}
if [[ -n ${STANOK_SHOW:-} ]]; then cat "$folder/walk.log"; fi
echo "first job: passed"
