"""Reads the canonical calls that `rs274 -g` prints: events of the peer."""

import math
import re
import subprocess
from dataclasses import replace

from events import AXES, MM_PER_INCH, TOLERANCE, Event, State

CALL = re.compile(r"^\s*\d+\s+N\S*\s+([A-Z0-9_]+)\((.*)\)\s*$")
PLANE_NAMES = {"CANON_PLANE_XY": "XY", "CANON_PLANE_XZ": "ZX", "CANON_PLANE_YZ": "YZ"}
# Calls without a counterpart in the comparison: they set what the moves already contain.
SILENT = {
    "SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "SET_FEED_REFERENCE", "ON_RESET",
    "SET_MOTION_CONTROL_MODE", "SET_NAIVECAM_TOLERANCE", "COMMENT", "MESSAGE", "START_CHANGE",
    "ENABLE_FEED_OVERRIDE", "DISABLE_FEED_OVERRIDE", "ENABLE_SPEED_OVERRIDE",
    "DISABLE_SPEED_OVERRIDE", "ENABLE_FEED_HOLD", "DISABLE_FEED_HOLD", "ENABLE_ADAPTIVE_FEED",
    "DISABLE_ADAPTIVE_FEED", "CHANGE_TOOL_NUMBER_SILENT", "LOGOPEN", "LOGCLOSE", "LOG",
    "SET_TOOL_TABLE_ENTRY",
}


class Refused(Exception):
    """The interpreter does not take the program; the text says why."""


class Unknown(Exception):
    """A canonical call that this reader does not know."""


class Reader:
    """One method a call; `events` grows."""

    def __init__(self):
        self.events = []
        self.state = State()
        self.unit = 1.0
        self.plane = "XY"
        self.feed = 0.0  # as printed, deg/min for rotary axes alone
        self.feed_of_linear = 0.0  # mm/min: the unit may change later, the feed does not
        self.per_revolution = False
        self.lead = None
        self.changing = False
        self.pallet = False

    def set(self, **changes):
        self.state = replace(self.state, **changes)

    def add(self, kind, **values):
        self.events.append(Event(kind, unit=self.unit, state=self.state, **values))

    def scaled(self, numbers):
        return tuple(v * (self.unit if a in "XYZ" else 1.0) for a, v in zip(AXES, numbers))

    def feed_of(self, end):
        """Feeds of rotary axes alone are deg/min, whatever the unit."""
        start = next((e.end for e in reversed(self.events) if e.end), (0.0,) * 6)
        linear = math.dist(start[:3], end[:3]) > 2 * TOLERANCE * self.unit
        return self.feed_of_linear if linear or end[3:] == start[3:] else self.feed

    def call(self, name, text):
        words = [word for word in re.split(r"[,\s]+", text) if word]
        if name in SILENT:
            self.changing = self.changing or name == "START_CHANGE"
            return True
        handler = getattr(self, name.lower(), None)
        if handler is None:
            raise Unknown(f"{name}({text})")
        return handler(*words) is not False

    def use_length_units(self, unit):
        self.unit = MM_PER_INCH if unit == "CANON_UNITS_INCHES" else 1.0

    def select_plane(self, plane):
        self.plane = PLANE_NAMES[plane]

    def set_feed_mode(self, _spindle, mode):
        self.per_revolution = mode == "1"

    def set_feed_rate(self, rate):
        self.feed = float(rate)
        self.feed_of_linear = self.feed * self.unit

    def straight_traverse(self, *end):
        self.add("rapid", end=self.scaled(map(float, end)))

    def straight_feed(self, *end):
        end = self.scaled(map(float, end))
        if self.lead is not None:
            self.add("thread", end=end, lead=self.lead * self.unit)
        else:
            self.add("feed", end=end, feed=self.feed_of(end), per_revolution=self.per_revolution)

    def arc_feed(self, first, second, first_centre, second_centre, turns, along, *rotary):
        plane = {"XY": "XYZ", "ZX": "ZXY", "YZ": "YZX"}[self.plane]
        at = dict(zip(plane, (float(first), float(second), float(along))))
        end = self.scaled([at[a] for a in "XYZ"] + [float(value) for value in rotary])
        self.add("arc", end=end, plane=self.plane, turns=int(turns), feed=self.feed_of_linear,
                 centre=(float(first_centre) * self.unit, float(second_centre) * self.unit),
                 per_revolution=self.per_revolution)

    def start_speed_feed_sync(self, lead, _velocity):
        self.lead = float(lead)

    start_speed_feed_synch = start_speed_feed_sync

    def stop_speed_feed_synch(self):
        self.lead = None

    def rigid_tap(self, *end):
        rotary = next((e.end[3:] for e in reversed(self.events) if e.end), (0.0,) * 3)
        end = self.scaled(map(float, end)) + rotary
        self.add("rigid_tap", end=end, lead=self.lead * self.unit)

    def dwell(self, seconds):
        if float(seconds) > 0:  # G84 waits 0 s
            self.add("dwell", seconds=float(seconds))

    def set_spindle_mode(self, _spindle, limit):
        self.set(cutting_speed=float(limit) > 0)

    def set_spindle_speed(self, _spindle, speed):
        self.set(speed=float(speed))

    def start_spindle_clockwise(self, *_):
        self.set(spindle="clockwise")

    def start_spindle_counterclockwise(self, *_):
        self.set(spindle="counter_clockwise")

    def stop_spindle_turning(self, *_):
        if not self.changing:  # M6 stops the spindle; when is left to the machine here
            self.set(spindle="stop")

    def orient_spindle(self, *_):
        self.set(spindle="orient")

    def select_tool(self, tool):
        self.set(tool_prepared=int(tool))

    def change_tool(self, tool):
        self.changing = False
        self.set(tool=int(tool))

    def change_tool_number(self, tool):
        self.set(tool=int(tool))

    def use_tool_length_offset(self, *offset):
        self.set(tool_length=float(offset[2]) * self.unit)

    def mist_on(self):
        self.set(mist=True)

    def mist_off(self):
        self.set(mist=False)

    def flood_on(self):
        self.set(flood=True)

    def flood_off(self):
        self.set(flood=False)

    def program_stop(self):
        self.add("pallet_stop" if self.pallet else "program_stop")
        self.pallet = False

    def optional_program_stop(self):
        self.add("optional_stop")

    def pallet_shuttle(self):
        self.pallet = True  # M60 stops afterwards, M30 ends the program

    def program_end(self):
        return False

    def finish(self):  # the end of the text
        return False


def events_of(program, tool_table, parameters):
    """Runs rs274 on the program; raises Refused or Unknown."""
    command = ["rs274", "-g", "-n", "2", "-t", tool_table, "-v", parameters, program]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60,
                            stdin=subprocess.DEVNULL, cwd=program.parent, errors="replace")
    complaint = [t for t in result.stderr.splitlines() if t and t != "executing"]
    reader, ended = Reader(), False
    for line in result.stdout.splitlines():
        match = CALL.match(line)
        if match and not reader.call(*match.groups()):
            ended = True
            break
    if not ended:
        raise Refused(" / ".join(complaint[:2]) or "no end of program")
    return reader.events
