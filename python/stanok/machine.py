"""Machine files: the description of a machine, read once and used for many calls."""
from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union

from . import _native

__all__ = ["Axis", "Channel", "Machine", "MachineLike", "Scheme", "load_machine"]

PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Axis:
    """An axis of the machine. Lengths mm, angles deg, times s; ``None``: no limit.

    ``stop_limits``: multiple of ``acceleration_max`` and ``jerk_max`` that a stop may use.
    """

    name: str
    unit: str
    position_min: float | None
    position_max: float | None
    velocity_max: float | None
    acceleration_max: float | None
    jerk_max: float | None
    stop_limits: float


@dataclass(frozen=True)
class Scheme:
    """A kinematic scheme that a channel can switch to."""

    id: int
    type: str
    file: str


@dataclass(frozen=True)
class Channel:
    """A channel with its axes: their names in the machine, their words in programs, and their units."""

    id: int
    name: str
    axes: tuple[str, ...]
    words: tuple[str, ...]
    units: tuple[str, ...]
    scheme: int
    schemes: tuple[Scheme, ...]


class Machine:
    """A machine file with all files that it names, as they were when they were read.

    It never changes, and several threads may use it at the same time.
    """

    def __init__(self, path: PathLike) -> None:
        self._native = _native.Machine(os.fspath(path))
        told: dict[str, Any] = json.loads(self._native.description())
        self._name: str = told["name"]
        self._cycle_s: float = told["cycle_s"]
        self._axes = tuple(Axis(**axis) for axis in told["axes"])
        self._channels = {channel["id"]: _channel(channel) for channel in told["channels"]}

    @property
    def path(self) -> Path:
        """The file from which it was read."""
        return Path(self._native.path)

    @property
    def name(self) -> str:
        """Name of the machine."""
        return self._name

    @property
    def cycle_s(self) -> float:
        """Time of a cycle, s."""
        return self._cycle_s

    @property
    def axes(self) -> tuple[Axis, ...]:
        """All axes with their limits, in the order of the machine file."""
        return self._axes

    @property
    def channels(self) -> dict[int, Channel]:
        """Channels by their number."""
        return dict(self._channels)

    def channel(self, number: int) -> Channel:
        """A channel by its number; ``ValueError`` when the machine does not have it."""
        if number not in self._channels:
            known = ", ".join(str(one) for one in self._channels)
            raise ValueError(f"machine {self.name} has no channel {number}; it has {known}")
        return self._channels[number]

    def __repr__(self) -> str:
        return f"<Machine {self.name}: {len(self.axes)} axes, {len(self._channels)} channels, {self.path}>"


MachineLike = Union[Machine, PathLike]


def load_machine(path: PathLike) -> Machine:
    """Reads a machine file (TOML).

    Raises :class:`~stanok.errors.MachineFileError` with every fault of the file and of the files it names.
    """
    return Machine(path)


def as_machine(machine: MachineLike) -> Machine:
    """The machine itself, or the machine that is read from this file."""
    return machine if isinstance(machine, Machine) else Machine(machine)


def _channel(told: dict[str, Any]) -> Channel:
    return Channel(
        id=told["id"],
        name=told["name"],
        axes=tuple(told["axes"]),
        words=tuple(told["words"]),
        units=tuple(told["units"]),
        scheme=told["scheme"],
        schemes=tuple(Scheme(**scheme) for scheme in told["schemes"]),
    )
