"""Interpreting programs without moving a machine: records after block preparation, errors, feed laws."""
from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from . import _native
from .errors import Fault, ProgramError
from .machine import MachineLike, as_machine
from .programs import PathLike, located, search_roots

__all__ = ["Check", "FeedLawBlock", "Interpretation", "OtherPosition", "TiltedPlane", "check", "interpret"]


@dataclass(frozen=True)
class Interpretation:
    """Result of a program: ``records`` as printed by ``stanok interpret``, one per command."""

    records: list[dict[str, Any]]
    blocks: int
    faults: tuple[Fault, ...]


@dataclass(frozen=True)
class FeedLawBlock:
    """A block under a feed law, as in ``stanok check --estimate``; ``None``: the law does not have this value.

    ``feed_first`` and ``feed_last`` are in ``feed_unit``, ``"mm/min"`` or ``"mm/rev"``. ``k_a`` and ``k_b``
    are duration and spacing of interruptions in revolutions, ``k_m`` is S_0min/S_0max.
    """

    file: str
    line: int
    law: str
    path_mm: float
    increments: int
    feed_first: float
    feed_last: float
    feed_unit: str
    time_s: float
    time_is_least: bool
    closed_form_s: float | None = None
    cycle_s: float | None = None
    cycle_closed_form_s: float | None = None
    k_a: float | None = None
    k_b: float | None = None
    k_m: float | None = None


@dataclass(frozen=True)
class OtherPosition:
    """The position of the rotary axes that ``word`` (``"P1"``, ``"P2"``) with G53.1 or G53.6 selects.

    ``limit``: the only axis in ``axes`` cannot reach this position, only this angle; ``None``: it is within reach.
    """

    word: str
    axes: dict[str, float]
    limit: float | None = None


@dataclass(frozen=True)
class TiltedPlane:
    """Positions of the rotary axes when ``line`` aligns the tool with a tilted plane; angles in deg.

    ``tool`` is the direction of the tool on the table, from its tip to the spindle. ``other`` is ``None``
    if the tool is at the pole, where there is no other position.
    """

    file: str
    line: int
    tool: tuple[float, float, float]
    axes: dict[str, float]
    other: OtherPosition | None = None


@dataclass(frozen=True)
class Check:
    """What is known about a program before a run. ``ok`` is true if no fault is an error."""

    faults: tuple[Fault, ...]
    feed_laws: tuple[FeedLawBlock, ...]
    tilted_planes: tuple[TiltedPlane, ...]
    blocks: int

    @property
    def ok(self) -> bool:
        """Whether the program has no errors. Warnings do not count."""
        return all(fault.severity != "error" for fault in self.faults)


def interpret(
    machine: MachineLike,
    program: PathLike,
    *,
    channel: int = 1,
    scheme: int | None = None,
    program_root: PathLike | None = None,
    million_steps: int | None = None,
    check: bool = True,
) -> Interpretation:
    """Interpret a program: its moves with their ends, spindle commands, offsets and feed laws, after block preparation.

    Args:
        machine: a machine file, or a machine that was read.
        program: the program; its folder is the first one that is searched for other programs.
        channel: channel whose axes and words it uses.
        scheme: kinematic scheme at the start; ``None``: the scheme of the machine file.
        program_root: another folder that is searched for programs.
        million_steps: number of steps, in millions, after which an endless program is ended.
        check: raise an exception if there is an error; otherwise see ``faults``.

    Returns:
        An :class:`Interpretation`. A record is a line of ``stanok interpret``: ``{"line": 3, "kind":
        "feed", "end": {"X": 10.0, ...}, "feed": 600.0, "feed_mode": "per_minute"}``; ends in mm and deg in
        the workpiece system, feeds in mm/min or mm/rev.
    """
    native, job = _job(machine, program, channel, scheme, program_root, million_steps)
    lines, faults_text, blocks = _native.interpret(native, job)
    faults = tuple(Fault.from_json(value) for value in json.loads(faults_text))
    # Not splitlines: texts of programs may have other ends of lines in them, as U+2028.
    records = [json.loads(line) for line in lines.split("\n") if line]
    if check and any(fault.severity == "error" for fault in faults):
        raise ProgramError(faults)
    return Interpretation(records, blocks, faults)


def check(
    machine: MachineLike,
    program: PathLike,
    *,
    channel: int = 1,
    scheme: int | None = None,
    program_root: PathLike | None = None,
    million_steps: int | None = None,
) -> Check:
    """Everything that can be found out about a program before a run, as in ``stanok check --estimate``.

    The arguments are those of :func:`interpret`. Faults of the program raise no exception. Every pose is
    checked against the limits of the axes; programs that it starts on other channels are followed.
    """
    native, job = _job(machine, program, channel, scheme, program_root, million_steps)
    faults_text, laws_text, planes_text, blocks = _native.check(native, job)
    return Check(
        faults=tuple(Fault.from_json(value) for value in json.loads(faults_text)),
        feed_laws=tuple(FeedLawBlock(**value) for value in json.loads(laws_text)),
        tilted_planes=tuple(_plane(value) for value in json.loads(planes_text)),
        blocks=blocks,
    )


def _plane(value: dict[str, Any]) -> TiltedPlane:
    other = value.pop("other", None)
    tool = value.pop("tool")
    return TiltedPlane(tool=(tool[0], tool[1], tool[2]), other=OtherPosition(**other) if other else None, **value)


def _job(machine: MachineLike, program: PathLike, channel: int, scheme: int | None,
         program_root: PathLike | None, million_steps: int | None) -> tuple[_native.Machine, _native.Program]:
    if million_steps is not None and not 1 <= million_steps <= 1_000_000:
        raise ValueError(f"million_steps is {million_steps}; give 1 to 1000000")
    if scheme is not None and scheme < 0:
        raise ValueError(f"scheme is {scheme}; give the number of a scheme")
    name, folder = located(program)
    job = _native.Program()
    job.name = name
    job.roots = search_roots([folder], program_root)
    job.channel = channel
    job.scheme = -1 if scheme is None else scheme
    job.steps_max = 0 if million_steps is None else million_steps * 1_000_000
    return as_machine(machine)._native, job
