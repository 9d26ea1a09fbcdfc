#!/usr/bin/env bash
# Surfaces of virtual workpieces as an independent program sees them: ADMesh must find each closed,
# with all its triangles turned outwards and nothing to mend; its volume must be what the report says.
# Milled, turned, and both parts of the experiment from one run with a switch of the scheme.
# Exit code 77 (skipped) where ADMesh is not to be had.
#
# usage: workpiece.sh STANOK GENERATE_PROGRAMS SOURCE_DIR
set -euo pipefail

readonly stanok=$1 generate=$2 source_dir=$3
readonly examples=$source_dir/programs/examples machines=$source_dir/config/machines
command -v admesh >/dev/null || { echo "skipped: admesh is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

expect_none() {
  grep -Eq "^$2 *: *0( |$)" "$1" || { cat "$1"; exit 1; }
}

look_at() {  # STL
  admesh "$1" >"$1.txt"
  for fault in 'Total disconnected facets' 'Degenerate facets' 'Edges fixed' 'Facets removed' \
    'Facets reversed' 'Backwards edges' 'Normals fixed'; do
    expect_none "$1.txt" "$fault"
  done
}

# NAME and what `simulate` wants; the run must end well.
cut() {
  local name=$1
  shift
  "$stanok" simulate "$@" --json --workpiece-out "$folder/$name.stl" --picture "$folder/$name.png" \
    >"$folder/$name.json"
  look_at "$folder/$name.stl"
}

cut milled "$examples/workpiece.nc" --machine "$machines/e7106mf4.toml"
cut turned "$examples/turned_part.nc" --machine "$machines/lathe.toml"
"$generate" --scale small --out "$folder/programs" >/dev/null
cut experiment --run "2=$examples/master_on_blanks.nc" --program-root "$folder/programs" \
  --machine "$machines/e7106mf4.toml"
look_at "$folder/experiment.2.stl"

python3 - "$folder" <<'PYTHON'
import json, re, sys
folder = sys.argv[1]

def check(name, piece=0, codes=()):
    number = f".{piece + 1}" if piece else ""
    part = json.load(open(f"{folder}/{name}.json"))["workpieces"][piece]
    text = open(f"{folder}/{name}{number}.stl.txt").read()
    seen = float(re.search(r"Volume *: *([0-9.]+)", text)[1])
    print(f"{part['program']}: {part['left_mm3']:.1f} mm3 reported, {seen:.1f} mm3 by ADMesh")
    assert abs(seen / part["left_mm3"] - 1.0) < 5e-3, "the volumes differ"
    assert {finding["code"] for finding in part["findings"]} <= set(codes), part["findings"]
    picture = open(f"{folder}/{name}{number}.png", "rb").read()
    assert picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 20000, "no picture"

check("milled")
check("turned")
# Small programs leave wide strips between their rows, through which rapids go.
check("experiment", 0, ["W921"])
check("experiment", 1)
PYTHON
