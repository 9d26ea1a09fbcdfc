#!/usr/bin/env bash
# Runs clang-tidy 22 over the sources with the checks of .clang-tidy; fails when one of them has findings.
#
# What was clean once is not looked at again: beside the compiler cache lies an empty file for each clean source, named by
# a digest of its preprocessed text (with comments and macros, since NOLINT and names of macros count), of every .clang-tidy
# and of the tool's version. Usage: tools/tidy.sh [FILE...]   (default: every tracked .cc file that is compiled)
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

readonly database=build/tidy
checks=$(tracked_files '*.clang-tidy' | xargs cat)
readonly checks
export database checks clean="$CCACHE_DIR/clean-for-tidy"
mkdir -p "$clean"
find "$clean" -type f -mtime +60 -delete

# digest COMMAND: of all that clang-tidy sees of a source.
digest() {
  { eval "$1 -E -C -dD -o -" && echo "$checks" && clang-tidy-22 --version; } |
    sed "s|$stanok_root/||g" | sha256sum | cut -d ' ' -f 1
}

# look FILE COMMAND: the findings of one source, none if it was clean before.
look() {
  local mark
  mark="$clean/$(digest "$2")" || return 1
  if [[ -e "$mark" ]]; then
    touch "$mark"
    return 0
  fi
  clang-tidy-22 -p "$database" --quiet --warnings-as-errors='*' "$1" \
    2> >(grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -' >&2) || return 1
  : >"$mark"
}
export -f digest look
export stanok_root

cmake --preset tidy >/dev/null
cmake --build "$database" --target stanok_lcm_types >/dev/null  # headers that are generated

# "FILE<tab>COMMAND" of every source that is compiled, without the compiler cache and what names the output.
commands() {
  python3 - "$database/compile_commands.json" "$stanok_root" <<'PYTHON'
import json, re, sys
for entry in json.load(open(sys.argv[1])):
    command = re.sub(r"^\S*ccache ", "", entry["command"])
    command = re.sub(r" -o \S+ -c (\S+)$", r" \1", command)
    print(entry["file"].removeprefix(sys.argv[2] + "/"), command, sep="\t")
PYTHON
}
if (($#)); then printf '%s\n' "$@"; else tracked_files '*.cc'; fi | sort >"$database/wanted.txt"
commands | sort -t $'\t' -k 1,1 | join -t $'\t' "$database/wanted.txt" - | tr '\n' '\0' |
  xargs -0 -r -n 1 -P "$jobs" bash -c 'set -o pipefail; look "${0%%$'"'\t'"'*}" "${0#*$'"'\t'"'}"'
