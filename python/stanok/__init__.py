"""stanok: an open CNC runtime, for the study of machines and cuts.

Simulation of whole machines into arrays, logs, kinematics, grinding cycles, and a client of a running
machine. Results are bit-identical to those of the programs ``stanok`` and ``stanokd``, because the package
calls the same libraries. Lengths are mm, angles deg, times s.

>>> import stanok
>>> result = stanok.simulate("mill3.toml", "part.nc")
>>> setpoints = result[1]                      # of channel 1
>>> setpoints.time_s, setpoints.position       # (n,) s and (n, k) mm or deg

============================================  ===========================================================
:func:`simulate`                              programs on a virtual machine, setpoints of every cycle
:func:`read_log`, :func:`open_log`            setpoints of a log, in chunks if it is long; its events and process
:func:`check`, :func:`interpret`              errors, feed laws, planes, records of a program
:class:`Kinematics`                           forward, inverse and derivatives of a machine's schemes
:mod:`stanok.grinding`                        plunge grinding cycles: design, verification, studies, model
:mod:`stanok.cutting`                         force constants and stiffness from the log of a cut
:func:`connect`                               a client of a running machine
:func:`load_machine`                          a machine file, read once for many calls
:func:`example_machine`                       example files of stanok; also :func:`example_program`
============================================  ===========================================================

All errors derive from :class:`StanokError` and have a code, a place and a remedy.
"""
from __future__ import annotations

from . import _native, cutting, grinding
from .errors import (
    ConnectionLost,
    Fault,
    GrindingError,
    LogError,
    MachineFileError,
    ProgramError,
    RequestError,
    RunError,
    StanokError,
)
from .interpreter import (
    Check,
    FeedLawBlock,
    Interpretation,
    OtherPosition,
    TiltedPlane,
    check,
    interpret,
)
from .kinematics import Jets, Kinematics
from .logs import Log, open_log, read_log
from .machine import Axis, Channel, Machine, Scheme, load_machine
from .process_rows import PROCESS_COLUMNS, ProcessRows
from .programs import example_machine, example_program
from .rpc import Client, Notification, connect, stop
from .setpoints import ALL_COLUMNS, USUAL_COLUMNS, Setpoints
from .simulation import Event, OperatorEvent, Run, Simulation, simulate

__version__: str = _native.version()

__all__ = [
    "ALL_COLUMNS",
    "PROCESS_COLUMNS",
    "USUAL_COLUMNS",
    "Axis",
    "Channel",
    "Check",
    "Client",
    "ConnectionLost",
    "Event",
    "Fault",
    "FeedLawBlock",
    "GrindingError",
    "Interpretation",
    "Jets",
    "Kinematics",
    "Log",
    "LogError",
    "Machine",
    "MachineFileError",
    "Notification",
    "OperatorEvent",
    "OtherPosition",
    "ProcessRows",
    "ProgramError",
    "RequestError",
    "Run",
    "RunError",
    "Scheme",
    "Setpoints",
    "Simulation",
    "StanokError",
    "TiltedPlane",
    "check",
    "connect",
    "cutting",
    "example_machine",
    "example_program",
    "grinding",
    "interpret",
    "load_machine",
    "open_log",
    "read_log",
    "simulate",
]
