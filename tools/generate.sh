#!/usr/bin/env bash
# Writes everything that is made from code: the tables of the documents, openrpc.json, the methods of the Python
# package, types, codes and words of the page, the built page, and the picture of the folders.
#
# usage: generate.sh [--no-page] [BUILD_FOLDER]
#
#   --no-page      without node: the page and what it is compiled against stay as they are (commit the built page apart)
#   BUILD_FOLDER   of a preset (default build/release); what is needed is built there first
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=tools/environment.sh
source tools/environment.sh

page=yes
build=build/release
for word in "$@"; do
  case "$word" in
    --no-page) page=no ;;
    -h | --help)
      sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    -*)
      echo "generate.sh: no option $word; see --help" >&2
      exit 2
      ;;
    *) build=$word ;;
  esac
done
if [[ ! -f $build/build.ninja ]]; then
  echo "generate.sh: $build is no build folder; cmake --preset ${build##*/} makes it" >&2
  exit 1
fi

# Test program, and its suites that write a document.
readonly -A writers=([base]='AlarmsDocument.*' [protocol]='Discovery.*' [recording]='MessagesDocument.*'
  [lang]='LanguageDocument.*' [daemon]='CommandTableDocument.*' [jobs]='ToolFormatsDocument.*')
tests=("${!writers[@]}")
ninja -C "$build" "${tests[@]/%/_tests}" stanok_python
for name in "${!writers[@]}"; do
  STANOK_WRITE_DOCS=1 "$build/tests/${name}_tests" --gtest_brief=1 --gtest_filter="${writers[$name]}"
done
PYTHONPATH=$build/python /usr/bin/python3 tools/generate_python_methods.py
tools/draw-folders.py
if [[ $page == yes ]]; then
  (cd panel && npm run --silent generate && npm run --silent build)
fi
# A copy without git has nothing to tell.
git status --short 2>/dev/null || true
