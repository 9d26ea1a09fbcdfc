#!/usr/bin/env bash
# Lays out every C++ file as .clang-format says; with --check only reports the files that differ.
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

mapfile -t files < <(tracked_files '*.h' '*.cc')
((${#files[@]})) || exit 0
case "${1:-}" in
  --check) clang-format-22 --dry-run -Werror "${files[@]}" ;;
  "") clang-format-22 -i "${files[@]}" ;;
  *) echo "usage: ${0##*/} [--check]" >&2; exit 2 ;;
esac
