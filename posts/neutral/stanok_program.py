"""Writes part programs of stanok: the library for posts of CAM systems in Python.

A ProgramWriter holds what is active on the control and writes only what changes. Its methods are the steps of a
program: begin, begin_operation, rapid, feed, arc, drill, dwell, comment, end. All lengths and feeds are in the unit of
the settings, which is the unit of the program; angles are in degrees, speeds in 1/min, times in s. Where the tool is
upright, points are those of the work offset; in a Plane they are those of the plane. The guide is
docs/programmer/posts.md, the language is docs/reference/language.md.
"""

import math
import re
from dataclasses import dataclass, field

DIALECTS = ("stanok", "linuxcnc", "fanuc", "haas")
RETRACTS = ("g53", "g28")
COOLANTS = {"off": "M9", "flood": "M8", "mist": "M7"}
SPINDLES = {"cw": "M3", "ccw": "M4", "off": "M5"}
OFFSET = re.compile(r"G5[4-9]|G59\.[1-3]|G54\.1 P[1-9][0-9]*")
ARC_PLANES = {"xy": ("G17", 0, 1), "zx": ("G18", 2, 0), "yz": ("G19", 1, 2)}
CYCLES = {"drill": "G81", "dwell": "G82", "peck": "G83", "chip": "G73", "tap": "G84", "left_tap": "G74", "bore": "G85",
          "bore_dwell": "G89"}
NEEDS = {"dwell": "dwell", "bore_dwell": "dwell", "peck": "peck", "chip": "peck", "tap": "pitch", "left_tap": "pitch"}
ANGLE_DECIMALS = 6  # 1e-6 deg is 2e-6 mm at 100 mm
SAME_POINT = 1e-6  # two computed points that are meant to be one


class ProgramError(Exception):
    """What cannot be written as a program of stanok, and what to change."""


@dataclass(frozen=True)
class Settings:
    """How programs are written, for one machine and one CAM system."""

    units: str = "mm"  # or "inch"
    dialect: str = "stanok"
    decimals: int | None = None  # of lengths; None: 3, in inches 4
    retract: str = "g53"
    safe_z: float = 0.0  # machine coordinate of the retract "g53"
    line_numbers: bool = False
    comments: bool = True


@dataclass(frozen=True)
class Blank:
    """A box or a cylinder along Z before the cut; `zero` is the program zero from its corner of smallest coordinates,
    for a cylinder from its axis at the smaller Z."""

    size: tuple  # box: X, Y, Z; cylinder: diameter, inner diameter, length
    zero: tuple
    kind: str = "box"
    resolution_mm: float | None = None  # None: 1/400 of the longest side


@dataclass(frozen=True)
class Upright:
    """Three axes: the tool is along Z of the work offset."""


@dataclass(frozen=True)
class Plane:
    """A tilted plane: its zero in the work offset, and Euler angles about Z, the new X and the new Z (G68.2 P0)."""

    origin: tuple
    euler: tuple

    @staticmethod
    def of_normal(origin, normal, along_x=None):
        """The plane square to a vector. X lies along `along_x`, or along the horizontal edge of the plane."""
        z_W = _unit(normal)
        if along_x is None:
            along_x = (-z_W[1], z_W[0], 0.0) if math.hypot(z_W[0], z_W[1]) > 1e-9 else (1.0, 0.0, 0.0)
        x_W = _unit(_without(along_x, z_W))
        return Plane(tuple(origin), _euler_of(x_W, z_W))


@dataclass(frozen=True)
class Vectors:
    """Simultaneous five axes: every move may have the direction from the tip into the spindle (G43.5)."""


@dataclass(frozen=True)
class Angles:
    """Simultaneous five axes: every move may have the angles of the rotary axes of this machine (G43.4)."""


@dataclass
class _Active:
    """What the control has active. None is unknown."""

    tool: int | None = None
    offset: str | None = None
    orientation: object = None
    speed: float | None = None
    spindle: str = "M5"
    coolant: str = "M9"
    arc_plane: str = "G17"
    code: str | None = None
    feed: str | None = None
    point: list = field(default_factory=lambda: [None, None, None])
    others: dict = field(default_factory=dict)  # words I J K of a vector, A B C of angles

    def forget_position(self):
        self.point, self.others, self.code, self.feed = [None, None, None], {}, None, None


def _unit(vector):
    length = math.hypot(*vector)
    if length < 1e-9:
        raise ProgramError(f"the vector {list(vector)} has no length")
    return tuple(value / length for value in vector)


def _without(vector, direction):
    """The part of a vector square to a direction of length 1."""
    along = sum(a * b for a, b in zip(vector, direction))
    return tuple(a - along * b for a, b in zip(vector, direction))


def _euler_of(x_W, z_W):
    """Angles in deg of Rz(I) Rx(J) Rz(K), whose first and third column are x_W and z_W."""
    y_z = z_W[0] * x_W[1] - z_W[1] * x_W[0]  # Z of the second column, z_W x x_W
    tilt = math.atan2(math.hypot(z_W[0], z_W[1]), z_W[2])
    if math.sin(tilt) < 1e-9:
        turn = math.atan2(x_W[1], x_W[0])
        return (math.degrees(turn), math.degrees(tilt), 0.0)
    first = math.atan2(z_W[0], -z_W[1])
    third = math.atan2(x_W[2], y_z)
    return tuple(math.degrees(angle) for angle in (first, tilt, third))


def shortest(value, decimals):
    """A number without zeros at its end, and without a negative zero."""
    text = f"{round(value, decimals) + 0.0:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def with_point(seconds):
    """Seconds with a decimal point: in the dialects fanuc and haas P without one is milliseconds."""
    text = shortest(seconds, 3)
    return text if "." in text else text + "."


class ProgramWriter:
    def __init__(self, settings):
        _check_settings(settings)
        self._settings = settings
        self._decimals = settings.decimals or (4 if settings.units == "inch" else 3)
        self._lines = []
        self._number = 0
        self._active = _Active()
        self._blank = None
        self._turns_back = False
        self._is_placed = False  # a rapid has gone to a point since Z went up

    # ---- the program as a whole ----

    def begin(self, name, tools=(), blank=None, tilts=False):
        """`tools` are lines of text. `tilts`: some operation of the program is not Upright. Upright ones are then
        written in a plane without slope, so that the control turns head and table back before them."""
        self._turns_back = tilts
        self._blank = blank
        self._lines.append(f"(dialect {self._settings.dialect})")
        self.comment(name)
        for line in tools:
            self.comment(line)
        units = "G20" if self._settings.units == "inch" else "G21"
        self._block(units, "G90", "G94", "G17", "G40", "G49", "G69", "G80", "G91.1")

    def end(self):
        """The text of the program."""
        self._leave()
        self._stop_spindle()
        self._block("M30")
        return "\n".join(self._lines) + "\n"

    def begin_operation(self, name, tool, speed, spindle="cw", coolant="off", offset="G54", orientation=Upright()):
        """Activates what the operation needs. Z goes up first if tool, offset or orientation change."""
        if not OFFSET.fullmatch(offset):
            raise ProgramError(f"{offset} is no work offset; write G54 to G59, G59.1 to G59.3 or G54.1 P1 and on")
        self.comment(f"operation: {name}")
        if isinstance(orientation, Upright) and self._turns_back:
            orientation = Plane((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
        active = self._active
        if (tool, offset, orientation) != (active.tool, active.offset, active.orientation):
            self._leave()
            self._select_tool(tool)
            self._select_offset(offset)
            self._turn_spindle(spindle, speed)
            self._orient(orientation)
        self._turn_spindle(spindle, speed)
        self._cool(_choice(coolant, COOLANTS, "coolant"))

    # ---- steps of an operation ----

    def comment(self, text):
        if self._settings.comments:
            inside = " ".join(str(text).split()).replace("(", "[").replace(")", "]")
            self._lines.append(f"({inside})")

    def rapid(self, point, vector=None, angles=None):
        """To a point; a coordinate that is None stays. The first rapid of an upright tool goes over its point first."""
        if None not in point:
            self._is_placed = True
        upright = isinstance(self._active.orientation, Upright) or self._active.orientation == Plane((0.0,) * 3, (0.0,) * 3)
        if upright and self._active.point == [None, None, None]:
            self._line("G0", (point[0], point[1], None), None, None)
        self._line("G0", point, self._others(vector, angles), None)

    def feed(self, point, feed, vector=None, angles=None):
        self._line("G1", point, self._others(vector, angles), feed)

    def arc(self, direction, point, center, feed, plane="xy", turns=1):
        """To a point about a center of two coordinates in the order of the plane (xy, zx, yz); end = start is a full
        circle. The third coordinate moves along (helix)."""
        self._refuse_five_axes("arcs")
        code = _choice(direction, {"cw": "G2", "ccw": "G3"}, "arc")
        select, first, second = _choice(plane, ARC_PLANES, "plane")
        start, end = self._ends(point, first, second)
        sweep = _sweep(start, end, center, code == "G2")
        if math.dist(start, center) <= SAME_POINT:
            raise ProgramError("the center of the arc is its start")
        if turns == 1 and self._is_one_point(start, end) and sweep < math.pi:
            self._line("G1", point, None, feed)  # a short arc whose ends round to one point would be a full circle
            return
        self._select_arc_plane(select)
        words = self._changed_points(point, (first, second))
        words += [f"{'IJK'[axis]}{self._from_start(axis, value)}" for axis, value in zip((first, second), center)]
        words += [f"P{turns}"] if turns != 1 else []
        self._move(code, words, feed)
        self._arrive(point)

    def drill(self, kind, points, top, bottom, feed=None, peck=None, dwell=None, pitch=None, back_to="initial"):
        """Holes at points X Y: rapid to `top`, then to `bottom`. A tap has a pitch in place of a feed."""
        self._refuse_five_axes("drilling cycles")
        code = _choice(kind, CYCLES, "drill")
        _require_for_cycle(kind, peck=peck, dwell=dwell, pitch=pitch)
        if pitch is not None:
            feed = self._tapping_feed(pitch)
        self._select_arc_plane("G17")
        self._block(_choice(back_to, {"initial": "G98", "top": "G99"}, "back_to"))
        words = [f"Z{self._length(bottom)}", f"R{self._length(top)}"]
        words += [f"Q{self._length(peck)}"] if peck else []
        words += ["P" + with_point(dwell)] if dwell else []
        for point in points:
            self._active.code = None
            self._move(code, [f"X{self._length(point[0])}", f"Y{self._length(point[1])}", *words], feed)
            self._arrive((point[0], point[1], None))
        self._block("G80")
        self._active.code = self._active.point[2] = None

    def dwell(self, seconds):
        self._block("G4", "P" + with_point(seconds))

    def stop(self, optional=False):
        self._block("M1" if optional else "M0")

    # ---- what is active ----

    def _leave(self):
        """Ends plane and tool center point control, and moves Z up in machine coordinates."""
        orientation = self._active.orientation
        if isinstance(orientation, Plane):
            self._block("G69")
        elif isinstance(orientation, (Vectors, Angles)):
            self._block("G49")
        if self._settings.retract == "g53":
            self._block("G53", "G0", "Z" + self._length(self._settings.safe_z))
        else:
            self._block("G91", "G28", "Z0")
            self._block("G90")
        self._cool("M9")
        self._active.orientation = None
        self._active.forget_position()
        self._is_placed = False

    def _select_tool(self, tool):
        if tool != self._active.tool:
            self._stop_spindle()
            self._block(f"T{tool}", "M6")
        self._active.tool = tool

    def _select_offset(self, offset):
        if offset != self._active.offset:
            self._block(offset)
            self._active.offset = offset
        if self._blank is not None:
            self._lines.append(self._workpiece(self._blank))
            self._blank = None

    def _orient(self, orientation):
        tool = self._active.tool
        if isinstance(orientation, (Vectors, Angles)):
            self._block("G43.5" if isinstance(orientation, Vectors) else "G43.4", f"H{tool}")
        else:
            self._block("G43", f"H{tool}")
        if isinstance(orientation, Plane):
            zero = [name + self._length(value) for name, value in zip("XYZ", orientation.origin)]
            turn = [name + shortest(value, ANGLE_DECIMALS) for name, value in zip("IJK", orientation.euler)]
            self._block("G68.2", *zero, *turn)
            self._block("G53.1")
        self._active.orientation = orientation

    def _turn_spindle(self, direction, speed):
        code = _choice(direction, SPINDLES, "spindle")
        if code == "M5":
            self._stop_spindle()
        elif not speed or speed < 0:
            raise ProgramError('"speed" must be above 0; "spindle": "off" leaves the spindle off')
        elif (code, speed) != (self._active.spindle, self._active.speed):
            self._block(f"S{shortest(speed, 1)}", code)
            self._active.spindle, self._active.speed = code, speed

    def _stop_spindle(self):
        if self._active.spindle != "M5":
            self._block("M5")
            self._active.spindle = "M5"

    def _cool(self, code):
        if code != self._active.coolant:
            if "M9" not in (code, self._active.coolant):
                self._block("M9")
            self._block(code)
            self._active.coolant = code

    def _select_arc_plane(self, code):
        if code != self._active.arc_plane:
            self._block(code)
            self._active.arc_plane = code

    # ---- blocks ----

    def _block(self, *words):
        prefix = ""
        if self._settings.line_numbers:
            self._number += 10
            prefix = f"N{self._number} "
        self._lines.append(prefix + " ".join(words))

    def _line(self, code, point, others, feed):
        words = self._changed_points(point, ())
        if others and others != self._active.others:
            words += [name + text for name, text in others.items()]
            self._active.others = others
        self._arrive(point)
        if words:
            self._move(code, words, feed)

    def _move(self, code, words, feed):
        if self._active.tool is None:
            raise ProgramError("a move comes before the first operation")
        if not self._is_placed:
            raise ProgramError("the first move after a change of tool, offset or plane must be a rapid with X, Y and Z")
        block = [*([] if code == self._active.code else [code]), *words]
        self._active.code = code
        if feed is not None:
            text = self._length(feed)
            if float(text) <= 0:
                raise ProgramError("the feed must be above 0")
            block += [f"F{text}"] if text != self._active.feed else []
            self._active.feed = text
        elif code != "G0":
            raise ProgramError('"f" is missing: a move at feed needs it')
        self._block(*block)

    def _changed_points(self, point, always):
        words = []
        for axis, value in enumerate(point):
            value = self._active.point[axis] if value is None and axis in always else value
            if value is not None and (axis in always or not self._is_at(axis, value)):
                words.append("XYZ"[axis] + self._length(value))
        return words

    def _others(self, vector, angles):
        """Words of a vector or of rotary axes, in the order of the alphabet."""
        orientation = self._active.orientation
        if vector is not None and not isinstance(orientation, Vectors):
            raise ProgramError('a tool vector needs "five_axis": "vectors" in its operation')
        if angles is not None and not isinstance(orientation, Angles):
            raise ProgramError('angles need "five_axis": "angles" in their operation')
        if vector is not None:
            return {name: shortest(value, ANGLE_DECIMALS) for name, value in zip("IJK", _unit(vector))}
        return {name: shortest(value, ANGLE_DECIMALS) for name, value in sorted((angles or {}).items())}

    def _refuse_five_axes(self, what):
        if isinstance(self._active.orientation, (Vectors, Angles)):
            raise ProgramError(f'{what} are written in a plane only; give the operation a "plane", or write lines')

    def _ends(self, point, first, second):
        start = (self._active.point[first], self._active.point[second])
        if None in start:
            raise ProgramError("the arc begins at an unknown point; begin with a rapid to it")
        return start, tuple(known if value is None else value for known, value in zip(start, (point[first], point[second])))

    def _from_start(self, axis, center):
        return self._length(round(center, self._decimals) - round(self._active.point[axis], self._decimals))

    def _tapping_feed(self, pitch):
        if self._active.spindle == "M5":
            raise ProgramError("a tap needs a turning spindle")
        return pitch * self._active.speed

    def _arrive(self, point):
        self._active.point = [old if new is None else new for old, new in zip(self._active.point, point)]

    def _is_at(self, axis, value):
        known = self._active.point[axis]
        return known is not None and self._length(known) == self._length(value)

    def _is_one_point(self, start, end):
        return all(self._length(a) == self._length(b) for a, b in zip(start, end))

    def _length(self, value):
        return shortest(value, self._decimals)

    def _workpiece(self, blank):
        kind = _choice(blank.kind, {"box": 0, "cylinder": 1}, "blank")
        scale = 25.4 if self._settings.units == "inch" else 1.0
        resolution = blank.resolution_mm or max(blank.size) * scale / 400
        values = ", ".join(self._length(value) for value in (*blank.size, *blank.zero))
        return f"#workpiece ({kind}, {shortest(resolution, 4)}, 0, {values})"


def _choice(value, table, what):
    if value not in table:
        raise ProgramError(f'"{what}" is {value!r}; it must be one of {", ".join(table)}')
    return table[value]


def _check_settings(settings):
    for name, allowed in (("units", ("mm", "inch")), ("dialect", DIALECTS), ("retract", RETRACTS)):
        if getattr(settings, name) not in allowed:
            raise ProgramError(f'"{name}" is {getattr(settings, name)!r}; it must be one of {", ".join(allowed)}')
    if settings.decimals is not None and settings.decimals not in range(1, 7):
        raise ProgramError(f'"decimals" is {settings.decimals!r}; it must be 1 to 6')


def _require_for_cycle(kind, **values):
    needed = NEEDS.get(kind)
    for name, value in values.items():
        if name == needed and not (value and value > 0):
            raise ProgramError(f'"drill": "{kind}" needs "{name}" above 0')
        if name != needed and value is not None:
            raise ProgramError(f'"{name}" does not belong to "drill": "{kind}"')


def _sweep(start, end, center, clockwise):
    """Angle of an arc in rad, above 0 and at most a full turn."""
    first = math.atan2(start[1] - center[1], start[0] - center[0])
    last = math.atan2(end[1] - center[1], end[0] - center[0])
    angle = (first - last if clockwise else last - first) % (2 * math.pi)
    return angle if math.dist(start, end) > SAME_POINT else 2 * math.pi
