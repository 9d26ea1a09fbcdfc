"""stanok: an open CNC runtime, for those who study machines and cuts.

Simulation of whole machines into arrays, logs, kinematics, grinding cycles, and a client of a machine that
runs. Numbers are those of the programs ``stanok`` and ``stanokd``, bit for bit: the package calls the same
libraries. Lengths are mm, angles deg, times s.

>>> import stanok
>>> result = stanok.simulate("mill3.toml", "part.nc")
>>> setpoints = result[1]                      # of channel 1
>>> setpoints.time_s, setpoints.position       # (n,) s and (n, k) mm or deg
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
from .interpreter import Check, FeedLawBlock, Interpretation, check, interpret
from .kinematics import Jets, Kinematics
from .logs import Log, open_log, read_log
from .machine import Axis, Channel, Machine, Scheme, load_machine
from .programs import example_machine, example_program
from .rpc import Client, Notification, connect
from .setpoints import ALL_COLUMNS, USUAL_COLUMNS, Setpoints
from .simulation import Event, OperatorEvent, Run, Simulation, simulate

__version__: str = _native.version()

__all__ = [
    "ALL_COLUMNS",
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
    "ProgramError",
    "RequestError",
    "Run",
    "RunError",
    "Scheme",
    "Setpoints",
    "Simulation",
    "StanokError",
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
