"""The native module: numbers as arrays, all else as texts of JSON. Use the package, not this."""
import os
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

class Machine:
    def __init__(self, path: str | os.PathLike[str]) -> None: ...
    @property
    def path(self) -> Path: ...
    def description(self) -> str: ...

class Job:
    programs: list[tuple[int, str]]
    roots: list[str]
    events: list[str]
    schemes: list[tuple[int, int]]
    until_s: float
    drives: bool
    sensors: str
    def __init__(self) -> None: ...

def version() -> str: ...
def columns() -> list[str]: ...
def simulate(machine: Machine, job: Job, columns: list[str], every: int) -> tuple[str, dict[int, dict[str, npt.NDArray[Any]]]]: ...
