# Sourced by tests of the whole daemon. A computer that runs other tests beside may let the drives inside the
# daemon wait longer than a machine would: they would count as lost (A3001), which is right on a machine and
# not what those tests ask.
# shellcheck shell=bash

# patient_machine MACHINE_FILE FOLDER: a copy of the machine file, with what belongs to it, in FOLDER/machine,
# that waits 30 s for its drives and takes commands that are 30 s old. Prints its path.
patient_machine() {
  local copy=$2/machine/${1##*/} belongings=${1%.toml}
  mkdir -p "$2/machine"
  cp "$1" "$copy"
  if [[ -d $belongings ]]; then cp -r "$belongings" "$2/machine/"; fi
  sed -i '/^timeout_ms = /d' "$copy"
  grep -q '^\[drives\]' "$copy" || printf '\n[drives]\nbus = "modbus-tcp"\n' >>"$copy"
  sed -i 's/^\[drives\]$/&\ntimeout_ms = 30000/; s/^\[machine\]$/&\nrequest_age_max = 30/' "$copy"
  printf '%s\n' "$copy"
}
