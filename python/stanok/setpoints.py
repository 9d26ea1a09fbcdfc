"""Setpoints of a channel as arrays, from a simulation or a log."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Literal, Union

import numpy as np
import numpy.typing as npt

from . import _native

__all__ = ["ALL_COLUMNS", "USUAL_COLUMNS", "Columns", "Setpoints"]

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

ALL_COLUMNS: tuple[str, ...] = tuple(_native.columns())
"""Every column, in the order of ``stanok log export``."""

USUAL_COLUMNS: tuple[str, ...] = ("time_s", "line", "path_speed", "tip_position", "position", "velocity")
"""The columns that are kept by default: 140 bytes per cycle for five axes."""

Columns = Union[Literal["all"], Sequence[str], None]


def column_names(columns: Columns) -> list[str]:
    """``None``: the usual columns; ``"all"``: all columns."""
    if columns is None:
        return list(USUAL_COLUMNS)
    if isinstance(columns, str):
        if columns == "all":
            return list(ALL_COLUMNS)
        raise ValueError(f"columns is {columns!r}; give 'all' or a list of names")
    return [str(name) for name in columns]


class Setpoints(Mapping[str, "npt.NDArray[Any]"]):
    """Setpoints of one channel, one row for each cycle that is kept.

    A mapping of names to arrays; each array is also a property. ``n`` is the number of rows, ``k`` the number
    of axes, in the order of ``axes``. Lengths are mm, angles deg, times s. The numbers are bit-identical to
    ``stanok log export``. A column that was not requested raises a ``KeyError`` that says so.
    """

    def __init__(self, arrays: Mapping[str, npt.NDArray[Any]], channel: int, axes: Sequence[str],
                 words: Sequence[str], units: Sequence[str]) -> None:
        self._arrays = dict(arrays)
        self._channel = channel
        self._axes = tuple(axes)
        self._words = tuple(words)
        self._units = tuple(units)

    @property
    def channel(self) -> int:
        """Number of the channel."""
        return self._channel

    @property
    def axes(self) -> tuple[str, ...]:
        """Names of the axes in the machine: the columns of a matrix."""
        return self._axes

    @property
    def words(self) -> tuple[str, ...]:
        """The words of the same axes in programs."""
        return self._words

    @property
    def units(self) -> tuple[str, ...]:
        """``"mm"`` or ``"deg"`` of each axis."""
        return self._units

    @property
    def rows(self) -> int:
        """Number of rows, ``n``."""
        for array in self._arrays.values():
            return int(array.shape[0])
        return 0

    def axis(self, name: str) -> int:
        """Column of an axis, by its name in the machine or its word in programs."""
        for names in (self._axes, self._words):
            if name in names:
                return names.index(name)
        raise KeyError(f"channel {self._channel} has no axis {name!r}; it has {', '.join(self._axes)}")

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        if name in self._arrays:
            return self._arrays[name]
        if name in ALL_COLUMNS:
            raise KeyError(f"{name!r} was not kept; name it in columns, or give columns='all'")
        raise KeyError(f"there is no column {name!r}; the columns are {', '.join(ALL_COLUMNS)}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"<Setpoints of channel {self._channel}: {self.rows} rows, axes {' '.join(self._axes)}>"

    @property
    def time_s(self) -> Floats:
        """``(n,)`` s, machine time from the first cycle on."""
        return self["time_s"]

    @property
    def cycle(self) -> Integers:
        """``(n,)`` int64, number of the cycle."""
        return self["cycle"]

    @property
    def seq(self) -> Integers:
        """``(n,)`` int64, number of the setpoint of this channel; a gap means a loss."""
        return self["seq"]

    @property
    def state(self) -> npt.NDArray[np.int8]:
        """``(n,)`` int8: 0 idle, 1 ready, 2 running, 3 held, 4 alarm."""
        return self["state"]

    @property
    def flags(self) -> npt.NDArray[np.int8]:
        """``(n,)`` int8: bit 0 moving, 1 waiting, 2 a program run is in progress."""
        return self["flags"]

    @property
    def run(self) -> npt.NDArray[np.int32]:
        """``(n,)`` int32, program run of the channel, from 1; 0: none yet."""
        return self["run"]

    @property
    def file(self) -> npt.NDArray[np.int16]:
        """``(n,)`` int16, number of the program text in ``Run.files``."""
        return self["file"]

    @property
    def line(self) -> npt.NDArray[np.int32]:
        """``(n,)`` int32, line of the program text; 0: no program runs."""
        return self["line"]

    @property
    def block(self) -> Integers:
        """``(n,)`` int64, number of the block in the run."""
        return self["block"]

    @property
    def scheme(self) -> npt.NDArray[np.int32]:
        """``(n,)`` int32, active kinematic scheme."""
        return self["scheme"]

    @property
    def feed_commanded(self) -> Floats:
        """``(n,)`` mm/s, the programmed feed before override; 0 in rapid."""
        return self["feed_commanded"]

    @property
    def path_speed(self) -> Floats:
        """``(n,)`` mm/s along the path."""
        return self["path_speed"]

    @property
    def feed_override(self) -> Floats:
        """``(n,)``, 1 is 100 %."""
        return self["feed_override"]

    @property
    def tip_position(self) -> Floats:
        """``(n, k)`` mm or deg, programmed point in the workpiece system."""
        return self["tip_position"]

    @property
    def tip_velocity(self) -> Floats:
        """``(n, k)`` mm/s or deg/s, of the programmed point."""
        return self["tip_velocity"]

    @property
    def position(self) -> Floats:
        """``(n, k)`` mm or deg, of the machine axes."""
        return self["position"]

    @property
    def velocity(self) -> Floats:
        """``(n, k)`` mm/s or deg/s, of the machine axes."""
        return self["velocity"]

    @property
    def acceleration(self) -> Floats:
        """``(n, k)`` mm/s² or deg/s², of the machine axes."""
        return self["acceleration"]

    @property
    def jerk(self) -> Floats:
        """``(n, k)`` mm/s³ or deg/s³, of the machine axes."""
        return self["jerk"]

    @property
    def position_code(self) -> Integers:
        """``(n, k)`` int64, increments."""
        return self["position_code"]

    @property
    def velocity_code(self) -> Integers:
        """``(n, k)`` int64, increments per cycle times Kmv, mean of the cycle."""
        return self["velocity_code"]
