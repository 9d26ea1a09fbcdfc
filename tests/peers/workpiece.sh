#!/usr/bin/env bash
# The surface of a virtual workpiece as an independent program sees it: ADMesh must find it closed,
# with all its triangles turned outwards and nothing to mend; its volume must be what the report says.
# Exit code 77 (skipped) where ADMesh is not to be had.
#
# usage: workpiece.sh STANOK SOURCE_DIR
set -euo pipefail

readonly stanok=$1 source_dir=$2
command -v admesh >/dev/null || { echo "skipped: admesh is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$stanok" simulate "$source_dir/programs/examples/workpiece.nc" \
  --machine "$source_dir/config/machines/e7106mf4.toml" --json \
  --workpiece-out "$folder/part.stl" --picture "$folder/part.png" >"$folder/result.json"
admesh "$folder/part.stl" >"$folder/admesh.txt"

expect_none() {
  grep -Eq "^$1 *: *0( |$)" "$folder/admesh.txt" || { cat "$folder/admesh.txt"; exit 1; }
}
expect_none 'Total disconnected facets'
expect_none 'Degenerate facets'
expect_none 'Edges fixed'
expect_none 'Facets removed'
expect_none 'Facets reversed'
expect_none 'Backwards edges'
expect_none 'Normals fixed'

python3 - "$folder" <<'PYTHON'
import json, re, sys
folder = sys.argv[1]
part = json.load(open(folder + "/result.json"))["workpieces"][0]
seen = float(re.search(r"Volume *: *([0-9.]+)", open(folder + "/admesh.txt").read())[1])
print(f"volume: {part['left_mm3']:.1f} mm3 reported, {seen:.1f} mm3 by ADMesh")
assert abs(seen / part["left_mm3"] - 1.0) < 2e-3, "the volumes differ"
assert part["findings"] == [], part["findings"]
picture = open(folder + "/part.png", "rb").read()
assert picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 20000, "no picture"
PYTHON
