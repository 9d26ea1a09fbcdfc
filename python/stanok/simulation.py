"""Simulation: the whole runtime on a virtual clock, in memory, with bit-identical results in each run."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from . import _native
from .errors import Fault, ProgramError, RunError
from .machine import Machine, MachineLike, as_machine
from .programs import PathLike, Programs, by_channel, located, search_roots
from .setpoints import Columns, Setpoints, column_names

__all__ = ["Event", "OperatorEvent", "Run", "Simulation", "simulate"]


@dataclass(frozen=True)
class OperatorEvent:
    """An action of an operator in a given cycle of a simulation, as a method of the operator protocol.

    Example: ``OperatorEvent(2000, "override.feed", {"percent": 50})``
    """

    cycle: int
    method: str
    params: Mapping[str, Any] | None = None

    def to_json(self) -> str:
        """As a line of ``stanok simulate --events``."""
        return json.dumps({"cycle": self.cycle, "method": self.method, "params": dict(self.params or {})})


@dataclass(frozen=True)
class Event:
    """An event in a cycle. ``code`` is empty for messages of programs; ``channel`` 0 is the machine."""

    cycle: int
    time_s: float
    channel: int
    code: str
    text: str
    file: str
    line: int


@dataclass(frozen=True)
class Run:
    """A run of a program. ``end`` is its end point in the workpiece system, ``end_axes`` in machine axes."""

    channel: int
    number: int
    program: str
    files: tuple[str, ...]
    ok: bool
    ended: bool
    blocks: int
    start_cycle: int
    end_cycle: int
    time_s: float
    path_mm: float
    end: dict[str, float]
    end_axes: dict[str, float]


@dataclass(frozen=True)
class Simulation:
    """Result of a simulation.

    ``setpoints`` has the arrays by channel; ``events`` the events in the order of the cycles; ``alarms`` why
    channels stopped; ``refusals`` why programs did not start or continue; ``load_faults`` the errors and
    warnings of their texts; ``refused_events`` the refused actions of operators.
    """

    machine: Machine
    ok: bool
    until_reached: bool
    cycle_s: float
    cycles: int
    machine_time_s: float
    wall_s: float
    setpoints: dict[int, Setpoints]
    runs: tuple[Run, ...]
    events: tuple[Event, ...]
    alarms: tuple[Fault, ...]
    refusals: tuple[Fault, ...]
    load_faults: tuple[Fault, ...]
    refused_events: tuple[str, ...]
    process: dict[str, Any] | None
    """Results of force control, if it was on."""

    def __getitem__(self, channel: int) -> Setpoints:
        """Setpoints of a channel."""
        self.machine.channel(channel)
        return self.setpoints[channel]

    @property
    def faults(self) -> tuple[Fault, ...]:
        """All faults that made the run fail."""
        errors = tuple(fault for fault in self.load_faults if fault.severity == "error")
        return errors + self.alarms + (() if errors else self.refusals)

    def __repr__(self) -> str:
        outcome = "ok" if self.ok else "until" if self.until_reached else "failed"
        return f"<Simulation of {self.machine.name}: {self.machine_time_s:.3f} s, {outcome}>"


def simulate(
    machine: MachineLike,
    programs: Programs,
    *,
    channel: int = 1,
    events: Iterable[OperatorEvent | Mapping[str, Any]] = (),
    schemes: Mapping[int, int] | None = None,
    program_root: PathLike | None = None,
    until_s: float | None = None,
    drives: Literal["ideal", "simulated"] = "ideal",
    sensors: PathLike | None = None,
    log: PathLike | None = None,
    columns: Columns = None,
    every: int = 1,
    check: bool = True,
) -> Simulation:
    """Runs programs on the virtual clock and keeps the setpoints of every cycle in memory.

    The code and the cycle are those of the daemon and of ``stanok simulate``, and the results are
    bit-identical. Other threads of Python continue meanwhile; Ctrl-C ends the simulation.

    Args:
        machine: a machine file, or a machine that was read (:func:`~stanok.load_machine`).
        programs: a program, or ``{channel: program}`` (the programs of a list run one after another).
        channel: channel of a single program.
        events: actions of operators: :class:`OperatorEvent`, or mappings ``{"cycle", "method", "params"}``.
        schemes: kinematic scheme at the start, by channel; otherwise that of the machine file.
        program_root: a folder that is searched for called programs, after the folders of the programs.
        until_s: machine time at which the run ends, s; ``None``: when all channels are idle.
        drives: ``"ideal"``: axes are always at their setpoints; ``"simulated"``: drives of the machine file.
        sensors: CSV of sensor values over machine time (``stanok simulate --sensors``).
        log: a log that is written as well, as with ``stanok simulate --log``.
        columns: columns that are kept: names of :data:`~stanok.ALL_COLUMNS`, ``"all"``, or ``None``:
            :data:`~stanok.USUAL_COLUMNS`. The memory grows by 8 bytes for each number and cycle.
        every: keeps one of this number of cycles.
        check: raise an exception if the run fails; otherwise see ``ok`` and ``faults``.

    Returns:
        A :class:`Simulation`; ``result[1].position`` is an array ``(n, k)`` of cycles and axes, mm and deg.

    Raises:
        ProgramError: a program cannot be loaded, with file, line, column and remedy.
        RunError: alarms or refusals; ``error.result`` has what was kept until then.
        MachineFileError: the machine file is wrong.
        ValueError: an argument is wrong.
    """
    read = as_machine(machine)
    pairs = [(number, *located(program)) for number, program in by_channel(programs, channel)]
    job = _native.Job()
    job.programs = [(number, name) for number, name, _ in pairs]
    job.roots = search_roots([folder for _, _, folder in pairs], program_root)
    job.events = [_event_text(event) for event in events]
    job.schemes = list((schemes or {}).items())
    job.until_s = -1.0 if until_s is None else _until(until_s)
    if drives not in ("ideal", "simulated"):
        raise ValueError(f"drives is {drives!r}; give 'ideal' or 'simulated'")
    job.drives = drives == "simulated"
    job.sensors = "" if sensors is None else os.fspath(sensors)
    job.log = "" if log is None else os.fspath(log)
    text, arrays = _native.simulate(read._native, job, column_names(columns), every)
    result = _simulation(read, json.loads(text), arrays)
    if check and not result.ok and not result.until_reached:
        faults = result.faults or (Fault(code="", message="the run failed"),)
        if any(fault.severity == "error" for fault in result.load_faults):
            raise ProgramError(faults)
        raise RunError(faults, result)
    return result


def _until(until_s: float) -> float:
    longest = 1e9
    if not 0.0 <= until_s <= longest:
        raise ValueError(f"until_s is {until_s}; give 0 to {longest:g} s, or None for no end")
    return float(until_s)


def _event_text(event: OperatorEvent | Mapping[str, Any]) -> str:
    if isinstance(event, OperatorEvent):
        return event.to_json()
    return json.dumps(dict(event))


def _faults(values: list[dict[str, Any]]) -> tuple[Fault, ...]:
    return tuple(Fault.from_json(value) for value in values)


def _run(told: dict[str, Any]) -> Run:
    files = tuple(told.pop("files"))
    return Run(files=files, **told)


def _simulation(machine: Machine, told: dict[str, Any], arrays: dict[int, dict[str, Any]]) -> Simulation:
    setpoints = {}
    for number, columns in arrays.items():
        channel = machine.channel(number)
        setpoints[number] = Setpoints(columns, number, channel.axes, channel.words, channel.units)
    return Simulation(
        machine=machine,
        ok=told["ok"],
        until_reached=told["until_reached"],
        cycle_s=told["cycle_s"],
        cycles=told["cycles"],
        machine_time_s=told["machine_time_s"],
        wall_s=told["wall_s"],
        setpoints=setpoints,
        runs=tuple(_run(run) for run in told["runs"]),
        events=tuple(Event(**event) for event in told["events"]),
        alarms=_faults(told["alarms"]),
        refusals=_faults(told["refusals"]),
        load_faults=_faults(told["load_faults"]),
        refused_events=tuple(told["refused_events"]),
        process=told["process"],
    )
