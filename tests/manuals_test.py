#!/usr/bin/env python3
"""Worked examples of manuals, run through `stanok simulate` and judged in machine coordinates.

usage: manuals_test.py STANOK ROOT [--table]      exit code 77: this Python is older than 3.11

tests/manuals/*.toml hold the examples; docs/developer/manuals.md describes their keys and has the counts per
manual, which this test compares (--table prints them). Every program runs in G61.1, in a process of its own.
The path is that of --axis-trace: one row for each cycle.
"""
import json
import math
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

try:
    import tomllib
except ImportError:
    print("left out: this Python has no tomllib")
    sys.exit(77)

WORDS_MAX = 25           # of a quotation
STANDING_MM_PER_S = 0.05  # in G61.1 a cycle of 1 ms beside a stop is slower: j t^2 / 2, with j = 100 m/s^3
STOP_MM = 1e-4           # and no farther from it than j t^3 / 6
END_MM = 1e-6            # of a path that is computed in doubles
PASSED_MM = 1e-3         # beside a chord of a cycle: s^2 / 8 r, with s = 0.1 mm and r = 2 mm, and less
MM = {"mm": 1.0, "inch": 25.4}
POINTS = ("stops", "ends", "passes")
RESULTS = (*POINTS, "end", "error")


def faults_of(example):
    """What an example lacks, as sentences."""
    found = [f"no {key}" for key in ("name", "kind", "source", "quote", "program") if not example.get(key, "").strip()]
    if len(example.get("quote", "").split()) > WORDS_MAX:
        found.append(f"a quotation of more than {WORDS_MAX} words")
    if example.get("kind") not in ("stated", "derived"):
        found.append("a kind that is neither stated nor derived")
    if example.get("kind") == "derived" and not example.get("derivation", "").strip():
        found.append("no derivation")
    if not any(key in example for key in RESULTS):
        found.append("no expected result")
    return found


def undocumented(example, root):
    """Why the difference that an example names is not one that a document states, or none."""
    document, _, words = example["known_difference"].partition(": ")
    if words and words in " ".join((root / document).read_text(encoding="utf-8").split()):
        return None
    return f'{document} has not the words "{words}"'


def examples_of(file):
    """The examples of one file, each with the values that the file gives to all of them."""
    tables = tomllib.loads(file.read_text(encoding="utf-8"))
    common = {key: value for key, value in tables.items() if key != "example"}
    for example in tables["example"]:
        example = {**common, **example, "file": file.name}
        if "address" in common and example.get("source"):
            example["source"] = f'{common["address"]}, {example["source"]}'
        yield example


def tool_table(tools):
    lines = []
    for tool in tools:
        lines.append("[[tool]]")
        lines += [f"{key} = {json.dumps(value)}" for key, value in {"name": f'tool {tool["number"]}', **tool}.items()]
    return "\n".join(lines) + "\n"


def machine_file(example, folder, root):
    """The shipped machine of the example with its dialect, channel keys and tools."""
    text = (root / "config/machines" / f'{example.get("machine", "mill3")}.toml').read_text(encoding="utf-8")
    keys = [f'dialect = "{example["dialect"]}"', *example.get("channel", [])]
    text = re.sub(r'(?m)^(kind = "(?:mill|lathe)")$', lambda found: "\n".join((found[1], *keys)), text, count=1)
    text = re.sub(r"(?m)^tables = .*\n", "", text)
    text = re.sub(r"(?m)^\[machine\]$", '[machine]\ntables = "tools.toml"', text, count=1)
    (folder / "tools.toml").write_text(tool_table(example.get("tools", [])), encoding="utf-8")
    (folder / "machine.toml").write_text(text, encoding="utf-8")
    return folder / "machine.toml"


def read_trace(file, axes):
    """Positions and speeds of the named axes, one pair for each cycle."""
    names, columns, *rows = file.read_text(encoding="utf-8").splitlines()
    column_of = dict(pair.split("=")[::-1] for pair in names.lstrip("# ").split())
    columns = columns.split(",")
    places = [columns.index(column_of.get(axis, axis).lower()) for axis in axes]
    speeds = [columns.index("v" + column_of.get(axis, axis).lower()) for axis in axes]
    for row in rows:
        values = row.split(",")
        yield [float(values[k]) for k in places], math.hypot(*(float(values[k]) for k in speeds))


def stops_of(trace):
    """Where the path stands, from its first point on; a dwell is one stop."""
    stops, slowest = [], None
    for place, speed in [*trace, ([], math.inf)]:
        if speed < STANDING_MM_PER_S:
            slowest = min(slowest or (speed, place), (speed, place))
        elif slowest:
            if not stops or math.dist(stops[-1], slowest[1]) > STOP_MM:
                stops.append(slowest[1])
            slowest = None
    return stops


def distance_to_leg(point, start, end):
    leg = [b - a for a, b in zip(start, end)]
    length_2 = sum(x * x for x in leg)
    along = sum((p - a) * x for p, a, x in zip(point, start, leg)) / length_2 if length_2 else 0.0
    return math.dist(point, [a + min(1.0, max(0.0, along)) * x for a, x in zip(start, leg)])


def first_missed(points, path, tolerance):
    """The first point that the path does not pass in this order, or none."""
    leg = 0
    for point in points:
        while leg + 1 < len(path) and distance_to_leg(point, path[leg], path[leg + 1]) > tolerance:
            leg += 1
        if leg + 1 >= len(path):
            return point
    return None


def first_not_reached(points, stops, tolerance):
    """The first point at which the path does not stop in this order, or none."""
    rest = 0
    for point in points:
        while rest < len(stops) and math.dist(point, stops[rest]) > tolerance:
            rest += 1
        if rest == len(stops):
            return point
    return None


def shown(points, unit):
    return " ".join("(" + ", ".join(f"{value / unit:.6g}" for value in point) + ")" for point in points)


def judge(example, trace, end):
    """Why the path is not the expected one, or none."""
    unit = MM[example.get("unit", "mm")]
    path, stops = [place for place, _ in trace], stops_of(trace)
    in_mm = {key: [[x * unit for x in point] for point in example.get(key, [])] for key in POINTS}
    tolerance = example.get("tolerance", STOP_MM)
    if "stops" in example:
        pairs = zip(stops[1:], in_mm["stops"])
        if len(stops) - 1 != len(in_mm["stops"]) or any(math.dist(a, b) > tolerance for a, b in pairs):
            return f'stops at {shown(stops[1:], unit)}, expected {shown(in_mm["stops"], unit)}'
    missed = first_not_reached(in_mm["ends"], stops, tolerance) or first_missed(
        in_mm["passes"], path, example.get("tolerance", PASSED_MM))
    if missed:
        return f"does not reach {shown([missed], unit)}, stops at {shown(stops[1:], unit)}"
    wanted = [x * unit for x in example.get("end", [])]
    if wanted and math.dist(wanted, end) > example.get("tolerance", END_MM):
        return f"ends at {shown([end], unit)}, expected {shown([wanted], unit)}"
    return None


def report_of(stanok, command, example, folder, root, *more):
    machine = machine_file(example, folder, root)
    program = folder / "example.nc"
    program.write_text("G61.1\n" + example["program"].strip() + "\n", encoding="utf-8")
    return subprocess.run([stanok, command, program, "--machine", machine, "--json", *more], capture_output=True,
                          text=True, errors="replace", timeout=60, check=False)


def checked(stanok, example, folder, root):
    """Whether `check` reports the expected error."""
    found = sorted(set(re.findall(r'"code": ?"(E\d+)"', report_of(stanok, "check", example, folder, root).stdout)))
    return None if example["error"] in found else f'reports {found}, expected {example["error"]}'


def simulated(stanok, example, folder, root):
    axes = example.get("axes", ["X", "Y", "Z"])
    trace_file = folder / "trace.csv"
    run = report_of(stanok, "simulate", example, folder, root, "--axis-trace", f"1={trace_file}")
    if run.returncode:
        alarms = re.findall(r'"alarms":\[.*?\]', run.stdout)
        return f"exit code {run.returncode}: {(run.stderr.strip() or ' '.join(alarms))[:300]}"
    end = json.loads(run.stdout)["channels"][0]["runs"][-1]["end_axes"]
    return judge(example, list(read_trace(trace_file, axes)), [end[axis] for axis in axes])


def outcome(stanok, example, root):
    """Why this example fails, or none."""
    faults = faults_of(example)
    if faults:
        return "; ".join(faults)
    with tempfile.TemporaryDirectory() as folder:
        run = checked if "error" in example else simulated
        why = run(stanok, example, Path(folder), root)
    if "known_difference" not in example:
        return why
    return undocumented(example, root) if why else "is as in the manual, but has a known difference"


def planted():
    """Examples that must fail, so that this test is tested."""
    good = {"name": "planted", "kind": "stated", "source": "this file", "quote": "X is 1.", "dialect": "linuxcnc",
            "file": "planted", "program": "G21 G90\nG0 X1 Y2\nG1 Z3 F600\nM2", "end": [1, 2, 3],
            "stops": [[1, 2, 0], [1, 2, 3]], "ends": [[1, 2, 3]], "passes": [[0.5, 1, 0], [1, 2, 1.5]]}
    yield good, True
    wrong = [{"end": [1, 2, 3.001]}, {"stops": [[1, 2, 3]]}, {"stops": [[1, 2, 0.001], [1, 2, 3]]},
             {"passes": [[1, 2, 1.5], [0.5, 1, 0]]}, {"passes": [[0.5, 0.9, 0]]}, {"ends": [[1, 2, 1.5]]},
             {"ends": [[1, 2, 3], [1, 2, 0]]}, {"error": "E4031"}, {"source": ""},
             {"quote": ""}, {"quote": "word " * (WORDS_MAX + 1)}, {"kind": "derived"}, {"kind": "remembered"},
             {"program": "G21 G90\nG0 X1 Y2 Q7\nM2"}, {"known_difference": "README.md: stanok"},
             {"end": [1, 2, 4], "known_difference": "README.md: words that are not there"}]
    for change in wrong:
        yield {**good, **change}, False


def faults_of_this_test(stanok, root):
    for example, holds in planted():
        why = outcome(stanok, example, root)
        if (why is None) != holds:
            yield f"planted: {why or 'a wrong expectation was not noticed'}"


def column_of(example):
    if example["kind"] == "derived":
        return "derived"
    return "stated errors" if "error" in example else "stated positions"


def table(examples):
    """The counts per manual, as docs/developer/manuals.md has them."""
    columns = ("stated positions", "stated errors", "derived")
    counts = {}
    for example in examples:
        counts.setdefault(example["manual"], dict.fromkeys(columns, 0))[column_of(example)] += 1
    rows = [(manual, *row.values()) for manual, row in counts.items()]
    rows.append(("all", *map(sum, zip(*(row[1:] for row in rows)))))
    lines = ("| " + " | ".join(map(str, row)) + " |" for row in (("manual", *columns), *rows))
    heading, *rest = lines
    return "\n".join([heading, "|---|---|---|---|", *rest])


def main(stanok, root, *options):
    root = Path(root)
    examples = [example for file in sorted((root / "tests/manuals").glob("*.toml")) for example in examples_of(file)]
    if "--table" in options:
        print(table(examples))
        return 0
    faults = list(faults_of_this_test(stanok, root))
    with ThreadPoolExecutor(2) as pool:
        for example, why in zip(examples, pool.map(lambda one: outcome(stanok, one, root), examples)):
            if why:
                faults.append(f'{example["file"]}: {example.get("name", "?")}: {why}')
    if table(examples) not in (root / "docs/developer/manuals.md").read_text(encoding="utf-8"):
        faults.append("docs/developer/manuals.md has other counts: manuals_test.py STANOK ROOT --table")
    print("\n".join(faults))
    print(f"{len(examples)} examples, {len(faults)} faults")
    print(table(examples))
    return 1 if faults or not examples else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
