"""Post-processor of stanok for FreeCAD's Path (CAM) workbench, FreeCAD 0.20 and later.

Copy this one file into FreeCAD's macro folder and choose `stanok` as the post-processor of the job. The guide is
docs/programmer/cam-freecad.md. FreeCAD calls export(objects, filename, arguments) with the work offsets, tool
controllers and operations of a job in their order. Nothing of FreeCAD is imported: the file reads attributes only
(Path.Commands, Label, Tool, Stock), in FreeCAD's units mm, mm/s and degrees, and it stands alone because FreeCAD
loads a post from a single file (docs/developer/adr/0052-posts-stand-alone.md). FreeCAD 0.20 may bring Python 3.8.

A command that this file does not know is a PostError that names operation and command. Nothing is left out silently.
"""

import argparse
import math
import re
import shlex

TOOLTIP = "Programs for stanok: tool lengths, canned cycles, helical arcs, and the blank for the virtual workpiece."

MM_PER_INCH = 25.4
CYCLES = ("G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G89")
TAPS = ("G74", "G84")
PASSED = ("G40", "G80", "G90", "G94", "G98", "G99", "M0", "M1")
PLANES = {"G17": ("X", "Y", "Z"), "G18": ("Z", "X", "Y"), "G19": ("Y", "Z", "X")}
CENTRE = {"X": "I", "Y": "J", "Z": "K"}
ROTARY = ("A", "B", "C")
OFFSET = re.compile(r"G5[4-9]|G59\.[1-3]|G54\.1P[1-9][0-9]*")
COOLANTS = {"None": "M9", "Flood": "M8", "Mist": "M7"}
SAME_POINT_MM = 1e-6  # two computed points that FreeCAD means to be one


class PostError(Exception):
    """What keeps the job from becoming a program, and what to change."""


# ---- options ---------------------------------------------------------------------------------------------------


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise PostError(f"stanok post: {message}\n{self.format_help()}")


def _work_offset(text):
    name = text.upper().replace(" ", "")
    if not OFFSET.fullmatch(name):
        raise argparse.ArgumentTypeError(f"{text} is no work offset; write G54 to G59, G59.1 to G59.3 or G54.1P1 and on")
    return name


def _parser():
    parser = _Parser(prog="stanok", add_help=False, allow_abbrev=False)
    add = parser.add_argument
    add("--no-header", action="store_true", help="leave out dialect, job, tool list and blank")
    add("--no-comments", action="store_true", help="leave out all comments")
    add("--no-blank", action="store_true", help="leave out #workpiece")
    add("--line-numbers", action="store_true", help="number the blocks N10, N20, ...")
    add("--inches", action="store_true", help="write G20 and inches")
    add("--precision", type=int, choices=range(1, 7), help="decimals of lengths; default 3, with --inches 4")
    add("--dialect", choices=("stanok", "linuxcnc", "fanuc", "haas"), default="stanok", help="dialect in the first line")
    add("--wcs", type=_work_offset, help="work offset in place of that of the job, for example G54.1P5")
    add("--retract", choices=("g53", "g28", "none"), default="g53", help="how Z goes up before a tool change")
    add("--safe-z", type=float, default=0.0, help="machine coordinate of --retract g53, in mm; default 0")
    add("--blank-resolution", type=float, help="resolution of #workpiece in mm; default 1/400 of the longest side")
    add("--blank-file", help="STL file of the blank, in mm and in the coordinates of the job, in place of the stock")
    return parser


TOOLTIP_ARGS = _parser().format_help()


def _options(arguments):
    return _parser().parse_args(shlex.split(arguments or ""))


# ---- text of blocks --------------------------------------------------------------------------------------------


class _Text:
    """The lines of a program: numbers of blocks, comments, and numbers in the unit of the program."""

    def __init__(self, options):
        self.lines = []
        self._number = 0
        self._options = options
        self._scale = 1 / MM_PER_INCH if options.inches else 1.0
        self.decimals = options.precision or (4 if options.inches else 3)

    def block(self, *words):
        prefix = ""
        if self._options.line_numbers:
            self._number += 10
            prefix = f"N{self._number} "
        self.lines.append(prefix + " ".join(words))

    def directive(self, text):
        self.lines.append(text)

    def comment(self, text):
        if not self._options.no_comments:
            inside = " ".join(str(text).split()).replace("(", "[").replace(")", "]")
            self.lines.append(f"({inside})")

    def rounded(self, millimetres):
        return round(millimetres * self._scale, self.decimals) + 0.0  # no negative zero

    def length(self, millimetres):
        return _shortest(self.rounded(millimetres), self.decimals)


def _shortest(value, decimals):
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def _with_point(seconds):
    """Seconds with a decimal point: in the dialects fanuc and haas P without one is milliseconds."""
    text = _shortest(seconds, 3)
    return text if "." in text else text + "."


# ---- motion ----------------------------------------------------------------------------------------------------


def _sweep(start, end, centre, clockwise):
    """Angle of an arc in rad, above 0 and at most a full turn."""
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    last = math.atan2(end[1] - centre[1], end[0] - centre[0])
    angle = (first - last if clockwise else last - first) % (2 * math.pi)
    return angle if math.dist(start, end) > SAME_POINT_MM else 2 * math.pi


class _Motion:
    """Moves as blocks: only what has changed. The position is forgotten where the control moves by itself.

    FreeCAD's operations begin with a rapid of Z alone. After a retract that one would go down where the last operation
    ended, in another work offset perhaps into its part. So Z waits until a rapid has gone over the new point.
    """

    def __init__(self, text):
        self._text = text
        self._plane = "G17"
        self.forget(is_up=False)

    def forget(self, is_up):
        self._at = {}
        self._code = self._feed = None
        self._goes_over = is_up
        self._height = None  # of a rapid of Z that waits

    def forget_height(self):
        self._at.pop("Z", None)

    def plane(self, code):
        if code != self._plane:
            self._text.block(code)
            self._plane = code

    def line(self, code, words, feed_mm_per_min):
        if self._goes_over and code == "G0":
            self._go_over(words)
        else:
            self._go_down()
            self._line(code, words, feed_mm_per_min)

    def _go_over(self, words):
        self._height = words.get("Z", self._height)
        self._line("G0", {axis: value for axis, value in words.items() if axis != "Z"}, None)
        if "X" in self._at and "Y" in self._at:
            self._go_down()

    def _go_down(self):
        if self._goes_over and self._height is not None:
            self._line("G0", {"Z": self._height}, None)
        self._goes_over = False

    def _line(self, code, words, feed_mm_per_min):
        changed = [f"{axis}{self._value(axis, value)}" for axis, value in words.items() if self._differs(axis, value)]
        self._at.update(words)
        if changed:
            self._move(code, changed, feed_mm_per_min)

    def arc(self, code, words, feed_mm_per_min):
        self._go_down()
        first, second, third = PLANES[self._plane]
        self._require((first, second))
        if abs(words.get(CENTRE[third], 0.0)) > SAME_POINT_MM:
            raise ValueError(f"{CENTRE[third]} does not belong to an arc in {self._plane}")
        start = [self._at[first], self._at[second]]
        end = [words.get(first, start[0]), words.get(second, start[1])]
        centre = [start[0] + words.get(CENTRE[first], 0.0), start[1] + words.get(CENTRE[second], 0.0)]
        if math.dist(start, centre) <= SAME_POINT_MM:
            raise ValueError("the arc has no centre")
        ends = {axis: value for axis, value in words.items() if axis in "XYZ"}
        if self._collapses(start, end, _sweep(start, end, centre, code == "G2")):
            self.line("G1", ends, feed_mm_per_min)
            return
        ends.update({first: end[0], second: end[1]})
        written = [axis for axis in "XYZ" if axis in (first, second) or axis in ends and self._differs(axis, ends[axis])]
        changed = [f"{axis}{self._value(axis, ends[axis])}" for axis in written]
        changed += [f"{CENTRE[axis]}{self._from_start(axis, value)}" for axis, value in zip((first, second), centre)]
        self._at.update(ends)
        self._move(code, changed, feed_mm_per_min)

    def cycle(self, code, words, feed_mm_per_min):
        self._go_down()
        self._code = None
        self._move(code, words, feed_mm_per_min)

    def at(self, words):
        self._at.update(words)

    def _require(self, axes):
        unknown = [axis for axis in axes if axis not in self._at]
        if unknown:
            raise ValueError(f"the arc begins where {' and '.join(unknown)} are not known; begin with a move to them")

    def _collapses(self, start, end, sweep):
        """A short arc whose ends round to one point would be a full circle."""
        same = all(self._text.rounded(a) == self._text.rounded(b) for a, b in zip(start, end))
        return same and sweep < math.pi

    def _from_start(self, axis, centre):
        start = self._text.rounded(self._at[axis])
        value = self._text.rounded(centre) - start
        return _shortest(round(value, self._text.decimals) + 0.0, self._text.decimals)

    def _value(self, axis, value):
        return _shortest(round(value, 4) + 0.0, 4) if axis in ROTARY else self._text.length(value)

    def _differs(self, axis, value):
        return axis not in self._at or self._value(axis, self._at[axis]) != self._value(axis, value)

    def _move(self, code, words, feed_mm_per_min):
        block = [] if code == self._code else [code]
        self._code = code
        block += words
        if feed_mm_per_min is not None:
            feed = self._text.length(feed_mm_per_min)
            if float(feed) <= 0:
                raise ValueError("the feed is 0; set the feeds of the tool controller")
            if feed != self._feed:
                block.append(f"F{feed}")
                self._feed = feed
        self._text.block(*block)


# ---- commands of FreeCAD ---------------------------------------------------------------------------------------


class _Post:
    """Follows the commands of the objects and keeps what of tool, spindle, offset and coolant is active."""

    def __init__(self, text, options):
        self._text = text
        self._options = options
        self._motion = _Motion(text)
        self._tool = self._offset = self._speed = None
        self._coolant = "M9"
        self._spindle = "M5"
        self._is_up = False
        self._blank = None

    def begin(self, blank):
        self._text.block("G20" if self._options.inches else "G21", "G90", "G94", "G17", "G40", "G49", "G80", "G91.1")
        self._blank = blank

    def end(self):
        self._stop()
        self._text.block("M30")

    def run(self, obj):
        """Writes an operation, a tool controller or a work offset."""
        mode = _property(obj, "CoolantMode", None)
        if mode is not None:
            self._cool(str(mode), obj.Label)
        commands = obj.Path.Commands
        fixture = _is_fixture(commands)
        for command in commands[:1] if fixture else commands:
            try:
                self._follow(_name(command), dict(command.Parameters), obj)
            except ValueError as fault:
                raise PostError(f"stanok post: operation {obj.Label}: {_shown(command)}: {fault}") from fault

    def _cool(self, mode, label):
        if mode not in COOLANTS:
            raise PostError(f"stanok post: operation {label}: coolant {mode} is unknown; use None, Flood or Mist")
        self._switch(COOLANTS[mode])

    def _switch(self, code):
        if code != self._coolant:
            if self._coolant != "M9" and code != "M9":
                self._text.block("M9")
            self._text.block(code)
            self._coolant = code

    def _follow(self, name, words, obj):
        if name.startswith("("):
            self._text.comment(re.sub(r"\)$", "", name[1:]))
        elif name == "M6":
            self._change(words)
        elif name in ("M3", "M4", "M5"):
            self._turn(name, words)
        elif name in ("G0", "G1", "G2", "G3") or name in CYCLES:
            self._move(name, words, obj)
        elif OFFSET.fullmatch(name) or name in ("G54.1", "G53") or name.startswith("G59."):
            self._choose_offset(name, words)
        elif name in PLANES:
            self._motion.plane(name)
        elif name == "G4":
            self._text.block("G4", "P" + _with_point(_needed(words, "P")))
        elif name in ("M7", "M8", "M9"):
            self._switch(name)
        elif name in PASSED:
            self._pass(name)
        else:
            raise ValueError("this command is unknown to the post; remove it from the operation")

    def _pass(self, name):
        if name == "G80":
            self._motion.forget_height()
        self._text.block(name)

    def _change(self, words):
        number = int(_needed(words, "T"))
        self._stop()
        self._text.block(f"T{number}", "M6")
        self._text.block("G43", f"H{number}")
        self._tool = number

    def _turn(self, code, words):
        speed = words.get("S", self._speed)
        if code != "M5" and not speed:
            raise ValueError("the spindle speed is 0; set it in the tool controller, or its direction to None")
        if (code, speed) != (self._spindle, self._speed):
            self._text.block(*([] if code == "M5" else [f"S{_shortest(speed, 1)}"]), code)
        self._spindle, self._speed = code, speed

    def _stop(self):
        """Z up in machine coordinates, then coolant and spindle off."""
        self._retract()
        self._switch("M9")
        if self._spindle != "M5":
            self._turn("M5", {})

    def _retract(self):
        if self._is_up:
            return
        self._is_up = True
        if self._options.retract == "g53":
            self._text.block("G53", "G0", "Z" + self._text.length(self._options.safe_z))
        elif self._options.retract == "g28":
            self._text.block("G91", "G28", "Z0")
            self._text.block("G90")
        self._motion.forget(is_up=self._options.retract != "none")

    def _choose_offset(self, name, words):
        if name == "G54.1":
            name = f"G54.1P{int(_needed(words, 'P'))}"
        if not self._options.wcs and not OFFSET.fullmatch(name):
            raise ValueError("no work offset of stanok; choose G54 to G59.3 in the job, or --wcs=G54.1P1")
        if self._options.wcs and self._offset not in (None, name):
            raise ValueError(f"the job has several work offsets, which --wcs={self._options.wcs} would make one")
        if name != self._offset:
            self._retract()
            self._write_offset(self._options.wcs or name)
            self._offset = name

    def _write_offset(self, name):
        self._text.block(*re.fullmatch(r"(G54\.1)(P\d+)", name).groups() if "P" in name else [name])
        if self._blank:
            self._text.directive(self._blank)
            self._blank = None

    def _move(self, name, words, obj):
        if self._tool is None:
            raise ValueError("the move comes before the first tool; give the operation a tool controller")
        if self._offset is None:
            self._choose_offset(self._options.wcs or "G54", {})
        self._is_up = False
        feed = None if name == "G0" else _needed(words, "F") * 60
        if name in CYCLES:
            self._hole(name, words, feed, obj)
            return
        axes = {axis: words[axis] for axis in ("X", "Y", "Z") + ROTARY if axis in words}
        if feed is not None and any(axis in words for axis in ROTARY):
            raise ValueError("rotary axes at feed are not written; position them by a rapid move")
        if name in ("G2", "G3"):
            self._motion.arc(name, {**axes, **{word: words[word] for word in "IJK" if word in words}}, feed)
        else:
            self._motion.line(name, axes, feed)

    def _hole(self, name, words, feed, obj):
        if name in TAPS:
            feed = self._tap(words, obj)
        text = [f"{word}{self._text.length(words[word])}" for word in "XYZRQ" if word in words]
        if words.get("P"):
            text.append("P" + _with_point(words["P"]))
        if words.get("L", 1) != 1:
            text.append(f"L{int(words['L'])}")
        self._motion.cycle(name, text, feed)
        self._motion.at({axis: words[axis] for axis in "XY" if axis in words})
        self._motion.forget_height()

    def _tap(self, words, obj):
        """Feed of a tap in mm/min: its pitch, which is a property of FreeCAD's tool, times the speed."""
        pitch = _number(getattr(getattr(getattr(obj, "ToolController", None), "Tool", None), "Pitch", None))
        if not pitch:
            raise ValueError("the tool has no pitch; use a tap with its property Pitch")
        speed = words.get("S") or self._speed
        if not speed:
            raise ValueError("the spindle speed is 0; set it in the tool controller")
        if speed != self._speed:
            self._turn("M4" if self._spindle == "M4" else "M3", {"S": speed})
        return pitch * speed


def _name(command):
    """G01 as G1, and capitals; a comment as it is."""
    name = command.Name.strip()
    if name.startswith("("):
        return name
    return re.sub(r"^([GM])0+(?=\d)", r"\1", name.upper())


def _shown(command):
    words = " ".join(f"{word}{value:g}" for word, value in sorted(command.Parameters.items()))
    return f"{command.Name} {words}".strip()


def _needed(words, letter):
    if letter not in words:
        raise ValueError(f"{letter} is missing")
    return words[letter]


def _number(value):
    """A number of FreeCAD, which may be a quantity; None where it is none."""
    value = getattr(value, "Value", value)
    return float(value) if isinstance(value, (int, float)) else None


def _is_fixture(commands):
    """FreeCAD's object of a work offset: the code, and a move of Z that the retract of this post replaces."""
    names = [_name(command) for command in commands]
    return len(names) == 2 and names[1] == "G0" and set(commands[1].Parameters) == {"Z"} and names[0].startswith("G5")


# ---- header ----------------------------------------------------------------------------------------------------


def _job_of(objects):
    """The job that the objects belong to, found through the objects that refer to them; None if there is none."""
    waiting, seen = list(objects), set()
    while waiting:
        obj = waiting.pop(0)
        if id(obj) in seen:
            continue
        seen.add(id(obj))
        if hasattr(obj, "Stock") and hasattr(obj, "Operations"):
            return obj
        waiting += getattr(obj, "InList", [])
    return None


TOOL_WORDS = (("Diameter", "D"), ("CornerRadius", "corner radius "), ("TorusRadius", "corner radius "),
              ("TipAngle", "point angle "), ("CuttingEdgeAngle", "angle "), ("TipDiameter", "tip D"),
              ("CuttingEdgeHeight", "flutes "), ("ShankDiameter", "shank D"), ("Length", "length "), ("Pitch", "pitch "))


def _tool_line(controller):
    tool = controller.Tool
    parts = [f"T{controller.ToolNumber}: {tool.Label}"]
    shape = getattr(tool, "ShapeName", None)
    parts += [shape] if shape else []
    for attribute, name in TOOL_WORDS:
        value = _number(getattr(tool, attribute, None))
        if value is not None:
            parts.append(name + _shortest(value, 3))
    return ", ".join(parts)


def _tool_lines(objects):
    """One line for each tool number, lengths in mm and angles in degrees."""
    controllers = {obj.ToolNumber: obj for obj in reversed(objects) if hasattr(obj, "ToolNumber") and hasattr(obj, "Tool")}
    return [_tool_line(controllers[number]) for number in sorted(controllers)]


def _is_upright_cylinder(stock):
    radius, height = (_number(getattr(stock, key, None)) for key in ("Radius", "Height"))
    box = stock.Shape.BoundBox
    if radius is None or height is None:
        return False
    sides = ((box.XLength, 2 * radius), (box.YLength, 2 * radius), (box.ZLength, height))
    return all(abs(side - wanted) < 1e-3 for side, wanted in sides)


def _blank_line(job, text, options):
    """#workpiece of the stock: a file if one is named, a cylinder along Z as such, everything else as the box around it.
    None without stock."""
    stock = getattr(job, "Stock", None)
    if stock is None:
        return None
    box = stock.Shape.BoundBox
    resolution = options.blank_resolution or max(box.XLength, box.YLength, box.ZLength) / 400
    values = [text.length(value) for value in (box.XLength, box.YLength, box.ZLength, -box.XMin, -box.YMin, -box.ZMin)]
    if options.blank_file:
        return f'#workpiece (2, {_shortest(resolution, 4)}, 0, "{options.blank_file}", 0, 0, 0)'
    kind = 0
    if _is_upright_cylinder(stock):
        middle = (text.length(-(box.XMin + box.XMax) / 2), text.length(-(box.YMin + box.YMax) / 2))
        kind, values = 1, [values[0], "0", values[2], *middle, values[5]]
    return f"#workpiece ({kind}, {_shortest(resolution, 4)}, 0, {', '.join(values)})"


def _header(text, job, objects, options):
    if options.no_header:
        return
    text.lines.append(f"(dialect {options.dialect})")
    if job is not None:
        text.comment(f"job: {job.Label}")
    for line in _tool_lines(objects):
        text.comment(line)


# ---- entry point -----------------------------------------------------------------------------------------------


def _property(obj, name, default):
    """A property of an operation, or of the operation that a dressup wraps."""
    while obj is not None:
        if hasattr(obj, name):
            return getattr(obj, name)
        obj = getattr(obj, "Base", None)
        if isinstance(obj, (list, tuple)):
            return default
    return default


def _program(objects, options):
    text = _Text(options)
    job = _job_of(objects)
    post = _Post(text, options)
    _header(text, job, objects, options)
    post.begin(None if options.no_blank or options.no_header else _blank_line(job, text, options))
    for obj in objects:
        if not hasattr(obj, "Path"):
            raise PostError(f"stanok post: {obj.Label} has no path; select operations or a job")
        if not _property(obj, "Active", True):
            continue
        if not _is_fixture(obj.Path.Commands) and not hasattr(obj, "ToolNumber"):
            text.comment(f"operation: {obj.Label}")
        post.run(obj)
    post.end()
    return "\n".join(text.lines) + "\n"


def export(objects, filename, argstring):
    """Writes the program of the objects into the file, unless its name is "-", and returns its text."""
    program = _program(list(objects), _options(argstring))
    if filename != "-":
        with open(filename, "w", encoding="utf-8", newline="\n") as file:
            file.write(program)
    return program
