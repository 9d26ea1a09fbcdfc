"""Reads the records that `stanok interpret` prints: our events."""

import json
import subprocess
from dataclasses import replace

from canonical_calls import Refused
from events import AXES, Event, State, arc_length, line_length

STOPS = ("program_stop", "optional_stop", "pallet_stop")
SPINDLE_STATES = {"clockwise": "clockwise", "counter_clockwise": "counter_clockwise",
                  "stop": "stop", "orient": "orient"}


class Reader:
    def __init__(self, axes):
        self.axes = axes
        self.events = []
        self.state = State()
        self.position = (0.0,) * len(AXES)

    def set(self, **changes):
        self.state = replace(self.state, **changes)

    def add(self, kind, record, **values):
        self.events.append(Event(kind, line=record["line"], state=self.state, **values))

    def take(self, record):
        """Another event, or a change of the state; False at the end of the program."""
        kind = record["kind"]
        if "end" in record:
            self.take_move(kind, record)
        elif kind == "dwell":
            self.add("dwell", record, seconds=record["seconds"])
        elif kind == "spindle":
            self.take_spindle(record)
        elif kind == "coolant":
            self.set(mist=record["mist"], flood=record["flood"])
        elif kind == "tool":
            name = "tool_prepared" if record["action"] == "prepare" else "tool"
            self.set(**{name: record["tool"]})
        elif kind == "offset" and record["what"] == "tool_length":
            self.set(tool_length=record["offset"][2])
        elif kind == "sync" and record["what"] == "program_stop":
            self.add(STOPS[record["code"]], record)
        return kind != "end"

    def take_spindle(self, record):
        action = record["action"]
        if action in ("cutting_speed", "constant_speed"):
            self.set(cutting_speed=action == "cutting_speed")
            if action == "cutting_speed":
                self.set(speed=record["speed"])
            return
        if action in SPINDLE_STATES:
            self.set(spindle=SPINDLE_STATES[action])
        if action != "stop" and action != "orient":
            self.set(speed=record.get("cutting_speed", record.get("speed")))

    def take_move(self, kind, record):
        end = tuple(record["end"].get(axis, 0.0) for axis in AXES)
        values = {"end": end, "feed": record.get("feed", 0.0)}
        values["per_revolution"] = record.get("feed_mode") == "per_revolution"
        if kind == "arc":
            values["plane"] = record["plane"]
            values["centre"] = tuple(record["centre"][axis] for axis in record["plane"])
            values["turns"] = record["turns"] * (1 if record["ccw"] else -1)
        if kind in ("thread", "rigid_tap"):
            values["lead"] = record["lead"]
        self.add(kind, record, **values)
        if record.get("feed_mode") == "inverse_time":
            event = self.events[-1]
            length = (arc_length(self.position, event) if kind == "arc" else
                      line_length(self.position, end))
            self.events[-1] = replace(event, feed=event.feed * length)
        self.position = end


def events_of(stanok, program, machine):
    """Runs stanok on the program; raises Refused with its first error."""
    command = [stanok, "interpret", "--machine", machine, program]
    result = subprocess.run(command, capture_output=True, text=True, timeout=120,
                            stdin=subprocess.DEVNULL, errors="replace")
    if result.returncode != 0:
        raise Refused("\n".join(result.stderr.splitlines()[:6]) or f"exit {result.returncode}")
    reader = Reader(AXES)
    for line in result.stdout.splitlines():
        if not reader.take(json.loads(line)):
            break
    return reader.events
