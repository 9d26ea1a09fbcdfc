"""What a program asks of a machine, in one form for both interpreters.

An Event is a motion, a dwell or a stop together with the state in which it happens: spindle, coolant,
tools, tool length. Lengths are mm, angles deg, feeds mm/min, mm/rev or deg/min. Two lists of events are
the same when every number differs by less than the tolerance in the unit of the program (mm or inch):
rs274 prints four decimals.
"""

import math
from dataclasses import dataclass, field, replace

AXES = "XYZABC"
LINEAR = "XYZ"
MM_PER_INCH = 25.4
TOLERANCE = 2e-4  # two numbers rounded to four decimals, and the sums they went through

# Indices of the first and second axis of each plane and of the axis along a helix.
PLANES = {"XY": (0, 1, 2), "ZX": (2, 0, 1), "YZ": (1, 2, 0)}


@dataclass(frozen=True)
class State:
    """What stays until it is changed."""

    spindle: str = "stop"  # stop, clockwise, counter_clockwise
    speed: float = 0.0
    cutting_speed: bool = False
    mist: bool = False
    flood: bool = False
    tool_prepared: int = 0
    tool: int = 0
    tool_length: float = 0.0


@dataclass(frozen=True)
class Event:
    kind: str  # rapid, feed, arc, thread, rigid_tap, dwell, program_stop, optional_stop, pallet_stop
    line: int = 0
    end: tuple = ()
    unit: float = 1.0  # mm per unit of the program
    feed: float = 0.0
    per_revolution: bool = False
    plane: str = ""
    centre: tuple = ()
    turns: int = 0  # positive: counter-clockwise
    lead: float = 0.0
    seconds: float = 0.0
    state: State = field(default_factory=State)

    def text(self):
        words = " ".join(f"{a}{v:.4f}" for a, v in zip(AXES, self.end))
        parts = [f"line {self.line}:" if self.line else "", self.kind, words]
        if self.kind in ("feed", "arc"):
            parts.append(f"F{self.feed:.4f}" + (" per revolution" if self.per_revolution else ""))
        if self.kind == "arc":
            parts.append(f"{self.plane} centre {self.centre[0]:.4f},{self.centre[1]:.4f}")
            parts.append(f"turns {self.turns}")
        if self.kind in ("thread", "rigid_tap"):
            parts.append(f"lead {self.lead:.4f}")
        if self.kind == "dwell":
            parts.append(f"{self.seconds:.4f} s")
        state = self.state
        parts.append(f"[{state.spindle} {state.speed:.4f}{' css' if state.cutting_speed else ''}"
                     f" mist {state.mist:d} flood {state.flood:d}"
                     f" T{state.tool_prepared}/{state.tool} length {state.tool_length:.4f}]")
        return " ".join(part for part in parts if part)


def arc_length(start, event):
    """Length of an arc or helix in mm."""
    first, second, along = PLANES[event.plane]
    radius = math.hypot(start[first] - event.centre[0], start[second] - event.centre[1])
    begin = math.atan2(start[second] - event.centre[1], start[first] - event.centre[0])
    finish = math.atan2(event.end[second] - event.centre[1], event.end[first] - event.centre[0])
    angle = (finish - begin) * (1 if event.turns > 0 else -1) % (2 * math.pi)
    if angle < 1e-9 or angle > 2 * math.pi - 1e-9:
        angle = 2 * math.pi
    angle += 2 * math.pi * (abs(event.turns) - 1)
    return math.hypot(angle * radius, event.end[along] - start[along])


def line_length(start, end):
    """Length of a line in mm; in deg when no linear axis moves."""
    linear = math.dist(start[:3], end[:3])
    return linear if linear > 0 else math.dist(start[3:], end[3:])


def moves_nothing(start, event):
    return event.kind in ("rapid", "feed") and all(
        abs(a - b) < TOLERANCE * event.unit for a, b in zip(start, event.end))


def without_standing_moves(events):
    """A move to where the axes are already is no difference."""
    kept, position = [], (0.0,) * len(AXES)
    for event in events:
        if event.end:
            if moves_nothing(position, event):
                continue
            position = event.end
        kept.append(event)
    return kept


def numbers(event):
    """The numbers of an event, in the unit of the program."""
    scale = [1 / event.unit] * 3 + [1.0] * 3
    values = [value * factor for value, factor in zip(event.end, scale)]
    values += [value / event.unit for value in event.centre]
    values += [event.lead / event.unit, event.seconds, event.state.speed]
    values.append(event.state.tool_length / event.unit)
    return values


def same(ours, theirs):
    names = ("kind", "plane", "turns", "per_revolution")
    if any(getattr(ours, name) != getattr(theirs, name) for name in names):
        return False
    if replace(ours.state, speed=0.0, tool_length=0.0) != replace(
            theirs.state, speed=0.0, tool_length=0.0):
        return False
    pairs = list(zip(numbers(replace(ours, unit=theirs.unit)), numbers(theirs)))
    if any(abs(a - b) > max(TOLERANCE, 1e-6 * abs(b)) for a, b in pairs):
        return False
    # A feed computed from a length (G93) carries the rounding of both ends of the move.
    return abs(ours.feed - theirs.feed) <= max(TOLERANCE * theirs.unit, 1e-4 * abs(theirs.feed))
