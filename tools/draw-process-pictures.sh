#!/usr/bin/env bash
# Draws the pictures of the process again from runs of stanok: docs/programmer/pictures.
#
#   tools/draw-process-pictures.sh build/release
set -euo pipefail
# shellcheck source=tools/environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

build="${1:?give the build folder, for example build/release}"
stanok="$(find "$build" -maxdepth 2 -name stanok -type f -perm -u+x | head -n 1)"
[[ -n "$stanok" ]] || { echo "there is no stanok in $build" >&2; exit 1; }
pictures=docs/programmer/pictures
work="$(mktemp -d)"
trap 'rm -r "$work"' EXIT

# Feed laws: figures 2 and 4 of the paper.
for program in slender_shaft chip_breaking; do
  "$stanok" simulate "programs/examples/$program.nc" --machine config/machines/lathe.toml \
      --tip-trace "1=$work/$program.csv"
done
gnuplot -e "data='$work'; pictures='$pictures'" benchmarks/feed_law_figures.gnuplot

# Adaptive control: the example.
"$stanok" simulate programs/examples/adaptive_steps.nc --machine config/machines/lathe.toml \
    --log "$work/adaptive.lcm"
"$stanok" log plot "$work/adaptive.lcm" --out "$work/plots"
cp "$work/plots/ch1-force.png" "$pictures/adaptive-steps.png"

# Grinding: figures 7, 8 and 10, and a design. The exit code tells findings, which the paper has.
grinding=programs/examples/plunge_grinding
"$stanok" grind design $grinding.toml --iterations 0 --optimum-picture $pictures/grinding-first.svg || true
"$stanok" grind design $grinding.toml --points 5 --optimum-picture $pictures/grinding-optimum.svg \
    --picture $pictures/grinding-design.svg
"$stanok" grind verify $grinding.txt --picture $pictures/grinding-file.svg || true

# Chatter; the planned cuts of the examples chatter in part.
"$stanok" process lobes programs/examples/slot_lobes.toml --speeds 3000:20000 \
    --cut 9000:0.5 --cut 5000:1.0 --picture $pictures/lobes.png || true
"$stanok" process lobes programs/examples/grinding_lobes.toml --speeds 20:400 \
    --cut 60:20 --cut 300:20 --picture $pictures/grinding-lobes.png || true

# Forces along programs.
"$stanok" process optimise programs/examples/adaptive_steps.nc \
    --machine config/machines/lathe.toml --force 1200 --feed-min 0.05 --feed-max 0.6 \
    --stiffness 30 --picture $pictures/forces-turning.png
"$stanok" process optimise programs/examples/workpiece.nc --machine config/machines/e7106mf4.toml \
    --cut programs/examples/end_mill_6.toml --tool 3 --force 120 --feed-max 0.3 \
    --picture $pictures/forces-milling.png
