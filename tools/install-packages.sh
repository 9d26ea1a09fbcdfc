#!/usr/bin/env bash
# Installs the Debian packages of the groups named (runtime, build, cell, python, test, cam, all, peer) from tools/packages.txt.
#
# Asks the package database first and touches nothing when everything is there. Else apt-get as root
# or through sudo, without questions, with retries; quiet unless it fails. Usage:
#   tools/install-packages.sh GROUP...
set -euo pipefail

list="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/packages.txt"
readonly list
export LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive

packages_of() {
  sed 's/#.*//' "$list" | awk -v group="$1" '$1 == group { print $2 }'
}

is_installed() {
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]] || is_provided "$1"
}

# Another package may bring the same: a newer nodejs has npm in it, and forbids the package npm. The
# list is read to its end: a reader that goes at its first find fails the writer, and so the pipe.
is_provided() {
  dpkg-query -W -f '${db:Status-Status} ${Provides}\n' | awk -v name="$1" '
    $1 == "installed" {
      gsub(/\([^)]*\)|,/, " ")
      for (i = 2; i <= NF; ++i) if ($i == name) found = 1
    }
    END { exit !found }'
}

as_root() {
  if ((EUID == 0)); then "$@"; else sudo -n env DEBIAN_FRONTEND=noninteractive "$@"; fi
}

# Three attempts: a mirror may be busy, and another process may hold the package database.
install_packages() {
  local -ar options=(-y -q --no-install-recommends -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600)
  local attempt
  for attempt in 1 2 3; do
    if as_root apt-get update -q && as_root apt-get install "${options[@]}" "$@"; then return 0; fi
    echo "attempt $attempt failed"
    sleep $((attempt * 5))
  done
  return 1
}

# Servers that only tests want, which start them by themselves: Debian starts them and has them started again.
leave_off() {
  local -r services="mosquitto postgresql"
  local service
  command -v systemctl >/dev/null && [[ -d /run/systemd/system ]] || return 0
  for service in $services; do
    [[ " $* " != *" $service "* ]] || as_root systemctl disable --now "$service" >/dev/null 2>&1 || true
  done
}

main() {
  if (($# == 0)); then
    echo "usage: ${0##*/} runtime|build|cell|python|test|cam|all|peer ..." >&2
    return 2
  fi
  local group package
  local -a missing=()
  for group in "$@"; do
    local packages
    packages="$(packages_of "$group")"
    if [[ -z "$packages" ]]; then
      echo "${0##*/}: there is no group '$group' in $list" >&2
      return 2
    fi
    for package in $packages; do
      is_installed "$package" || missing+=("$package")
    done
  done
  ((${#missing[@]})) || return 0

  if ((EUID != 0)) && ! sudo -n true 2>/dev/null; then
    echo "these Debian packages are missing, and installing them requires root or sudo:" >&2
    echo "  ${missing[*]}" >&2
    return 1
  fi
  local log
  log="$(mktemp)"
  echo "installing ${#missing[@]} packages: ${missing[*]}"
  if ! install_packages "${missing[@]}" >"$log" 2>&1 </dev/null; then
    tail -n 40 "$log" >&2
    echo "the packages could not be installed; full output: $log" >&2
    return 1
  fi
  rm -f "$log"
  leave_off "${missing[@]}"
}

main "$@"
