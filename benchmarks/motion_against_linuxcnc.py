#!/usr/bin/env python3
"""Runs paths that are hard to run well on LinuxCNC and on `stanok simulate`, and prints both side by side.

The paths are made from formulas (motion_paths.py); both get the same text. Both have the same limits of
velocity and acceleration per axis, 250 mm/s and 2500 mm/s^2, 120 deg/s and 1200 deg/s^2, the same cycle
of 1 ms and the same tolerance (G64 P); axes are plain, also five of them. stanok has limits of jerk
beside these, 50,000 mm/s^3 and 24,000 deg/s^3; LinuxCNC knows none. So stanok runs a second time with
limits of jerk so many times higher (--jerk-factor) that they hardly matter.

Printed are the time from the first to the last motion, counted in cycles; the largest deviation of the
tip from the programmed path, in micrometres; and of the commanded positions of all axes the largest
velocity, acceleration and jerk as multiples of the limit (of the lower limit of jerk), by differences.
L is LinuxCNC, S stanok, S' stanok with the higher limit of jerk.

Exit code 77 where LinuxCNC cannot run; the reason is printed. It takes about three minutes.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import linuxcnc_peer
import motion_paths
from trace_figures import figures

SKIPPED = 77
CYCLE = 0.001
END = 1e-4  # mm or degrees
LINEAR, ROTARY = (250.0, 2500.0, 50000.0), (120.0, 1200.0, 24000.0)
LIMITS = {name: LINEAR if name in "XYZ" else ROTARY for name in motion_paths.AXES}
RUNS = {"L": "linuxcnc", "S": "stanok", "S'": "stanok_higher_jerk"}


def machine_text(jerk_factor):
    """A machine file of stanok with the limits above."""
    lines = ["[machine]", 'name = "mill5"', f"cycle_us = {round(CYCLE * 1e6)}"]
    for name, (velocity, acceleration, jerk) in LIMITS.items():
        kind = "linear" if name in "XYZ" else "rotary"
        lines += ["[[axis]]", f'name = "{name}"', f'kind = "{kind}"', "min = -9999.0", "max = 9999.0",
                  f"velocity_max = {velocity}", f"acceleration_max = {acceleration}",
                  f"jerk_max = {jerk * jerk_factor}"]
    names = ", ".join(f'"{name}"' for name in LIMITS)
    lines += ["[[channel]]", "id = 1", 'name = "mill"', 'kind = "mill"', f"axes = [{names}]",
              "[[channel.scheme]]", "id = 1", 'type = "cartesian"', f"axes = [{names}]", ""]
    return "\n".join(lines)


def stanok_rows(stanok, folder, programs, jerk_factor):
    """Rows of positions of each program, a row per cycle."""
    machine, program, trace = folder / "machine.toml", folder / "program.nc", folder / "trace.csv"
    machine.write_text(machine_text(jerk_factor), encoding="ascii")
    found = {}
    for name, text in programs.items():
        program.write_text(text, encoding="ascii")
        done = subprocess.run([stanok, "simulate", program, "--json", "--machine", machine, "--axis-trace",
                               f"1={trace}"],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{name}: {done.stdout}{done.stderr}")
        with open(trace, newline="", encoding="ascii") as stream:
            lines = csv.DictReader(line for line in stream if not line.startswith("#"))
            found[name] = [tuple(float(line[axis.lower()]) for axis in LIMITS) for line in lines]
    return found


def shares(figure):
    """Largest velocity, acceleration and jerk of any axis over its limit."""
    return [max(value / limits[order] for value, limits in zip(figure[kind], LIMITS.values()))
            for order, kind in enumerate(("velocity", "acceleration", "jerk"))]


def measure(stanok, paths, tolerance, jerk_factor, folder):
    """Of each path: blocks, time of length over feed, and the figures of each run."""
    programs = {name: path.program(tolerance) for name, path in paths.items()}
    axes = [(name, "LINEAR" if name in "XYZ" else "ANGULAR", *LIMITS[name][:2]) for name in LIMITS]
    rows = {"L": linuxcnc_peer.run(folder / "peer", programs, axes, CYCLE),
            "S": stanok_rows(stanok, folder, programs, 1),
            "S'": stanok_rows(stanok, folder, programs, jerk_factor)}
    results = []
    for name, path in paths.items():
        result = {"path": name, "blocks": len(path.blocks), "length_over_feed_s": path.feed_time}
        for letter, title in RUNS.items():
            figure = figures(rows[letter][name], path.blocks, CYCLE)
            if figure["end_error"] > END:
                sys.exit(f"{name}: {title} ended {figure['end_error']} mm or degrees away from the end of the program")
            result[title] = {**figure, "shares": shares(figure)}
        results.append(result)
    return results


def print_table(results):
    heads = ["path", "blocks", "length / feed, s", "L, s", "S, s", "S', s", "deviation L / S / S', um",
             "velocity L / S", "acceleration L / S", "jerk L / S / S'"]
    print("| " + " | ".join(heads) + " |")
    print("|---" * len(heads) + "|")
    for result in results:
        peer, own, higher = (result[title] for title in RUNS.values())
        cells = [result["path"], str(result["blocks"]), f"{result['length_over_feed_s']:.2f}",
                 *(f"{run['time_s']:.3f}" for run in (peer, own, higher)),
                 " / ".join(f"{1000 * run['deviation_mm']:.1f}" for run in (peer, own, higher)),
                 *(" / ".join(f"{run['shares'][order]:.3f}" for run in (peer, own)) for order in (0, 1)),
                 " / ".join(f"{run['shares'][2]:.2f}" for run in (peer, own, higher))]
        print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stanok", type=Path, help="the program, of a release build")
    parser.add_argument("--path", action="append", choices=motion_paths.CASES, metavar="NAME",
                        help="only this one; may be repeated; names: " + "; ".join(motion_paths.CASES))
    parser.add_argument("--tolerance", type=float, default=0.01, help="mm behind G64 P (0.01)")
    parser.add_argument("--jerk-factor", type=float, default=20, help="of the second run of stanok (20)")
    parser.add_argument("--json", action="store_true", help="print JSON, with figures of each axis")
    options = parser.parse_args()
    try:
        linuxcnc_peer.require()
    except linuxcnc_peer.Unavailable as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    paths = {name: motion_paths.CASES[name]() for name in options.path or motion_paths.CASES}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o711)
        (folder / "peer").mkdir(mode=0o700)
        try:
            results = measure(options.stanok.resolve(), paths, options.tolerance, options.jerk_factor, folder)
        except linuxcnc_peer.Failed as reason:
            sys.exit(str(reason))
    if options.json:
        print(json.dumps({"linuxcnc": linuxcnc_peer.version(), "axes": list(LIMITS), "limits": LIMITS,
                          "tolerance_mm": options.tolerance, "jerk_factor": options.jerk_factor, "paths": results}))
    else:
        print(f"LinuxCNC {linuxcnc_peer.version()}\n")
        print_table(results)


if __name__ == "__main__":
    main()
