#!/usr/bin/env bash
# Runs clang-tidy 22 over the sources with the checks of .clang-tidy; fails when one of them has findings.
#
# Sources of the product are looked at one by one. Those of tests are looked at in the units that are compiled, twelve at
# a time, and without the paths through their functions (clang-analyzer): sanitizers follow these when the tests run, and
# reading the headers for each test alone took longer than all of the product.
#
# What was clean once is not looked at again: beside the compiler cache lies an empty file for each clean source, named by
# a digest of its preprocessed text (with comments and macros, since NOLINT and names of macros count), of every .clang-tidy
# and of the tool's version. Usage: tools/tidy.sh [FILE...]   (default: every tracked .cc file that is compiled)
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

readonly alone=build/tidy together=build/clang
clean="$CCACHE_DIR/clean-for-tidy"
mkdir -p "$clean"
find "$clean" -type f -mtime +60 -delete

cmake --preset tidy >/dev/null
cmake --preset clang >/dev/null
for database in "$alone" "$together"; do
  cmake --build "$database" --target stanok_lcm_types stanok_protobuf_sparkplug_b >/dev/null  # generated headers
done

# The checks of tests, for units: what they include is no header, and belongs to them.
sed -e 's/^Checks: >$/&\n  -clang-analyzer-*,\n  -bugprone-suspicious-include,/' tests/.clang-tidy >"$together/units/.clang-tidy"
echo "HeaderFilterRegex: '/tests/.*\.(h|cc)\$'" >>"$together/units/.clang-tidy"

checks=$(tracked_files '*.clang-tidy' | xargs cat "$together/units/.clang-tidy")
readonly checks
export checks clean

# digest COMMAND: of all that clang-tidy sees of a source.
digest() {
  { eval "$1 -E -C -dD -o -" && echo "$checks" && clang-tidy-22 --version; } |
    sed "s|$stanok_root/||g" | sha256sum | cut -d ' ' -f 1
}

# look DATABASE FILE COMMAND: the findings of one source or unit, none if it was clean before.
look() {
  local mark
  mark="$clean/$(digest "$3")" || return 1
  if [[ -e "$mark" ]]; then
    touch "$mark"
    return 0
  fi
  clang-tidy-22 -p "$1" --quiet --warnings-as-errors='*' "$2" \
    2> >(grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -' >&2) || return 1
  : >"$mark"
}
export -f digest look
export stanok_root

# DATABASE, FILE and COMMAND of what is to be looked at, each with a NUL behind it; of the command without the compiler
# cache and what names the output. Reads the names of sources.
wanted() {
  python3 - "$stanok_root" "$alone" "$together" 3<&0 <<'PYTHON'
import json, os, re, sys

root, alone, together = sys.argv[1:]

def entries(database):
    with open(os.path.join(database, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            command = re.sub(r"^\S*ccache ", "", entry["command"])
            yield entry["file"].removeprefix(root + "/"), re.sub(r" -o \S+ -c (\S+)$", r" \1", command)

def sources(unit):
    with open(unit, encoding="utf-8") as file:
        return set(re.findall(r'#include "(.*)"', file.read()))

names = set(os.fdopen(3, encoding="utf-8").read().split())
in_units = set()
for file, command in entries(together):
    if "/units/" not in file:
        continue
    parts = sources(file)
    if all(part.startswith("tests/") for part in parts) and names & parts:
        in_units |= parts
        print(together, file, command, sep="\0", end="\0")
for file, command in entries(alone):
    if file in names - in_units:
        print(alone, file, command, sep="\0", end="\0")
PYTHON
}
# shellcheck disable=SC2016 # for the shell that is begun
if (($#)); then printf '%s\n' "$@"; else tracked_files '*.cc'; fi | wanted |
  xargs -0 -r -n 3 -P "$jobs" bash -c 'set -o pipefail; look "$0" "$1" "$2"'
