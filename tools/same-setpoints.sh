#!/usr/bin/env bash
# Checks that two builds give the same setpoints, bit for bit, for 40 programs and for 500 random runs with override,
# hold, resume and abort. Usage: tools/same-setpoints.sh PRESET PRESET; both builds must contain stanok, stanok-drives,
# generate_programs and motion_tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
(($# == 2)) || { sed -n 's/^# //; 2,4p' "$0" >&2; exit 2; }
mkdir -p build/logs
for preset in "$@"; do
  python3 tools/setpoint-digests.py "build/$preset/bin" >"build/logs/setpoints-$preset.txt"
  "build/$preset/tests/motion_tests" --gtest_filter='*OperatorRuns*FullSize*' --gtest_brief=1 \
    --gtest_output="json:build/logs/operator-runs-$preset.json"
  grep -oE '"(name|setpoints)": "[^"]*"' "build/logs/operator-runs-$preset.json" >>"build/logs/setpoints-$preset.txt"
done
(($(grep -c '"setpoints"' "build/logs/setpoints-$1.txt") > 0))
diff "build/logs/setpoints-$1.txt" "build/logs/setpoints-$2.txt"
echo "the same setpoints: $(grep -c . "build/logs/setpoints-$1.txt") lines"
