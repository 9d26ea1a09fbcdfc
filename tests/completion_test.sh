#!/usr/bin/env bash
# What bash, zsh and fish offer behind words of `stanok`. usage: completion_test.sh STANOK
#
# zsh is asked without its line editor: compadd and _files say what they were given. A shell that is
# not there is left out; 77 when only bash is there.
set -euo pipefail
PATH="$(dirname "$1"):$PATH"
export PATH
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
touch part.nc machine.toml
export STANOK_SOCKET="$folder/no.sock"
fish_home="$folder/home"
mkdir "$fish_home"
shells=(bash)
for shell in zsh fish; do
  if command -v "$shell" >/dev/null; then shells+=("$shell"); else echo "$shell is not here: left out"; fi
done
for shell in "${shells[@]}"; do stanok completion "$shell" >"$shell.completion"; done

# offers_SHELL WORD...: what is offered behind the words, the last one being typed, one a line.
offers_bash() {
  bash --norc -c '
    source bash.completion
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _stanok
    printf "%s\n" "${COMPREPLY[@]}"' bash "$@"
}
offers_zsh() {
  zsh -f -c '
    compdef() { :; }
    compadd() { shift; print -rl -- ${(M)@:#$last*}; }
    _files() { print -rl -- $last*(N); }
    source zsh.completion
    words=("$@") CURRENT=$#
    last=$words[-1]
    _stanok' zsh "$@"
}
offers_fish() {
  local line="$*"
  HOME=$fish_home fish --no-config -c "source fish.completion; complete -C '$line'" | cut -f1
}

# expect OFFERED... -- WORD...: all these are offered, in each shell.
expect() {
  local wanted=() shell found word
  while [[ $1 != -- ]]; do wanted+=("$1") && shift; done
  shift
  for shell in "${shells[@]}"; do
    found=$("offers_$shell" "$@" 2>&1) || true
    for word in "${wanted[@]}"; do
      grep -qxF -- "$word" <<<"$found" || {
        printf 'FAILED: %s does not offer %s behind %s, but %s\n' "$shell" "$word" "$*" "$found" >&2
        exit 1
      }
    done
  done
}

expect program process -- stanok pro
expect read remove run resume return retrace reset -- stanok program r
expect --wait -- stanok program run part.nc --w
expect --all -- stanok program reset --a
expect verify -- stanok log ver
expect import -- stanok tool imp
expect --into -- stanok tool import part.nc --in
expect part.nc -- stanok tool import pa
expect part.nc -- stanok check pa
expect machine.toml -- stanok simulate part.nc --machine m
expect resume -- stanok --socket /x program res
expect E7001 -- stanok explain E700
expect modulated -- stanok process automatic mod
expect zsh fish bash -- stanok completion ''
expect status -- stanok nonsense sta
if [[ ${#shells[@]} == 1 ]]; then
  echo "SKIPPED: neither zsh nor fish is here"
  exit 77
fi
echo "completion: ${shells[*]}"
