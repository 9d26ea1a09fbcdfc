#!/usr/bin/env bash
# Lays out every C++ file as .clang-format says, and the files of panel and opcua, where their packages of npm are, as
# prettier does; with --check only reports the files that differ.
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

case "${1:-}" in
  --check) clang_format=(clang-format-22 --dry-run -Werror) prettier=--check ;;
  "") clang_format=(clang-format-22 -i) prettier=--write ;;
  *) echo "usage: ${0##*/} [--check]" >&2; exit 2 ;;
esac

mapfile -t files < <(tracked_files '*.h' '*.cc')
result=0
((${#files[@]} == 0)) || "${clang_format[@]}" "${files[@]}" || result=1
for folder in panel opcua; do
  [[ -x $folder/node_modules/.bin/prettier ]] || continue
  (cd "$folder" && node_modules/.bin/prettier --log-level warn "$prettier" .) || result=1
done
exit "$result"
