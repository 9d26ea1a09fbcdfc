#!/usr/bin/env python3
"""Writes a library of part programs: pieces of the three-axis workload of generate_programs, of 40 to
400 blocks each from a place by chance (with a seed), in folders of 500. One in seven has a fault.

usage: generated_library.py WORKLOAD.nc FOLDER COUNT"""

import pathlib
import random
import sys

HEAD = "G21 G90 G17 G40 G49 G80\nG54\nG64 P0.01\nF6000\n"
FAULT = "G2 X5\n"  # an arc without a centre


def main():
    workload, folder, count = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])
    lines = pathlib.Path(workload).read_text(encoding="utf-8").splitlines()
    blocks = [line for line in lines if " G1 " in line]
    chance = random.Random(28)
    for k in range(count):
        length = chance.randint(40, 400)
        first = chance.randint(0, len(blocks) - length)
        text = HEAD + "\n".join(blocks[first:first + length]) + "\n"
        if k % 7 == 3:
            text += FAULT
        file = folder / f"{k // 500:03}" / f"part{k:06}.nc"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text + "M30\n", encoding="utf-8")


main()
