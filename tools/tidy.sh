#!/usr/bin/env bash
# Runs clang-tidy 22 over the sources with the checks of .clang-tidy; fails on the first file set with findings.
#
# Usage: tools/tidy.sh [FILE...]   (default: every tracked .cc file that is compiled)
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

readonly database=build/tidy
cmake --preset tidy >/dev/null
cmake --build "$database" --target stanok_lcm_types >/dev/null  # headers that are generated

if (($#)); then
  files=("$@")
else
  mapfile -t files < <(tracked_files '*.cc' | while read -r file; do
    grep -qF "/$file\"" "$database/compile_commands.json" && echo "$file"
  done)
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -r -n 1 -P "$jobs" clang-tidy-22 -p "$database" --quiet --warnings-as-errors='*' \
    2> >(grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -' >&2)
