#!/usr/bin/env python3
"""Runs paths that are hard to run well on the virtual clock, and prints their times beside references.

usage: motion_cases.py BIN [POLYLINES]

BIN is the folder of a release build's programs. Machine: config/machines/mill3.toml (250 mm/s,
2500 mm/s^2, 50,000 mm/s^3) and mill5.toml, G64 P0.01. Reference of each case:
  feed      sum of length over feed: no ramps at all
  parabola  no limit of jerk: trapezoids of speed along the legs, corners passed by parabolas within
            the tolerance e at v^2 = min(2 a e / sin^2(t/2), a l / (2 sin(t/2))), t the angle of turn
            and l the shorter leg
POLYLINES paths (40) of 50 to 200 legs, 0.5 to 50 mm long, that turn by up to 150 deg, at 1 to
15 m/min, are run with jerk limits of 400 and 40 times the acceleration per second; printed are
quantiles of time / parabola.
"""

import csv
import json
import math
import random
import subprocess
import sys
import tempfile
from decimal import Decimal
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MILL3 = ROOT / "config/machines/mill3.toml"
MILL5 = ROOT / "config/machines/mill5.toml"
TOLERANCE = 0.01
ACCELERATION = 2500.0
HEAD = "G21 G90 G17 G64 P0.01"


def simulate(binaries, machine, program):
    """Machine time and wall time of a run, in s."""
    done = subprocess.run([binaries / "stanok", "simulate", "--json", "--machine", machine, program],
                          capture_output=True, text=True, check=False)
    result = json.loads(done.stdout)
    if not result["ok"]:
        sys.exit(f"{program}: {done.stdout}")
    return result["channels"][0]["time_s"], result["wall_s"]


def written(folder, name, blocks):
    file = folder / f"{name}.nc"
    file.write_text("\n".join([HEAD, *blocks, "M30", ""]), encoding="ascii")
    return file


def square(_):
    corners = ["X20 Y0", "X20 Y20", "X0 Y20", "X0 Y0"]
    return ["F5000"] + [f"G1 {corner}" for corner in corners * 3], 240 / (5000 / 60)


def circles(_):
    return ["F5000", "G2"] + ["X0 Y0 I10 J0"] * 8, 8 * 2 * math.pi * 10 / (5000 / 60)


def chords(radius, length, feed, turns, decimals):
    count = round(2 * math.pi * radius / length)
    blocks = [f"F{feed}", "G1"]
    for k in range(1, count * turns + 1):
        angle = 2 * math.pi * k / count
        x, y = radius - radius * math.cos(angle), radius * math.sin(angle)
        blocks.append(f"X{x:.{decimals}f} Y{y:.{decimals}f}")
    return blocks, turns * count * 2 * radius * math.sin(math.pi / count) / (feed / 60)


def slice_of(folder, name):
    """Blocks 20,001 to 22,000 of a generated program, moved to begin at zero."""
    with open(folder / f"{name}.path.csv", newline="", encoding="ascii") as stream:
        rows = list(csv.DictReader(stream))
    axes = [axis for axis in "xyzabc" if axis in rows[0]]
    first = {axis: Decimal(rows[0][axis]) for axis in axes}
    blocks, time = ["G1"], 0.0
    for before, row in zip(rows, rows[1:]):
        words = " ".join(f"{axis.upper()}{Decimal(row[axis]) - first[axis]}" for axis in axes)
        blocks.append(f"{words} F{float(row['f']) * 60:.6f}")
        time += math.dist(*([float(r[axis]) for axis in "xyz"] for r in (before, row))) / float(row["f"])
    return blocks, time


def polyline(seed):
    """Points and feed in mm/s."""
    draw = random.Random(seed)
    legs, feed = draw.randint(50, 200), draw.uniform(1000, 15000) / 60
    heading, points = draw.uniform(0, 2 * math.pi), [(0.0, 0.0)]
    for _ in range(legs):
        length = 0.5 * 100 ** draw.random()
        heading += draw.choice((-1, 1)) * math.radians(draw.uniform(0, 150))
        x, y = points[-1]
        points.append((round(x + length * math.cos(heading), 6), round(y + length * math.sin(heading), 6)))
    return points, feed


def parabola_time(points, feed):
    """The reference of the same name; axes of equal acceleration, direction by direction."""
    legs = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(points, points[1:])]
    lengths = [math.hypot(*leg) for leg in legs]
    units = [(x / l, y / l) for (x, y), l in zip(legs, lengths)]

    def along(direction):
        return ACCELERATION / max(abs(c) for c in direction)

    speeds = [0.0]
    for one, two, l1, l2 in zip(units, units[1:], lengths, lengths[1:]):
        step = (two[0] - one[0], two[1] - one[1])
        size = math.hypot(*step)  # 2 sin(t/2)
        if size < 1e-9:
            speeds.append(feed)
            continue
        a = along((step[0] / size, step[1] / size))
        v2 = min(2 * a * TOLERANCE / (size / 2) ** 2, a * min(l1, l2) / size)
        speeds.append(min(feed, math.sqrt(v2)))
    speeds.append(0.0)
    for order in (range(len(legs)), range(len(legs) - 1, -1, -1)):
        for k in order:
            here, there = (k, k + 1) if order.step > 0 else (k + 1, k)
            reach = math.sqrt(speeds[here] ** 2 + 2 * along(units[k]) * lengths[k])
            speeds[there] = min(speeds[there], reach)
    time = 0.0
    for k, unit in enumerate(units):
        a, v0, v1 = along(unit), speeds[k], speeds[k + 1]
        top = min(feed, math.sqrt((v0**2 + v1**2) / 2 + a * lengths[k]))
        ramps = (2 * top**2 - v0**2 - v1**2) / 2 / a
        time += (2 * top - v0 - v1) / a + max(0.0, lengths[k] - ramps) / top
    return time


def with_jerk(folder, factor):
    """mill3 without soft limits and with another limit of jerk."""
    text = MILL3.read_text(encoding="utf-8").replace("jerk_max = 50000.0", f"jerk_max = {factor * ACCELERATION}")
    for limit in ("500.0", "400.0"):
        text = text.replace(f"min = -{limit}", "min = -50000.0").replace(f"max = {limit}", "max = 50000.0")
    file = folder / f"mill{factor}.toml"
    file.write_text(text, encoding="utf-8")
    return file


def print_polylines(binaries, folder, count):
    for factor in (400, 40):
        machine, ratios = with_jerk(folder, factor), []
        for seed in range(count):
            points, feed = polyline(seed)
            blocks = [f"F{feed * 60:.6f}", "G1"] + [f"X{x} Y{y}" for x, y in points[1:]]
            time, _ = simulate(binaries, machine, written(folder, "polyline", blocks))
            ratios.append(time / parabola_time(points, feed))
        ratios.sort()
        shown = ", ".join(f"{name} {ratios[int(part * (count - 1))]:.3f}"
                          for name, part in (("least", 0), ("median", 0.5), ("p90", 0.9), ("largest", 1)))
        print(f"{count} polylines, jerk {factor} x acceleration: time / parabola {shown}")


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    binaries = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([binaries / "generate_programs", "--scale", "full", "--out", folder, "--feed-low", "800",
                        "--feed-high", "2000", "--path-blocks", "20001:22000"], check=True, stdout=subprocess.DEVNULL)
        cases = [
            ("three rounds of a 20 mm square, F5000", MILL3, square(None)),
            ("eight circles R10, F5000", MILL3, circles(None)),
            ("the same as 0.1 mm chords, four turns", MILL3, chords(10, 0.1, 5000, 4, 9)),
            ("R200 as 0.05 mm chords, five turns, F14000", MILL3, chords(200, 0.05, 14000, 5, 4)),
            ("raster of 0.3 mm blocks, three axes", MILL3, slice_of(folder, "0003_MB_3D.nc")),
            ("surface of 0.19 mm blocks, five axes", MILL5, slice_of(folder, "Impeller_surface.nc")),
        ]
        for title, machine, (blocks, feed_time) in cases:
            time, wall = simulate(binaries, machine, written(folder, "case", blocks))
            print(f"{title}: {time:.3f} s, feed {feed_time:.3f} s, ratio {time / feed_time:.4f}, "
                  f"{len(blocks) / wall:,.0f} blocks/s of wall time")
        print_polylines(binaries, folder, int(sys.argv[2]) if len(sys.argv) > 2 else 40)


if __name__ == "__main__":
    main()
