"""Cuts: constants of spindle, material and machine from their logs, and stable depths of cut.

The functions of ``stanok process identify`` (docs/programmer/identify.md describes the models and what to
record) and of ``stanok process lobes`` (docs/programmer/chatter.md).
"""
from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from .programs import PathLike

__all__ = ["Estimate", "GrindingCut", "Lobes", "MillingCut", "TurningCut", "identify_grinding", "identify_milling",
           "identify_turning", "lobes"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Estimate:
    """A value and its 95 % confidence interval."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class TurningCut:
    """A turning cut with one row for each cycle. ``report`` has the results, as the command prints them as JSON.

    ``report["fit"]`` says whether the model fits: without ``ok``, the values are not those of the cut, and ``reason``
    and ``remedy`` say why and what helps. If a fit that is ``ok`` has a ``reason``, its intervals are widened.

    Every array is ``(n,)``; ``power_w`` is ``nan`` if the sensor had no new value.
    """

    report: dict[str, Any]
    time_s: Floats
    """s, from the beginning of the log."""
    rev_per_min: Floats
    """rev/min of the spindle."""
    radius_mm: Floats
    """mm, radius at the tool."""
    depth_mm: Floats
    """mm, depth of cut; 0: not in the cut."""
    travel_mm: Floats
    """mm, path of the tool at working feed in this cycle."""
    power_w: Floats
    """W, reported by the sensor at the end of the cycle."""
    fitted_w: Floats
    """W, computed by the model with the identified values."""

    def estimate(self, name: str) -> Estimate:
        """A value of the report with its interval, such as ``estimate("coefficient_over_efficiency_n")``."""
        return _estimate(self.report, name)


@dataclass(frozen=True)
class MillingCut:
    """A milling cut with one row for each cycle; see :class:`TurningCut`."""

    report: dict[str, Any]
    cut_text: str
    """The file of tool and material with the identified values."""
    time_s: Floats
    """s, from the beginning of the log."""
    rev_per_min: Floats
    """rev/min of the spindle."""
    removal_mm3_per_s: Floats
    """mm³/s, removed by the tool from the virtual workpiece."""
    rubbing_mm2_per_s: Floats
    """mm²/s of rubbing edges: their length in the cut times the cutting speed."""
    power_w: Floats
    """W, reported by the sensor at the end of the cycle; ``nan`` if it had no new value."""
    fitted_w: Floats
    """W, computed by the model with the identified values."""

    def estimate(self, name: str) -> Estimate:
        """A value of the report with its interval, such as ``estimate("force_n_per_mm2")``."""
        return _estimate(self.report, name)


@dataclass(frozen=True)
class GrindingCut:
    """A plunge cycle from a log; see :class:`TurningCut`."""

    report: dict[str, Any]
    process_text: str
    """The process file with the identified values."""
    time_s: Floats
    """s, from the beginning of the log."""
    x_mm: Floats
    """mm, commanded; the wheel touches the part at the allowance."""
    power_w: Floats
    """W, of the spindle of the wheel; ``nan`` if the sensor had no new value."""
    fitted_w: Floats
    """W, computed by the model with the identified values."""

    def estimate(self, name: str) -> Estimate:
        """A value of the report with its interval, such as ``estimate("stiffness_n_per_m")``."""
        return _estimate(self.report, name)


@dataclass(frozen=True)
class Lobes:
    """Stability lobes, one row for each speed. ``report`` is the JSON of the command. Every array is ``(n,)``."""

    report: dict[str, Any]
    speed_rev_per_min: Floats
    """rev/min of the spindle; in grinding, of the part."""
    depth_mm: Floats
    """mm, the smallest unstable depth; ``inf``: every depth is stable. In grinding, the width of the surface."""
    chatter_hz: Floats
    """Hz, frequency of the vibration at that depth; 0: not known."""


def lobes(
    cut: PathLike,
    speeds: tuple[float, float] = (1000.0, 20000.0),
    *,
    count: int = 800,
    cuts: Sequence[tuple[float, float]] = (),
    method: Literal["zeroth-order", "semi-discretisation"] = "zeroth-order",
) -> Lobes:
    """Stable depths of cut by speed: ``stanok process lobes``.

    Args:
        cut: the cut and the vibrations of tool and machine (TOML).
        speeds: range in rev/min.
        count: number of speeds in the range, 2 to 100000.
        cuts: planned cuts to assess: rev/min and depth in mm.
        method: method of solution.

    Raises:
        MachineFileError: faults of the file.
    """
    begin, end = (float(speed) for speed in speeds)
    if not 0.0 < begin < end < 1e9:
        raise ValueError(f"speeds are {begin} to {end}; give rising speeds in rev/min")
    if not 2 <= count <= 100_000:
        raise ValueError(f"count is {count}; give 2 to 100000")
    if method not in ("zeroth-order", "semi-discretisation"):
        raise ValueError(f"method is {method!r}; give 'zeroth-order' or 'semi-discretisation'")
    planned = [(float(speed), float(depth)) for speed, depth in cuts]
    if not all(0.0 < value < 1e9 for pair in planned for value in pair):
        raise ValueError("cuts: give a speed and a depth above 0 for each cut")
    text, arrays = _native.lobes(os.fspath(cut), (begin, end), count, planned, method)
    return Lobes(report=json.loads(text), **arrays)


def identify_turning(
    log: PathLike,
    stock: Sequence[tuple[float, float] | tuple[float, float, float]],
    *,
    channel: int = 1,
    spindle: int = 1,
    coefficient_n: float = 0.0,
) -> TurningCut:
    """Idle power, coefficient and exponent of the force, and lag of the sensor, from the log of a turning cut.

    Args:
        log: the log, with the power of the spindle.
        stock: the bar before the cut in program coordinates: pairs of Z and the radius from there on, mm; Z falls.
            Each may have the hardness from there on, HB, as a third number; C is then that of the first hardness.
        channel: channel of the cut.
        spindle: number of the spindle in the machine, from 1.
        coefficient_n: C of the material, N at 1 mm depth and 1 mm per revolution, if known; determines the efficiency.

    Raises:
        RuntimeError: data is missing from the log; the text names it.
    """
    steps = [(float(z), float(radius), float(hardness[0]) if hardness else 0.0) for z, radius, *hardness in stock]
    text, arrays = _native.identify_turning(os.fspath(log), steps, channel, spindle, coefficient_n)
    return TurningCut(report=json.loads(text), **arrays)


def identify_milling(
    log: PathLike,
    cut: PathLike,
    *,
    channel: int = 1,
    spindle: int = 1,
    tool: int | None = None,
    efficiency: float = 1.0,
) -> MillingCut:
    """Idle power, forces of material and edge, and lag of the sensor, from the log of a milling program.

    The program needs a workpiece (``#workpiece``). The log cuts it again to find the engagement of the tool.

    Args:
        log: the log, with the power of the spindle.
        cut: tool and material (TOML, as of :func:`lobes`); its teeth and helix are used, its forces are not.
        channel: channel of the cut.
        spindle: number of the spindle in the machine, from 1.
        tool: number of the tool whose cuts are used; ``None``: all tools.
        efficiency: efficiency of the drive, 0.1 to 1, if known; otherwise the results are forces divided by the
            efficiency.

    Raises:
        RuntimeError: data is missing from the log; the text names it.
        MachineFileError: faults of the file of tool and material.
    """
    if not 0.1 <= efficiency <= 1.0:
        raise ValueError(f"efficiency is {efficiency}; give 0.1 to 1")
    if tool is not None and tool < 1:
        raise ValueError(f"tool is {tool}; give the number of a tool, or None for all")
    text, arrays, cut_text = _native.identify_milling(os.fspath(log), os.fspath(cut), channel, spindle, tool or 0,
                                                      efficiency)
    return MillingCut(report=json.loads(text), cut_text=cut_text, **arrays)


def identify_grinding(
    log: PathLike,
    process: PathLike,
    *,
    channel: int = 1,
    spindle: int = 1,
    touch_mm: float | None = None,
    force_ratio: float = 0.4,
    wheel_speed_m_per_s: float = 35.0,
    efficiency: float = 0.85,
) -> GrindingCut:
    """Stiffness, coefficient and exponent of the force law from the log of a plunge cycle.

    Args:
        log: the log, with the power of the wheel's spindle.
        process: process file: geometry, speed, mass and damping; the search begins at its other values.
        channel: channel of the cycle.
        spindle: spindle of the wheel, its number in the machine, from 1.
        touch_mm: X of the program at which the wheel touches, mm; ``None``: the allowance.
        force_ratio: tangential force divided by normal force of the wheel, 0.05 to 2.
        wheel_speed_m_per_s: surface speed of the wheel, 1 to 200 m/s.
        efficiency: efficiency of the drive of the wheel, 0.1 to 1.

    Raises:
        RuntimeError: data is missing from the log; the text names it.
    """
    for name, value, low, high in (("force_ratio", force_ratio, 0.05, 2.0), ("efficiency", efficiency, 0.1, 1.0),
                                   ("wheel_speed_m_per_s", wheel_speed_m_per_s, 1.0, 200.0)):
        if not low <= value <= high:
            raise ValueError(f"{name} is {value}; give {low:g} to {high:g}")
    watts_per_newton = force_ratio * wheel_speed_m_per_s / efficiency
    text, arrays, process_text = _native.identify_grinding(os.fspath(log), os.fspath(process), channel, spindle,
                                                           touch_mm, watts_per_newton)
    return GrindingCut(report=json.loads(text), process_text=process_text, **arrays)


def _estimate(report: dict[str, Any], name: str) -> Estimate:
    value = report[name]
    if not isinstance(value, dict):
        raise KeyError(f"{name!r} has no interval")
    return Estimate(value["value"], value["low"], value["high"])
