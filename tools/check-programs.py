#!/usr/bin/env python3
"""Runs `stanok check` over folders of programs and counts what becomes of them, dialect by dialect.

    tools/check-programs.py build/release/bin/stanok config/machines/mill3.toml --dialect fanuc FOLDER...
    tools/check-programs.py ... --code-system A --show 3 FOLDER...

Each program is checked on its own, on the machine with the dialect given (the machine file is copied beside itself for
that). Printed are: how many are accepted, and for each error code how many programs are refused with it first, with
some examples. A program that ends without an answer within --timeout counts as such.
"""
import argparse
import collections
import json
import os
import re
import subprocess
import sys
import tempfile

ENDINGS = (".nc", ".ngc", ".tap", ".eia", ".cnc", ".gcode", ".mpf", ".min", ".h", ".txt", ".pim")
CODE = re.compile(r"^error\[([A-Z]\d+)\]: (.*)$", re.M)
PLACE = re.compile(r"--> .*?:(\d+):(\d+)")


def programs_of(folders):
    for folder in folders:
        if os.path.isfile(folder):
            yield folder
        for root, _, names in sorted(os.walk(folder)):
            for name in sorted(names):
                if name.lower().endswith(ENDINGS) or re.fullmatch(r"[Oo]\d{3,8}", name):
                    yield os.path.join(root, name)


def machine_in_dialect(machine, dialect, code_system):
    """The machine file with the dialect of its first channel, in the same folder so that its paths hold."""
    with open(machine, encoding="utf-8") as file:
        text = file.read()
    keys = f'[[channel]]\ndialect = "{dialect}"\n'
    if code_system:
        keys += f'code_system = "{code_system}"\n'
    made = tempfile.NamedTemporaryFile("w", suffix=".toml", dir=os.path.dirname(os.path.abspath(machine)), delete=False)
    with made:
        made.write(text.replace("[[channel]]\n", keys, 1))
    return made.name


def check(stanok, machine, program, timeout):
    """The class of a program and the first error: (class, message with its line)."""
    command = [stanok, "check", "--machine", machine, "--steps", "2", program]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=timeout, errors="replace")
    except subprocess.TimeoutExpired:
        return "no answer", ""
    if run.returncode == 0:
        return "accepted", ""
    error = CODE.search(run.stdout + run.stderr)
    if error is None:
        return f"exit code {run.returncode}", (run.stdout + run.stderr).strip().split("\n")[0]
    place = PLACE.search(run.stdout + run.stderr, error.end())
    line = f"line {place.group(1)}: " if place else ""
    return error.group(1), line + error.group(2)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("stanok")
    parser.add_argument("machine")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--dialect", choices=["stanok", "linuxcnc", "fanuc", "haas"], default="stanok")
    parser.add_argument("--code-system", choices=["A", "B", "C"])
    parser.add_argument("--show", type=int, default=2, help="examples of each class")
    parser.add_argument("--timeout", type=float, default=60.0)
    parser.add_argument("--json", action="store_true", help="print the class of each program as JSON")
    options = parser.parse_args()
    machine = machine_in_dialect(options.machine, options.dialect, options.code_system)
    classes = collections.defaultdict(list)
    try:
        for program in programs_of(options.folders):
            kind, message = check(options.stanok, machine, program, options.timeout)
            classes[kind].append((program, message))
    finally:
        os.unlink(machine)
    if options.json:
        json.dump({kind: [name for name, _ in found] for kind, found in classes.items()}, sys.stdout, indent=1)
        return
    total = sum(len(found) for found in classes.values())
    print(f"{total} programs in the dialect {options.dialect} {options.code_system or ''}".rstrip())
    for kind, found in sorted(classes.items(), key=lambda item: -len(item[1])):
        print(f"  {len(found):5} {kind}")
        for program, message in found[: options.show if kind != "accepted" else 0]:
            print(f"          {program}: {message}")


if __name__ == "__main__":
    main()
