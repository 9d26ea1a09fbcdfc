"""Errors as exceptions, each with a code, a place and a remedy.

All derive from :class:`StanokError`. Wrong arguments of a function raise the usual exceptions of
Python: ``ValueError``, ``TypeError``, ``FileNotFoundError``.
"""
from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .simulation import Simulation

__all__ = [
    "ConnectionLost",
    "Fault",
    "GrindingError",
    "LogError",
    "MachineFileError",
    "ProgramError",
    "RequestError",
    "RunError",
    "StanokError",
]


@dataclass(frozen=True)
class Fault:
    """An error or a warning, and its place.

    ``code`` is a row of the catalogue (``stanok explain CODE``), empty for faults of machine files.
    ``line`` and ``column`` count from 1; 0 if there is no place in a text.
    """

    code: str
    message: str
    severity: str = "error"
    file: str = ""
    line: int = 0
    column: int = 0
    remedy: str = ""
    source_line: str = ""
    channel: int = 0
    cycle: int = 0
    notes: tuple[str, ...] = field(default=())

    @classmethod
    def from_json(cls, value: dict[str, Any]) -> Fault:
        """From the members of ``stanok check --json``."""
        return cls(
            code=value.get("code") or "",
            message=value.get("message") or "",
            severity=value.get("severity") or "error",
            file=value.get("file") or "",
            line=value.get("line") or 0,
            column=value.get("column") or 0,
            remedy=value.get("remedy") or "",
            source_line=value.get("source_line") or "",
            channel=value.get("channel") or 0,
            cycle=value.get("cycle") or 0,
            notes=tuple(note["text"] for note in value.get("notes") or ()),
        )

    @property
    def place(self) -> str:
        """``"part.nc:12:5"``; empty if there is no place."""
        if not self.file:
            return f"line {self.line}" if self.line else ""
        place = self.file
        if self.line:
            place += f":{self.line}"
            if self.column:
                place += f":{self.column}"
        return place

    def __str__(self) -> str:
        text = f"{self.place}: " if self.place else ""
        text += f"{self.code} " if self.code else ""
        text += self.message
        return f"{text}; {self.remedy}" if self.remedy else text


class StanokError(Exception):
    """Base of all errors of stanok. ``faults`` has all faults; the properties describe the first one."""

    def __init__(self, faults: list[Fault] | tuple[Fault, ...] | str) -> None:
        if isinstance(faults, str):
            faults = (Fault(code="", message=faults),)
        self.faults: tuple[Fault, ...] = tuple(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))

    @classmethod
    def from_json(cls, text: str) -> StanokError:
        """From a list of faults as JSON; the native module creates errors in this way."""
        return cls([Fault.from_json(value) for value in json.loads(text)])

    @property
    def first(self) -> Fault:
        """The first fault that is an error."""
        for fault in self.faults:
            if fault.severity == "error":
                return fault
        return self.faults[0] if self.faults else Fault(code="", message="")

    @property
    def code(self) -> str:
        """Code of the catalogue, ``"E4031"``; empty for faults of machine files."""
        return self.first.code

    @property
    def message(self) -> str:
        """What is wrong, without place and remedy."""
        return self.first.message

    @property
    def file(self) -> str:
        """The file of the fault; empty: none."""
        return self.first.file

    @property
    def line(self) -> int:
        """Line of the fault, from 1; 0: no place in a text."""
        return self.first.line

    @property
    def column(self) -> int:
        """Column of the fault in characters, from 1; 0: none."""
        return self.first.column

    @property
    def remedy(self) -> str:
        """What to do about it."""
        return self.first.remedy


class MachineFileError(StanokError):
    """A machine or process file is wrong; ``faults`` lists them all."""


class ProgramError(StanokError):
    """A program cannot be loaded, or a block cannot be executed."""


class RunError(StanokError):
    """A simulation ended with alarms or refusals. ``result`` has what was simulated until then."""

    def __init__(self, faults: list[Fault] | tuple[Fault, ...] | str, result: Simulation | None = None) -> None:
        super().__init__(faults)
        self.result = result


class LogError(StanokError):
    """A log cannot be read."""


class GrindingError(StanokError):
    """A grinding cycle was refused before it was computed."""


class RequestError(StanokError):
    """The daemon refused a request. ``number`` is the code of JSON-RPC, ``data`` has further members."""

    def __init__(self, faults: list[Fault] | tuple[Fault, ...] | str, number: int = 0,
                 data: dict[str, Any] | None = None) -> None:
        super().__init__(faults)
        self.number = number
        self.data: dict[str, Any] = data or {}


class ConnectionLost(StanokError, ConnectionError):
    """There is no daemon, or the connection to it was lost."""
