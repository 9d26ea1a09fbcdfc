#!/usr/bin/env bash
# Checks every link of the Markdown documents that points into the repository: the file must exist, and
# a #fragment must be a heading of it. Prints file:line for each broken one and ends with 1.
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

# The fragments of a document: its headings in the form that forges give them, and explicit anchors.
fragments_of() {
  sed -n 's/^#\{1,6\} *//p' "$1" | tr '[:upper:]' '[:lower:]' | sed 's/[^[:alnum:] _-]//g; s/ /-/g'
  grep -oE '<a (id|name)="[^"]+"' "$1" | sed 's/.*="//; s/"$//' || true
}

# Lines "number:target" of all inline links outside code fences.
links_of() {
  awk '/^ *```/ { code = !code; next } !code { gsub(/`[^`]*`/, ""); print NR ":" $0 }' "$1" |
    awk -F: '{ line = $0; sub(/^[0-9]+:/, "", line)
               while (match(line, /\]\([^)]+\)/)) {
                 print $1 ":" substr(line, RSTART + 2, RLENGTH - 3); line = substr(line, RSTART + RLENGTH) } }'
}

count=0
broken=0

# check_link PLACE FOLDER DOCUMENT TARGET: TARGET is relative to FOLDER; a bare #fragment means DOCUMENT itself.
check_link() {
  local place="$1" folder="$2" file="$3" target="${4%% *}"
  count=$((count + 1))
  case "$target" in http://* | https://* | mailto:*) return ;; esac
  local path="${target%%#*}" fragment=""
  [[ "$target" == *'#'* ]] && fragment="${target#*#}"
  [[ -n "$path" ]] && file="$folder/$path"
  if [[ ! -e "$file" ]]; then
    echo "$place: no file '$path'" >&2
  elif [[ -n "$fragment" && -f "$file" ]] && ! grep -qxF -- "$fragment" <<<"$(fragments_of "$file")"; then
    echo "$place: no heading '#$fragment' in ${file#./}" >&2
  else
    return 0
  fi
  broken=$((broken + 1))
}

while read -r document; do
  while IFS=: read -r line target; do
    check_link "$document:$line" "$(dirname "$document")" "$document" "$target"
  done < <(links_of "$document")
done < <(tracked_files '*.md')

# Comments of the code name documents too: docs/developer/motion.md#blends must exist.
while IFS=: read -r file line target; do
  check_link "$file:$line" . "$file" "$target"
done < <(tracked_files '*.h' '*.cc' '*.toml' '*.txt' '*.cmake' '*.sh' '*.py' '*.nc' '*.gnuplot' 'start' 'test' | tr '\n' '\0' |
  xargs -0 -r grep -onHE 'docs/[a-z0-9/_-]+\.md(#[a-z0-9_-]+)?' || true)

echo "$count links checked, $broken broken"
((broken == 0))
