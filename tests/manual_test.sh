#!/usr/bin/env bash
# The manual pages as man and mandoc see them: no warning of either, what people look for is on the page, and the
# options of the pages that are written by hand are those of the programs.
#
# usage: manual_test.sh PROGRAMS PAGES     folders of the programs, and of the pages that are written by hand
# exit code 77: skipped, neither man nor mandoc is installed
set -euo pipefail
programs=$1
pages=$2
opcua=$(dirname "${BASH_SOURCE[0]}")/../opcua/stanok-opcua.js
readers=()
for reader in man mandoc; do
  if command -v "$reader" >/dev/null; then readers+=("$reader"); else echo "without $reader: not installed"; fi
done
((${#readers[@]} > 0)) || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# warnings READER PAGE: its complaints. Pages have no date: they would change with every build.
warnings() {
  case $1 in
    man) { LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings --local-file "$2" >/dev/null; } 2>&1 ;;
    mandoc) mandoc -T lint -W warning "$2" | grep -v 'missing date' || true ;;
  esac
}

"$programs/stanok" manual "$folder/man" || fail "stanok manual"
cp "$pages/stanokd.8" "$pages/stanok-web.8" "$pages/stanok-gateway.8" "$pages/stanok-opcua.8" \
  "$pages/stanok-drives.1" "$folder/man"
count=0
for page in "$folder"/man/*; do
  count=$((count + 1))
  for reader in "${readers[@]}"; do
    text=$(warnings "$reader" "$page") || fail "$reader cannot read $page"
    [[ -z $text ]] || fail "$reader: $text"
  done
done

# rendered PAGE: plain text, one blank between words.
rendered() {
  case ${readers[0]} in
    man) LC_ALL=C.UTF-8 MANWIDTH=80 man --local-file "$folder/man/$1" ;;
    mandoc) mandoc -T utf8 "$folder/man/$1" | sed 's/.\x08//g' ;;
  esac | tr -s '[:space:]' ' '
}

expect_text() {
  local text
  text=$(rendered "$1")
  [[ $text == *"$2"* ]] || fail "$1 does not say: $2"
}
expect_text stanok-program.1 'NAME stanok-program - '
expect_text stanok-program.1 'stanok program run [OPTION ...] [--channel N] [--wait, --no-wait] [--seen-cycle N] PROGRAM'
expect_text stanok-log.1 'stanok log verify'
expect_text stanok.1 '3 no connection to the daemon'
expect_text stanokd.8 '--check-config check the machine file'

# options_of_help PROGRAM, options_of_page PAGE: the long options that are described, each on a line.
options_of_help() {
  "$programs/$1" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u
}
options_of_page() {
  sed 's/\\-/-/g' "$folder/man/$1" | grep -A 1 '^\.TP' | grep -oE -- '--[a-z-]+' | sort -u
}
for page in stanokd.8 stanok-web.8 stanok-gateway.8 stanok-drives.1; do
  difference=$(diff <(options_of_help "${page%.*}") <(options_of_page "$page")) || fail "options of $page: $difference"
done
if command -v node >/dev/null; then
  options=$(node "$opcua" --help | grep -oE '^  (-[a-z], )?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u)
  difference=$(diff <(echo "$options") <(options_of_page stanok-opcua.8)) || fail "options of stanok-opcua.8: $difference"
fi
echo "manual: $count pages passed (${readers[*]})"
