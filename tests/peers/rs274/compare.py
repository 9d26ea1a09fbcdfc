#!/usr/bin/env python3
"""Compares `stanok interpret` with `rs274 -g` of LinuxCNC, program by program.

usage: compare.py [--verbose] STANOK [PROGRAM...]

Without PROGRAM: those of programs/ and the ones generate.py makes. Ends with the number of programs
that agree; exit code 1 when one does not, 77 when rs274 is not installed. A program may say

  (path 1e-3)            compared as paths within so many mm, whatever pieces they consist of
  (difference: RULE)     the two read it differently on purpose; RULE stands in differences.md
  (contour: left 2 XY)   beside a difference: between lead-in and lead-out both must be that far
                         on that side of the programmed contour, and the same path
"""

import argparse
import re
import shutil
import sys
import tempfile
from itertools import zip_longest
from pathlib import Path

sys.dont_write_bytecode = True  # the modules below stand in the source tree

import canonical_calls
import contours
import generate
import paths
import stanok_records
from events import same, without_standing_moves

HERE = Path(__file__).resolve().parent
SKIPPED = 77
CONTOUR_TOLERANCE = 1e-3  # mm


def first_difference(ours, theirs):
    for number, (own, other) in enumerate(zip_longest(ours, theirs), start=1):
        if own is None or other is None or not same(own, other):
            return (f"event {number}\n    stanok  {own.text() if own else 'nothing'}"
                    f"\n    rs274   {other.text() if other else 'nothing'}")
    return None


class Comparison:
    def __init__(self, stanok, folder):
        self.stanok = stanok
        self.folder = folder
        self.rules = (HERE / "differences.md").read_text()
        self.later = []
        self.by_rule = 0

    def difference(self, program):
        """What is wrong with this program, or None."""
        text = program.read_text(errors="replace")
        path = re.search(r"^\(path (\S+)\)", text, re.MULTILINE)
        deliberate = re.search(r"^\(difference: (.*)\)", text, re.MULTILINE)
        contour = re.search(r"^\(contour: (left|right) (\S+) (\S+)\)", text, re.MULTILINE)
        found = self.run(program, float(path[1]) if path else None)
        if not deliberate:
            return found
        if deliberate[1] not in self.rules:
            return f"the rule '{deliberate[1]}' is missing in differences.md"
        if not found:
            return "the two agree, but a difference is stated"
        self.by_rule += 1
        if not contour:
            return None
        return self.contour_difference(program, (contour[1], float(contour[2]), contour[3]))

    def contour_difference(self, program, shape):
        bare = self.folder / "contour.ngc"
        bare.write_text(contours.without_compensation(program.read_text()))
        ours = stanok_records.events_of(self.stanok, program, HERE / "mill6.toml")
        theirs, contour = (self.events_of_rs274(each) for each in (program, bare))
        return contours.difference(*map(paths.elements_of, (ours, theirs, contour)), shape,
                                   CONTOUR_TOLERANCE)

    def events_of_rs274(self, program):
        parameters = self.folder / "parameters.var"
        parameters.write_text("5220\t1\n")  # G54; all else is written by rs274
        return canonical_calls.events_of(program, HERE / "mill6.tbl", parameters)

    def run(self, program, path_tolerance):
        own = other = None
        try:
            own = stanok_records.events_of(self.stanok, program, HERE / "mill6.toml")
        except canonical_calls.Refused as refusal:
            own_refusal = str(refusal)
        try:
            other = self.events_of_rs274(program)
        except canonical_calls.Refused as refusal:
            other_refusal = str(refusal)
        except canonical_calls.Unknown as call:
            return f"unknown call {call}"
        if own is None and other is None:
            return f"both refuse it: {own_refusal}\n    rs274   {other_refusal}"
        if own is None and "E2090" in own_refusal:
            self.later.append(program.name)  # answered so: it comes with a later release
            return None
        if own is None:
            return f"refused by stanok: {own_refusal}"
        if other is None:
            return f"refused by rs274: {other_refusal}"
        if path_tolerance:
            return paths.difference(paths.elements_of(own), paths.elements_of(other), path_tolerance)
        return first_difference(without_standing_moves(own), without_standing_moves(other))


def main():
    parser = argparse.ArgumentParser(description="compares stanok with rs274")
    parser.add_argument("--verbose", action="store_true", help="names programs that agree, too")
    parser.add_argument("stanok", help="the stanok to test")
    parser.add_argument("programs", nargs="*", type=Path)
    options = parser.parse_args()
    if shutil.which("rs274") is None:
        print("rs274 is not installed (Debian package linuxcnc-uspace): nothing compared")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        programs = [program.resolve() for program in options.programs]
        if not programs:
            programs = sorted((HERE / "programs").glob("*.ngc")) + generate.write_programs(folder)
        comparison = Comparison(options.stanok, folder)
        failed = 0
        for program in programs:
            found = comparison.difference(program)
            if found:
                failed += 1
                print(f"{program.name}: {found}")
                if program.parent == folder:
                    print("    " + program.read_text().replace("\n", "\n    "))
            elif options.verbose:
                print(f"{program.name}: same")
    for name in comparison.later:
        print(f"not compared: {name} needs what comes with a later release of stanok")
    not_agreeing = failed + len(comparison.later)
    print(f"{len(programs) - not_agreeing} of {len(programs)} programs agree, "
          f"{comparison.by_rule} of them but for a rule of differences.md")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
