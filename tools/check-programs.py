#!/usr/bin/env python3
"""Runs `stanok check` over folders of programs and counts what becomes of them, dialect by dialect.

    tools/check-programs.py build/release/bin/stanok config/machines/mill3.toml --dialect fanuc FOLDER...
    tools/check-programs.py ... --code-system A --declare M31 M33 --show 3 FOLDER...
    tools/check-programs.py build/release/bin/stanok tests/peers/rs274/mill6.toml --dialect linuxcnc --peer FOLDER...

With --peer each program also goes through rs274 of LinuxCNC (tests/peers/rs274), and the classes are: identical to the
peer, different from it, accepted where the peer refuses, refused by both, and refused here alone. --declare names codes
of the machine builder that a shop would have in [channel.codes]. --judged names a text with a line `END OF PATH: reason`
for each program whose refusal or difference was traced and is right; what is refused or different besides is counted
as wrong.

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
from pathlib import Path

sys.dont_write_bytecode = True
PEER = Path(__file__).resolve().parent.parent / "tests" / "peers" / "rs274"
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


def machine_in_dialect(machine, dialect, code_system, declared):
    """The machine file with the dialect of its first channel, in the same folder so that its paths hold."""
    with open(machine, encoding="utf-8") as file:
        text = file.read()
    keys = f'[[channel]]\ndialect = "{dialect}"\n'
    if code_system:
        keys += f'code_system = "{code_system}"\n'
    if declared:
        if "[channel.codes]" in text:
            raise SystemExit(f"{machine} has [channel.codes] already: declare the codes there")
        text += "\n[channel.codes]\n" + "".join(f'{code} = "before"\n' for code in declared)
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


def compare(stanok, machine, program, kind):
    """The class of a program beside rs274: (class, first difference or what the refuser says)."""
    sys.path.insert(0, str(PEER))
    import canonical_calls
    import stanok_records
    from compare import first_difference
    from events import without_standing_moves

    program = Path(program).resolve()
    with tempfile.TemporaryDirectory() as folder:
        parameters = Path(folder) / "parameters.var"
        parameters.write_text("5220\t1\n")
        try:
            theirs = canonical_calls.events_of(program, PEER / "mill6.tbl", parameters)
        except canonical_calls.Refused as refusal:
            return ("accepted, refused by the peer" if kind == "accepted" else "refused by both"), str(refusal)
        except (canonical_calls.Unknown, subprocess.TimeoutExpired) as reason:
            return "not compared", str(reason)[:200]
    if kind != "accepted":
        return "refused here alone", kind
    try:
        ours = stanok_records.events_of(stanok, program, Path(machine))
    except canonical_calls.Refused as refusal:
        return "refused here alone", str(refusal).split("\n")[0]
    found = first_difference(without_standing_moves(ours), without_standing_moves(theirs))
    return ("different", found) if found else ("identical", "")


def judgements(file):
    """Ends of paths of programs that were judged, with the reason."""
    with open(file, encoding="utf-8") as lines:
        pairs = (line.split(":", 1) for line in lines if ":" in line and not line.startswith("#"))
        return {name.strip(): reason.strip() for name, reason in pairs}


def judged_class(kind, program, judged):
    """The class of a program, by its judgement where it has one; what is refused rightly by both is right."""
    reason = next((why for name, why in judged.items() if program.endswith(name)), None)
    if kind in ("accepted", "identical", "accepted, refused by the peer", "refused by both", "not compared"):
        return kind
    if kind == "different":
        return "different on purpose" if reason else "wrong"
    return "rightly refused" if reason else "wrongly refused"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("stanok")
    parser.add_argument("machine")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--dialect", choices=["stanok", "linuxcnc", "fanuc", "haas"], default="stanok")
    parser.add_argument("--code-system", choices=["A", "B", "C"])
    parser.add_argument("--show", type=int, default=2, help="examples of each class")
    parser.add_argument("--timeout", type=float, default=60.0)
    parser.add_argument("--declare", nargs="+", default=[], metavar="CODE", help="codes of the machine builder")
    parser.add_argument("--peer", action="store_true", help="compare with rs274 of LinuxCNC")
    parser.add_argument("--judged", metavar="FILE", help="programs that are refused or different rightly")
    parser.add_argument("--json", action="store_true", help="print the class of each program as JSON")
    options = parser.parse_args()
    machine = machine_in_dialect(options.machine, options.dialect, options.code_system, options.declare)
    judged = judgements(options.judged) if options.judged else None
    classes = collections.defaultdict(list)
    try:
        for program in programs_of(options.folders):
            kind, message = check(options.stanok, machine, program, options.timeout)
            if options.peer:
                kind, found = compare(options.stanok, machine, program, kind)
                message = message or found
            if judged is not None:
                kind = judged_class(kind, program, judged)
            classes[kind].append((program, message))
    finally:
        os.unlink(machine)
    if options.json:
        json.dump({kind: [name for name, _ in found] for kind, found in classes.items()}, sys.stdout, indent=1)
        return
    total = sum(len(found) for found in classes.values())
    print(f"{total} programs in the dialect {options.dialect} {options.code_system or ''}".rstrip())
    if judged is not None and total:
        refused = len(classes.get("wrongly refused", []))
        print(f"  wrongly refused: {100.0 * refused / total:.1f} %, wrong: {len(classes.get('wrong', []))}")
    for kind, found in sorted(classes.items(), key=lambda item: -len(item[1])):
        print(f"  {len(found):5} {kind}")
        for program, message in found[: options.show if kind not in ("accepted", "identical") else 0]:
            print(f"          {program}: {message}")


if __name__ == "__main__":
    main()
