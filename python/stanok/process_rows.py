"""What a log tells of the cutting process of a channel, as arrays."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native

__all__ = ["PROCESS_COLUMNS", "ProcessRows"]

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

_told: dict[str, tuple[str, str]] = {name: (unit, meaning) for name, unit, meaning in _native.process_columns()}

PROCESS_COLUMNS: tuple[str, ...] = tuple(_told)
"""Every column, in the order of ``stanok log export --process``."""


class ProcessRows(Mapping[str, "npt.NDArray[Any]"]):
    """What a log tells of the cutting process of one channel, one row every 50 ms.

    A mapping of names to arrays of ``n`` rows; each array is also a property. ``nan`` is what a row does not
    have: force control tells nothing while it is off. Lengths are mm, times s. The numbers are bit-identical
    to ``stanok log export --process``. ``cycle`` finds the setpoints of a row::

        rows = log.process()
        at = np.searchsorted(setpoints.cycle, rows.cycle)
        setpoints.position[at], rows.power_w
    """

    def __init__(self, arrays: Mapping[str, npt.NDArray[Any]], channel: int) -> None:
        self._arrays = dict(arrays)
        self._channel = channel

    @property
    def channel(self) -> int:
        """Number of the channel."""
        return self._channel

    @property
    def rows(self) -> int:
        """Number of rows, ``n``."""
        return int(self.cycle.shape[0])

    @staticmethod
    def unit(name: str) -> str:
        """Unit of a column, for example ``"mm/min"``; empty if it has none."""
        return _told[name][0]

    @staticmethod
    def meaning(name: str) -> str:
        """Meaning of a column."""
        return _told[name][1]

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        if name in self._arrays:
            return self._arrays[name]
        raise KeyError(f"there is no column {name!r}; the columns are {', '.join(PROCESS_COLUMNS)}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"<ProcessRows of channel {self._channel}: {self.rows} rows>"

    # Documented from the table of columns, below.

    @property
    def cycle(self) -> Integers:
        return self["cycle"]

    @property
    def time_s(self) -> Floats:
        return self["time_s"]

    @property
    def law(self) -> Floats:
        return self["law"]

    @property
    def increments(self) -> Floats:
        return self["increments"]

    @property
    def stands(self) -> Floats:
        return self["stands"]

    @property
    def feed_mm_min(self) -> Floats:
        return self["feed_mm_min"]

    @property
    def feed_mm_rev(self) -> Floats:
        return self["feed_mm_rev"]

    @property
    def spindle_rev_min(self) -> Floats:
        return self["spindle_rev_min"]

    @property
    def cutting_speed_m_min(self) -> Floats:
        return self["cutting_speed_m_min"]

    @property
    def force_state(self) -> Floats:
        return self["force_state"]

    @property
    def force_set_n(self) -> Floats:
        return self["force_set_n"]

    @property
    def force_set_mean_n(self) -> Floats:
        return self["force_set_mean_n"]

    @property
    def force_n(self) -> Floats:
        return self["force_n"]

    @property
    def power_w(self) -> Floats:
        return self["power_w"]

    @property
    def power_idle_w(self) -> Floats:
        return self["power_idle_w"]

    @property
    def radius_mm(self) -> Floats:
        return self["radius_mm"]

    @property
    def feed_requested_mm_min(self) -> Floats:
        return self["feed_requested_mm_min"]

    @property
    def feed_min_mm_min(self) -> Floats:
        return self["feed_min_mm_min"]

    @property
    def feed_max_mm_min(self) -> Floats:
        return self["feed_max_mm_min"]

    @property
    def vibration_um(self) -> Floats:
        return self["vibration_um"]

    @property
    def vibration_hz(self) -> Floats:
        return self["vibration_hz"]

    @property
    def oscillation_n(self) -> Floats:
        return self["oscillation_n"]

    @property
    def oscillation_hz(self) -> Floats:
        return self["oscillation_hz"]


def _document() -> None:
    for name, (unit, meaning) in _told.items():
        kind = " int64" if name == "cycle" else f" {unit}" if unit else ""
        getattr(ProcessRows, name).__doc__ = f"``(n,)``{kind}, {meaning}."


_document()
