#!/usr/bin/env python3
"""Measures `stanok interpret --quiet` and, where it is installed, `rs274` on the same programs.

usage: interpret_against_rs274.py STANOK [RUNS]

STANOK should be a release build. Programs are made from a seed in a temporary folder; each is run RUNS
times (3) by both in turn, the fastest processor time counts. The last column is the largest
resident memory of stanok. Output of both goes nowhere; rs274 prints its canonical calls all the same,
stanok prepares its blocks for motion.
"""

import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MACHINE = ROOT / "tests/peers/rs274/mill6.toml"
TOOLS = ROOT / "tests/peers/rs274/mill6.tbl"
SEED = 7


# The programs: lines one by one, so that this process stays smaller than those it measures (the
# largest resident memory of a child counts from the fork).
def lines(count):
    draw = random.Random(SEED)
    yield from ["G21 G90 G17 F1000", "G64", "G1"]
    for _ in range(count):
        yield f"X{draw.uniform(-90, 90):.4f} Y{draw.uniform(-90, 90):.4f} Z{draw.uniform(-9, 9):.4f}"


def arcs(count):
    draw = random.Random(SEED)
    yield "G21 G17 G91 F1000"
    for _ in range(count):
        radius = round(draw.uniform(1, 9), 3)
        yield f"G{draw.choice('23')} X{2 * radius:.3f} Y0 I{radius:.3f} J0"


def expressions(count):
    yield from ["G21 G90 F1000", "#1=0.5 #2=2"]
    for k in range(count):
        yield f"G1 X[#1 * {k % 97} + SIN[{k % 360}]] Y[#2 - {k % 31} / 3]"


def o_words(count):
    yield from ["G21 G90 F1000", "#1=0", f"o1 while [#1 LT {count}]", "G1 X[#1 / 1000]",
                "#1=[#1 + 1]", "o1 endwhile"]


def measured(command):
    """Processor time in s and largest memory in MB of a command."""
    # wait4 gives time and memory of this child alone.
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               stdin=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit {process.returncode}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    stanok, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    peer = shutil.which("rs274")
    subjects = [("lines, three axes", 300_000, lines), ("arcs", 100_000, arcs),
                ("expressions", 100_000, expressions), ("O-word loop", 1_000_000, o_words)]
    print(f"{'program':20}{'blocks':>10}{'stanok blocks/s':>18}{'rs274 blocks/s':>18}{'ratio':>8}"
          f"{'memory':>10}")
    with tempfile.TemporaryDirectory() as name:
        program, parameters = Path(name) / "program.ngc", Path(name) / "parameters.var"
        parameters.write_text("5220\t1\n")
        for subject, blocks, text in subjects:
            with program.open("w") as file:
                file.writelines(line + "\n" for line in text(blocks))
                file.write("M2\n")
            own, other, memory = [], [], []
            for _ in range(runs):
                seconds, used = measured([stanok, "interpret", "--quiet", "--machine", MACHINE, program])
                own.append(seconds)
                memory.append(used)
                if peer:
                    other.append(measured([peer, "-g", "-n", "2", "-t", TOOLS, "-v", parameters,
                                           program])[0])
            rate = blocks / min(own)
            theirs = f"{blocks / min(other):>18,.0f}{rate * min(other) / blocks:>8.1f}" if other else \
                f"{'-':>18}{'-':>8}"
            print(f"{subject:20}{blocks:>10,}{rate:>18,.0f}{theirs}{max(memory):>7.0f} MB")
        program.write_text("num sum_ = 0;\nnum step = 0;\nwhile (step < 10000000) "
                           "{ sum_ = sum_ + step*0.5; step = step + 1; }\n"
                           "if (sum_ < 1) { terminate (1000, \"no\"); }\nM2\n")
        seconds, used = measured([stanok, "interpret", "--quiet", "--machine", MACHINE, program])
        print(f"10^7 passes of a high-level loop with arithmetic: {seconds:.2f} s, {used:.0f} MB")


if __name__ == "__main__":
    main()
