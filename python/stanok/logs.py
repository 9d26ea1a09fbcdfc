"""Logs: setpoints and events of a run as arrays, all at once or in chunks."""
from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any, overload

from . import _native
from .process_rows import ProcessRows
from .programs import PathLike
from .setpoints import Columns, Setpoints, column_names
from .simulation import Event

__all__ = ["Log", "open_log", "read_log"]

_events_at_a_time = 1000


class Log:
    """A log file. It is read once for its contents; setpoints and events are read again when requested.

    Only its description is kept in memory, however long the log is.
    """

    def __init__(self, path: PathLike) -> None:
        self._path = os.fspath(path)
        self._native = _native.Log(self._path)
        told: dict[str, Any] = json.loads(self._native.contents())
        self._info: dict[str, Any] = told["info"]
        self._axes: dict[int, list[list[str]]] = {int(number): axes for number, axes in told["axes"].items()}
        self._is_sound: bool = told["sound"]
        self._is_cut: bool = told["cut"]

    @property
    def path(self) -> str:
        """The file."""
        return self._path

    @property
    def info(self) -> dict[str, Any]:
        """What ``stanok log info --json`` prints: machine, version, messages, what is missing or damaged."""
        return dict(self._info)

    @property
    def channels(self) -> tuple[int, ...]:
        """Channels of the machine that have setpoints."""
        return tuple(self._axes)

    @property
    def is_sound(self) -> bool:
        """Whether nothing is damaged or cut. The readable parts of other logs are read."""
        return self._is_sound

    @property
    def is_cut(self) -> bool:
        """Whether the recording was cut: the log ends within an event, or without its trailer."""
        return self._is_cut

    def chunks(self, rows: int, *, channel: int | None = None, columns: Columns = "all") -> Iterator[Setpoints]:
        """The setpoints of a channel, ``rows`` at a time (the last ones fewer), in the order of the file.

        Needs the memory of one chunk: about 430 bytes per row of five axes with all columns.
        """
        if rows < 1:
            raise ValueError(f"rows is {rows}; give 1 or more")
        number = self._chosen(channel)
        names = column_names(columns)
        if not names:
            raise ValueError("columns is empty; give at least one name")
        cursor = _native.SetpointCursor(self._native, number, names)
        return self._read(cursor, number, rows)

    def setpoints(self, *, channel: int | None = None, columns: Columns = "all") -> Setpoints:
        """All setpoints of a channel; without ``channel``, of the only channel of the log."""
        number = self._chosen(channel)
        cursor = _native.SetpointCursor(self._native, number, column_names(columns))
        return self._setpoints(cursor.next(2**62), number)

    def process(self, channel: int | None = None) -> ProcessRows:
        """What the log tells of the cutting process of a channel: law, feed, spindle, power, force, vibration.

        One row every 50 ms; without ``channel``, of the only channel of the log. An hour takes 13 MB.
        """
        number = self._chosen(channel)
        arrays = _native.process_rows(self._path, number)
        if arrays["cycle"].size == 0:
            raise ValueError(f"the log has no process data of channel {number}")
        return ProcessRows(arrays, number)

    def events(self) -> Iterator[Event]:
        """Events in the order of the file: alarms, warnings, messages of programs.

        ``file`` is the file of the program, as in a simulation; empty if the log does not contain it.
        """
        cursor = _native.EventCursor(self._native)
        while True:
            told = json.loads(cursor.next(_events_at_a_time))
            if not told:
                return
            for event in told:
                yield Event(**event)

    def situations(self, *, channel: int | None = None) -> Iterator[dict[str, Any]]:
        """Situations: what determines the meaning of the words of programs, one for each change.

        Codes, units, work offset, the terms of the frames, tool and tool length, like a line of
        ``stanok log situations --json``; lengths in mm, angles in deg, axes by their words. A situation is valid
        from ``cycle`` on, including the setpoints of that cycle. ``channel`` ``None``: all channels, in the order of
        the file. Logs of 0.1.0 have none.
        """
        if channel is not None and channel < 1:
            raise ValueError(f"channel is {channel}; give 1 or more")
        cursor = _native.SituationCursor(self._native, channel or 0)
        while True:
            told = json.loads(cursor.next(_events_at_a_time))
            if not told:
                return
            yield from told

    def __repr__(self) -> str:
        return f"<Log {self._path}: channels {', '.join(map(str, self._axes)) or 'none'}>"

    def _chosen(self, channel: int | None) -> int:
        if channel is not None:
            return channel
        if len(self._axes) != 1:
            raise ValueError(f"{self._path} has setpoints of channels {', '.join(map(str, self._axes)) or 'none'}; "
                             "choose one with channel=")
        return next(iter(self._axes))

    def _read(self, cursor: _native.SetpointCursor, channel: int, rows: int) -> Iterator[Setpoints]:
        while arrays := cursor.next(rows):
            yield self._setpoints(arrays, channel)

    def _setpoints(self, arrays: dict[str, Any], channel: int) -> Setpoints:
        axes = self._axes[channel]
        for array in arrays.values():
            if array.ndim == 2 and len(axes) != array.shape[1]:  # as `log export` names those not described
                axes = [[f"A{k + 1}", f"A{k + 1}", "mm"] for k in range(array.shape[1])]
        return Setpoints(arrays, channel, *([axis[k] for axis in axes] for k in range(3)))


def open_log(path: PathLike) -> Log:
    """Opens a log; :class:`~stanok.errors.LogError` when it cannot be read."""
    return Log(path)


@overload
def read_log(path: PathLike, *, channel: int | None = ..., columns: Columns = ...,
             chunk: None = ...) -> Setpoints: ...
@overload
def read_log(path: PathLike, *, channel: int | None = ..., columns: Columns = ...,
             chunk: int) -> Iterator[Setpoints]: ...


def read_log(path: PathLike, *, channel: int | None = None, columns: Columns = "all",
             chunk: int | None = None) -> Setpoints | Iterator[Setpoints]:
    """The setpoints of one channel of a log, bit-identical to ``stanok log export``.

    Args:
        path: the log (``.lcm``).
        channel: channel of the machine; required if the log has several.
        columns: names of :data:`~stanok.ALL_COLUMNS`, or ``"all"``; ``None``: the usual ones.
        chunk: rows per chunk. An iterator of :class:`~stanok.Setpoints` is returned, and a log of any length
            needs the memory of one chunk.

    Returns:
        :class:`~stanok.Setpoints`: ``(n,)`` and ``(n, k)`` arrays, mm, deg and s.

    >>> for part in stanok.read_log("run.lcm", channel=1, chunk=100_000):
    ...     fastest = max(fastest, part.path_speed.max())
    """
    log = Log(path)
    if chunk is None:
        return log.setpoints(channel=channel, columns=columns)
    return log.chunks(chunk, channel=channel, columns=columns)
