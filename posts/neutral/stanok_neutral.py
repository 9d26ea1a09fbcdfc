#!/usr/bin/env python3
"""Neutral post of stanok: a job in JSON becomes a part program. The format is described in docs/programmer/posts.md.

usage: stanok_neutral.py JOB.json [-o PROGRAM.nc] [options]

Any CAM system whose post can write JSON, and any program that computes tool paths, can use it. Exit code 1: the job
has a fault, which is printed with operation and move; nothing is written.
"""

import argparse
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import stanok_program as program  # noqa: E402: it lies beside this file

JOB_KEYS = ("name", "units", "offset", "blank", "tools", "operations", "machine")
OPERATION_KEYS = ("name", "tool", "speed", "spindle", "coolant", "offset", "plane", "five_axis", "moves")
TOOL_KEYS = ("number", "name", "kind", "diameter", "corner_radius", "point_angle", "flute_length", "length")
BLANK_KEYS = ("box", "cylinder", "zero", "resolution")
PLANE_KEYS = ("origin", "euler", "normal", "x")
MACHINE_KEYS = ("dialect", "decimals", "retract", "safe_z", "line_numbers", "comments")
FIVE_AXIS = {"vectors": program.Vectors(), "angles": program.Angles()}


def _known(value, keys, what):
    """The object, if it has no key but these: a typing error must not change a part."""
    if not isinstance(value, dict):
        raise program.ProgramError(f"{what} must be an object, not {value!r}")
    for key in value:
        if key not in keys:
            raise program.ProgramError(f'{what} has the unknown key "{key}"; known are {", ".join(keys)}')
    return value


def _required(value, key, what):
    if key not in value:
        raise program.ProgramError(f'{what} lacks "{key}"')
    return value[key]


def _numbers(value, count, what, gaps=False):
    """A list of numbers; with gaps, null leaves a coordinate as it is."""
    is_number = [gaps and item is None or _is_number(item) for item in value] if isinstance(value, list) else [False]
    if not all(is_number) or len(value) != count:
        raise program.ProgramError(f"{what} must be a list of {count} numbers, not {value!r}")
    return tuple(value)


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _number(move, key):
    value = move.get(key)
    if value is not None and not _is_number(value):
        raise program.ProgramError(f'"{key}" must be a number, not {value!r}')
    return value


# ---- moves -----------------------------------------------------------------------------------------------------


def _line(writer, move, code):
    _known(move, ("rapid", "tool", "angles") if code == "rapid" else ("feed", "f", "tool", "angles"), "the move")
    point = _numbers(move[code], 3, f'"{code}"', gaps=True)
    vector = _numbers(move["tool"], 3, '"tool"') if "tool" in move else None
    angles = _known(move["angles"], ("A", "B", "C"), '"angles"') if "angles" in move else None
    for axis in angles or ():
        _number(angles, axis)
    if code == "rapid":
        writer.rapid(point, vector, angles)
    else:
        writer.feed(point, _number(move, "f"), vector, angles)


def _arc(writer, move):
    _known(move, ("arc", "to", "center", "f", "plane", "turns"), "the move")
    turns = move.get("turns", 1)
    if not isinstance(turns, int) or turns < 1:
        raise program.ProgramError(f'"turns" must be a whole number from 1 on, not {turns!r}')
    center = _numbers(_required(move, "center", "the arc"), 2, '"center"')
    point = _numbers(_required(move, "to", "the arc"), 3, '"to"', gaps=True)
    writer.arc(move["arc"], point, center, _number(move, "f"), move.get("plane", "xy"), turns)


def _drill(writer, move):
    _known(move, ("drill", "points", "top", "bottom", "f", "peck", "dwell", "pitch", "back_to"), "the move")
    points = [_numbers(point, 2, "a point") for point in _required(move, "points", "the drilling cycle")]
    top, bottom = (_required(move, key, "the drilling cycle") for key in ("top", "bottom"))
    _number(move, "top"), _number(move, "bottom")
    values = {key: _number(move, key) for key in ("peck", "dwell", "pitch")}
    writer.drill(move["drill"], points, top, bottom, _number(move, "f"), back_to=move.get("back_to", "initial"), **values)


def _dwell(writer, move):
    _known(move, ("dwell",), "the move")
    seconds = _number(move, "dwell")
    if not seconds or seconds < 0:
        raise program.ProgramError('"dwell" must be above 0 s')
    writer.dwell(seconds)


def _stop(writer, move):
    _known(move, ("stop",), "the move")
    if move["stop"] not in ("always", "optional"):
        raise program.ProgramError(f'"stop" is {move["stop"]!r}; it must be always or optional')
    writer.stop(optional=move["stop"] == "optional")


def _comment(writer, move):
    _known(move, ("comment",), "the move")
    writer.comment(move["comment"])


MOVES = {"rapid": lambda writer, move: _line(writer, move, "rapid"),
         "feed": lambda writer, move: _line(writer, move, "feed"),
         "arc": _arc, "drill": _drill, "dwell": _dwell, "stop": _stop, "comment": _comment}


def _move(writer, move):
    kinds = [kind for kind in MOVES if kind in _known(move, tuple(move), "a move")]
    kinds = ["drill"] if "drill" in kinds else kinds  # it has a key "dwell" of its own
    if len(kinds) != 1:
        raise program.ProgramError(f"a move has one of the keys {', '.join(MOVES)}; this one is {json.dumps(move)}")
    MOVES[kinds[0]](writer, move)


# ---- operations and the job ------------------------------------------------------------------------------------


def _orientation(operation):
    if "plane" in operation and "five_axis" in operation:
        raise program.ProgramError('"plane" and "five_axis" exclude each other')
    if "five_axis" in operation:
        if operation["five_axis"] not in FIVE_AXIS:
            raise program.ProgramError(f'"five_axis" is {operation["five_axis"]!r}; it must be vectors or angles')
        return FIVE_AXIS[operation["five_axis"]]
    if "plane" not in operation:
        return program.Upright()
    plane = _known(operation["plane"], PLANE_KEYS, '"plane"')
    origin = _numbers(plane.get("origin", [0, 0, 0]), 3, '"origin"')
    if ("euler" in plane) == ("normal" in plane):
        raise program.ProgramError('"plane" needs either "euler" or "normal"')
    if "euler" in plane:
        return program.Plane(origin, _numbers(plane["euler"], 3, '"euler"'))
    along_x = _numbers(plane["x"], 3, '"x"') if "x" in plane else None
    return program.Plane.of_normal(origin, _numbers(plane["normal"], 3, '"normal"'), along_x)


def _begin_operation(writer, operation, job):
    _known(operation, OPERATION_KEYS, "the operation")
    tool = _required(operation, "tool", "the operation")
    if not isinstance(tool, int) or tool < 1:
        raise program.ProgramError(f'"tool" must be a whole number from 1 on, not {tool!r}')
    writer.begin_operation(operation.get("name", "no name"), tool, _number(operation, "speed"),
                           operation.get("spindle", "cw"), operation.get("coolant", "off"),
                           operation.get("offset", job.get("offset", "G54")), _orientation(operation))


def _write_operation(writer, operation, job, number):
    where = f'operation {number} "{operation.get("name", "")}"' if isinstance(operation, dict) else f"operation {number}"
    try:
        _begin_operation(writer, operation, job)
        moves = _required(operation, "moves", "the operation")
    except program.ProgramError as fault:
        raise program.ProgramError(f"{where}: {fault}") from fault
    for index, move in enumerate(moves, 1):
        try:
            _move(writer, move)
        except program.ProgramError as fault:
            raise program.ProgramError(f"{where}, move {index}: {fault}") from fault


def _tool_line(tool):
    _known(tool, TOOL_KEYS, "a tool")
    number = _required(tool, "number", "a tool")
    parts = [f"T{number}: {tool.get('name', 'no name')}"]
    parts += [f"{key.replace('_', ' ')} {tool[key]}" for key in TOOL_KEYS[2:] if key in tool]
    return ", ".join(parts)


def _blank(job):
    if "blank" not in job:
        return None
    blank = _known(job["blank"], BLANK_KEYS, '"blank"')
    kinds = [kind for kind in ("box", "cylinder") if kind in blank]
    if len(kinds) != 1:
        raise program.ProgramError('"blank" needs either "box" or "cylinder"')
    size = _numbers(blank[kinds[0]], 3, f'"{kinds[0]}"')
    zero = _numbers(_required(blank, "zero", '"blank"'), 3, '"zero"')
    return program.Blank(size, zero, kinds[0], _number(blank, "resolution"))


def program_of(job, **overrides):
    """The text of the program of a job, a dictionary as read from JSON. Overrides are keys of "machine"."""
    _known(job, JOB_KEYS, "the job")
    machine = {**_known(job.get("machine", {}), MACHINE_KEYS, '"machine"'), **overrides}
    writer = program.ProgramWriter(program.Settings(units=job.get("units", "mm"), **machine))
    operations = _required(job, "operations", "the job")
    tilts = any(isinstance(operation, dict) and {"plane", "five_axis"} & operation.keys() for operation in operations)
    writer.begin(job.get("name", "no name"), [_tool_line(tool) for tool in job.get("tools", [])], _blank(job), tilts)
    for number, operation in enumerate(operations, 1):
        _write_operation(writer, operation, job, number)
    return writer.end()


# ---- command line ----------------------------------------------------------------------------------------------


def _arguments(arguments):
    parser = argparse.ArgumentParser(description="writes a part program of stanok from a job in JSON")
    parser.add_argument("job", help="file of the job; - reads standard input")
    parser.add_argument("-o", "--out", help="file of the program; default: standard output")
    parser.add_argument("--dialect", choices=program.DIALECTS, help="dialect in the first line")
    parser.add_argument("--decimals", type=int, help="decimals of lengths")
    parser.add_argument("--retract", choices=program.RETRACTS, help="how Z goes up before a tool change")
    parser.add_argument("--safe-z", dest="safe_z", type=float, help="machine coordinate of --retract g53")
    parser.add_argument("--line-numbers", dest="line_numbers", action="store_true", default=None, help="number the blocks")
    parser.add_argument("--no-comments", dest="comments", action="store_false", default=None, help="leave out comments")
    return parser.parse_args(arguments)


def main(arguments):
    options = vars(_arguments(arguments))
    source, target = options.pop("job"), options.pop("out")
    try:
        with sys.stdin if source == "-" else open(source, encoding="utf-8") as file:
            job = json.load(file)
        text = program_of(job, **{key: value for key, value in options.items() if value is not None})
    except (OSError, json.JSONDecodeError, program.ProgramError) as fault:
        print(f"{source}: {fault}", file=sys.stderr)
        return 1
    if target is None:
        sys.stdout.write(text)
    else:
        pathlib.Path(target).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
