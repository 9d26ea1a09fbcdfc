"""Plunge grinding cycles that do not burn: design, verification, studies and the model.

The functions of ``stanok grind``, with the same results. A *process file* (``.toml``) contains the data of the
process, a *control file* also a table of feeds; docs/programmer/grinding.md describes the model and its sources.
X is the allowance that a rigid machine would have left, mm per side; Q is the removal, mm² per rad.
"""
from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from .programs import PathLike

__all__ = ["Cycle", "Plunge", "Samples", "Study", "boundary", "design", "plunge", "program", "study", "verify"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Samples:
    """A cycle over time, one row for each step of the simulation; every array is ``(n,)``."""

    time_s: Floats
    """s, from the first contact."""
    x_mm: Floats
    """mm, commanded."""
    allowance_mm: Floats
    """mm, remaining under the wheel."""
    feed_mm_per_s: Floats
    """mm/s, commanded."""
    removal_mm2_per_rad: Floats
    """mm²/rad, Q."""
    removal_ratio: Floats
    """Q divided by its boundary D(H); above 1 the part burns."""
    deflection_mm: Floats
    """mm, deflection of the wheel."""


@dataclass(frozen=True)
class Cycle:
    """A cycle and its assessment.

    ``report`` is the JSON of ``stanok grind --json``; the properties are its most used members.
    ``control_text`` is the control file.
    """

    report: dict[str, Any]
    samples: Samples
    control_text: str

    @property
    def ok(self) -> bool:
        """Whether nothing burns, no deflection is too large and the size is reached."""
        return bool(self.report["ok"])

    @property
    def law(self) -> Floats:
        """``(m, 2)``: X mm and feed mm/s; linear between rows; two rows with the same X are a jump."""
        return np.array(self.report["law"], dtype=np.float64).reshape(-1, 2)

    @property
    def boundary(self) -> Floats:
        """``(m, 2)``: corners of the permitted removal: allowance mm and Q mm²/rad."""
        return np.array(self.report["boundary"], dtype=np.float64).reshape(-1, 2)

    @property
    def time_s(self) -> float:
        """Time of the cycle including spark-out, s."""
        return float(self.report["cycle_time_s"])

    @property
    def findings(self) -> tuple[dict[str, str], ...]:
        """Findings of the verification, each with ``code`` and ``text``."""
        return tuple(self.report.get("findings", ()))

    def save(self, path: PathLike) -> None:
        """Writes the control file."""
        Path(path).write_bytes(self.control_text.encode())


@dataclass(frozen=True)
class Plunge:
    """Result of an infeed law on the elastic system, and its samples."""

    time_s: float
    size_reached_s: float | None
    residual_mm: float
    residual_min_mm: float
    residual_mean_mm: float
    wear_mm: float
    volume_mm2: float
    contact_losses: int
    force_max_n: float
    samples: Samples


class Study(Mapping[str, "npt.NDArray[Any]"]):
    """Designs over varied numbers: a mapping of the columns of ``stanok grind study`` to arrays ``(n,)``.

    The columns of the variations come first; the last variation changes fastest. ``finding`` says why a row
    has no design; its numbers are then ``nan``. ``text`` is the CSV, ``shape`` the counts of the variations of
    the whole study, ``part`` the part of the study, ``(k, n)`` as in :func:`study`. Only the text of the first
    part has headings, so that the texts of all parts in order are the text of the whole study.
    """

    def __init__(self, text: str, shape: tuple[int, ...], part: tuple[int, int] = (1, 1),
                 headings: str | None = None) -> None:
        self.text = text
        self.shape = shape
        self.part = part
        with_headings = text if headings is None or part[0] == 1 else headings + text
        self._headings, *rows = list(csv.reader(io.StringIO(with_headings)))
        self._columns: dict[str, npt.NDArray[Any]] = {}
        for k, name in enumerate(self._headings):
            texts = [row[k] for row in rows]
            if name == "finding":
                self._columns[name] = np.array(texts, dtype=object)
            else:
                self._columns[name] = np.array([float(one) if one else np.nan for one in texts])

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Any:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """Number of designs in this part."""
        return len(self._columns["finding"])

    @classmethod
    def joined(cls, parts: Iterable[Study]) -> Study:
        """The whole study from all its parts, in any order."""
        ordered = sorted(parts, key=lambda one: one.part)
        if not ordered:
            raise ValueError("give the parts of a study")
        first = ordered[0]
        count = first.part[1]
        if any(one.shape != first.shape or one._headings != first._headings for one in ordered):
            raise ValueError("these are parts of different studies")
        if [one.part for one in ordered] != [(k, count) for k in range(1, count + 1)]:
            raise ValueError(f"give each of the {count} parts once, not "
                             + ", ".join(f"{k}/{n}" for k, n in (one.part for one in ordered)))
        return cls("".join(one.text for one in ordered), first.shape)

    def grid(self, name: str) -> npt.NDArray[Any]:
        """A column in the shape of the variations, one dimension for each. Join parts first: a part has no shape."""
        if self.part != (1, 1):
            raise ValueError(f"this is part {self.part[0]} of {self.part[1]} of a study; join them with Study.joined")
        return self._columns[name].reshape(self.shape)

    def __repr__(self) -> str:
        part = "" if self.part == (1, 1) else f", part {self.part[0]}/{self.part[1]}"
        return f"<Study of {self.rows} designs{part}: {', '.join(self._columns)}>"


def design(
    process: PathLike,
    *,
    points: int | None = None,
    at_mm: Sequence[float] = (),
    decimals: int | None = None,
    spread: Mapping[str, float] | None = None,
    feedback: float = 0.5,
    iterations: int = 40,
    force: bool = False,
    exact: bool = False,
    burn_margin: float | None = None,
    spark_out_revolutions: float | None = None,
    time_step_s: float | None = None,
) -> Cycle:
    """Designs a cycle: ``stanok grind design``.

    Args:
        process: process file, or a control file whose law is designed again.
        points: number of switch points, 0 to 40; ``None``: as many as shorten the cycle.
        at_mm: X of the switch points in mm, falling, instead of their number.
        decimals: of X and feeds in the table, 3 to 7.
        spread: how far ``stiffness`` and ``force_factor`` (fractions, up to 0.9) and ``allowance`` (mm) may
            deviate in both directions; one table that suits the whole range.
        feedback: gain of the iteration, below 1.
        iterations: maximum number of iterations, 0 to 1000.
        force: continue to iterate even with an unstable gain.
        exact: removal Q = a R instead of the paper's triangle.
        burn_margin: fraction by which the removal may exceed the burn line, 0 to 1.
        spark_out_revolutions: revolutions of the part after the last X, 0 to 1000.
        time_step_s: step of the simulation, 1e-6 to 0.0005 s.

    Raises:
        GrindingError: the design is refused; has the code. MachineFileError: faults of the process file.
    """
    options = _options(process, exact, burn_margin, spark_out_revolutions, time_step_s)
    _iteration(options, feedback, iterations, force)
    if points is not None:
        if at_mm:
            raise ValueError("give points or at_mm")
        options.points = int(_within(points, "points", 0, 40))
    options.at_mm = [float(value) for value in at_mm]
    if decimals is not None:
        options.decimals = int(_within(decimals, "decimals", 3, 7))
    given = dict(spread or {})
    parts = {key: _within(given.pop(key, 0.0), f"spread {key}", 0.0, 0.9)
             for key in ("stiffness", "force_factor", "allowance")}
    if given:
        raise ValueError(f"spread takes stiffness, force_factor and allowance, not {', '.join(given)}")
    return _cycle(_native.grind_design(options, parts["stiffness"], parts["force_factor"], parts["allowance"]))


def verify(
    control: PathLike,
    *,
    feedback: float = 0.5,
    iterations: int = 40,
    force: bool = False,
    exact: bool = False,
    burn_margin: float | None = None,
    spark_out_revolutions: float | None = None,
    time_step_s: float | None = None,
) -> Cycle:
    """Checks the table of a control file against the boundary: ``stanok grind verify``. See :func:`design`."""
    options = _options(control, exact, burn_margin, spark_out_revolutions, time_step_s)
    _iteration(options, feedback, iterations, force)
    return _cycle(_native.grind_verify(options))


def study(
    process: PathLike,
    vary: Mapping[str, tuple[float, float, int]],
    *,
    part: tuple[int, int] | None = None,
    exact: bool = False,
    burn_margin: float | None = None,
    spark_out_revolutions: float | None = None,
    time_step_s: float | None = None,
) -> Study:
    """Designs for all combinations of varied numbers, on all processors: ``stanok grind study``.

    Args:
        process: process file, or control file.
        vary: ``{key: (from, to, count)}``, keys of the process file; at most a million designs.
        part: ``(k, n)``: the k-th of n parts of the study, k from 1, for arrays of jobs on a cluster.
            :meth:`Study.joined` joins all parts to the study.

    >>> study = grinding.study("process.toml", {"stiffness": (2e7, 4e7, 21)})
    >>> study["stiffness"], study["cycle_time_s"]
    """
    options = _options(process, exact, burn_margin, spark_out_revolutions, time_step_s)
    if not vary:
        raise ValueError("vary is empty; give at least one key of the process file")
    counts = []
    texts = []
    for key, (begin, end, count) in vary.items():
        texts.append(f"{key}={float(begin)!r}:{float(end)!r}:{int(count)}")
        counts.append(int(count))
    options.variations = texts
    number, count = (1, 1) if part is None else part
    number, count = int(number), int(count)
    options.part = f"{number}/{count}"
    headings, text = _native.grind_study(options)
    return Study(text, tuple(counts), (number, count), headings)


def program(
    control: PathLike,
    *,
    machine: PathLike | None = None,
    channel: int | None = None,
    wheel_speed_m_per_s: float = 35.0,
    spark_out_revolutions: float | None = None,
    gauge_margin_mm: float = 0.0,
) -> str:
    """The part program of a control file: ``stanok grind program``.

    Args:
        control: the control file.
        machine: machine file whose grind channel runs the program; ``None``: part spindle 1 and no wheel.
        channel: channel of the machine; ``None``: the first grind channel.
        wheel_speed_m_per_s: surface speed of the wheel, 1 to 200 m/s.
        spark_out_revolutions: revolutions after the last X.
        gauge_margin_mm: the gauge ends the last feed, at most this far below the last X, 0.001 to 1 mm; 0: none.
    """
    options = _options(control, False, None, spark_out_revolutions, None)
    if gauge_margin_mm != 0.0:
        options.gauge_margin_mm = _within(gauge_margin_mm, "gauge_margin_mm", 0.001, 1.0)
    speed = _within(wheel_speed_m_per_s, "wheel_speed_m_per_s", 1.0, 200.0)
    options.set_machine("" if machine is None else os.fspath(machine), channel or 0, speed)
    return _native.grind_program(options, Path(control).name)


def plunge(
    process: PathLike,
    law: npt.ArrayLike,
    *,
    goes_on: bool = False,
    exact: bool = False,
    spark_out_revolutions: float | None = None,
    time_step_s: float | None = None,
) -> Plunge:
    """Runs an infeed law on the model of the elastic machine and the cut.

    Args:
        process: process file, or a control file, of which only the process is used.
        law: ``(m, 2)``, X mm and feed mm/s; X never rises, feeds are above 0.
        goes_on: the last feed continues until the size is reached; otherwise the wheel stops at the last X.
        exact: removal Q = a R instead of the paper's triangle.
        spark_out_revolutions: revolutions after the last X.
        time_step_s: step of the simulation, 1e-6 to 0.0005 s.
    """
    options = _options(process, exact, None, spark_out_revolutions, time_step_s)
    text, arrays = _native.grind_plunge(options, np.asarray(law, dtype=np.float64), goes_on)
    return Plunge(**json.loads(text), samples=Samples(**arrays))


def boundary(process: PathLike, allowance_mm: npt.ArrayLike, *, exact: bool = False) -> Floats:
    """The permitted removal D(H), mm²/rad, for the remaining allowance in mm; any shape."""
    options = _options(process, exact, None, None, None)
    return np.asarray(_native.grind_boundary(options, np.asarray(allowance_mm, dtype=np.float64)))


def _within(value: float, name: str, low: float, high: float) -> float:
    if not low <= value <= high:
        raise ValueError(f"{name} is {value}; give {low:g} to {high:g}")
    return value


def _options(path: PathLike, exact: bool, burn_margin: float | None, spark_out_revolutions: float | None,
             time_step_s: float | None) -> _native.GrindOptions:
    options = _native.GrindOptions()
    options.input = os.fspath(path)
    options.exact = exact
    if burn_margin is not None:
        options.burn_margin = _within(burn_margin, "burn_margin", 0.0, 1.0)
    if spark_out_revolutions is not None:
        options.spark_out_revolutions = _within(spark_out_revolutions, "spark_out_revolutions", 0.0, 1000.0)
    if time_step_s is not None:
        options.time_step_s = _within(time_step_s, "time_step_s", 1e-6, 0.0005)
    return options


def _iteration(options: _native.GrindOptions, feedback: float, iterations: int, force: bool) -> None:
    options.feedback = _within(feedback, "feedback", 1e-9, 1e9)
    options.iterations = int(_within(iterations, "iterations", 0, 1000))
    options.force = force


def _cycle(told: tuple[str, dict[str, Floats], str]) -> Cycle:
    text, arrays, control_text = told
    return Cycle(report=json.loads(text), samples=Samples(**arrays), control_text=control_text)
