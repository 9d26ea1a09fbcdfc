#!/usr/bin/env bash
# One part of the tests of the page. usage: panel_test.sh packages|page|unit|views|job|jog|run|process|touch|cell|drawn|views_long|drawn_long|long FOLDER_OF_THE_PROGRAMS
#
# Needs Node 18 or newer and npm; the others Chromium, too. Says what is missing and ends with 77.
set -euo pipefail
part="$1"
export STANOK_BIN="$2"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

skip() {
  echo "left out: $*"
  exit 77
}

needs_node() {
  command -v node >/dev/null || skip "node is not here (package nodejs)"
  local version
  version="$(node --version | sed 's/^v//; s/\..*//')"
  ((version >= 18)) || skip "node $version is older than 18"
}

needs_packages() {
  needs_node
  cmp -s package-lock.json node_modules/.lock || skip "the packages of package-lock.json are not here: npm ci"
}

# The packages of the lock file, once for all parts.
packages() {
  needs_node
  cmp -s package-lock.json node_modules/.lock && return 0
  command -v npm >/dev/null || skip "npm is not here"
  local log
  log="$(mktemp)"
  if ! npm ci --ignore-scripts --no-audit --no-fund >"$log" 2>&1; then
    cat "$log"
    grep -qE 'ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ENETUNREACH|ETIMEDOUT|ENOTCACHED' "$log" &&
      skip "npm does not reach its registry"
    exit 1
  fi
  rm -f "$log"
  cp package-lock.json node_modules/.lock
}

# What is committed is what the sources give, to the byte.
page() {
  needs_packages
  local built
  built="$(mktemp -d)"
  trap "rm -rf '$built'" EXIT
  node tools/client.mjs --check
  node tools/codes.mjs --check
  node tools/words.mjs --check
  npx vite build --outDir "$built" --emptyOutDir
  node tools/seal.mjs "$built"
  diff --recursive --brief "$built" dist || {
    echo "panel/dist is not what the sources give: cd panel && npm run build"
    exit 1
  }
}

unit() {
  needs_packages
  npm run check
  npm test
}

browser() {
  needs_packages
  [[ -x /usr/bin/chromium ]] || skip "Chromium is not here (package chromium)"
  # This reporter tells once more at the end what failed.
  node --test --test-reporter=spec "tests/$1_test.mjs"
}

case "$part" in
  packages | page | unit) "$part" ;;
  views_long | drawn_long) STANOK_FULL=1 browser "${part%_long}" ;;
  views | job | jog | run | process | touch | cell | drawn | long) browser "$part" ;;
  *) echo "usage: ${0##*/} packages|page|unit|views|job|jog|run|process|touch|cell|drawn|views_long|drawn_long|long FOLDER" >&2; exit 2 ;;
esac
