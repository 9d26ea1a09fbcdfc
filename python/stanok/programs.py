"""Locations of part programs, shared by the other modules."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Union

PathLike = Union[str, "os.PathLike[str]"]
Programs = Union[PathLike, Mapping[int, Union[PathLike, Sequence[PathLike]]]]


def located(program: PathLike) -> tuple[str, str]:
    """Name and folder of a program; its folder is the first one that is searched for other programs."""
    path = Path(program)
    if not path.name:
        raise ValueError(f"{str(program)!r} does not name a program")
    return path.name, str(path.parent)


def by_channel(programs: Programs, channel: int) -> list[tuple[int, PathLike]]:
    """Programs with their channels, in the order in which they are started."""
    if isinstance(programs, (str, os.PathLike)):
        return [(channel, programs)]
    pairs: list[tuple[int, PathLike]] = []
    for number, given in programs.items():
        several = [given] if isinstance(given, (str, os.PathLike)) else list(given)
        pairs.extend((number, one) for one in several)
    if not pairs:
        raise ValueError("no program is given")
    return pairs


def search_roots(folders: Sequence[str], program_root: PathLike | None) -> list[str]:
    """Folders of the programs, then ``program_root``, then the standard cycles of stanok."""
    roots = list(dict.fromkeys(folders))
    if program_root is not None:
        roots.append(os.fspath(program_root))
    return roots + standard_cycles()


def standard_cycles() -> list[str]:
    """Folders of the standard cycles: beside a build, or installed."""
    return [str(folder) for folder in _coming_with_stanok("programs/cycles", "cycles")]


def example_machine(name: str) -> Path:
    """The file of an example machine: ``example_machine("lathe")``; ``ValueError``: it does not exist."""
    return _example(_coming_with_stanok("config/machines", "machines"), f"{name}.toml")


def example_program(name: str) -> Path:
    """An example program or process file: ``example_program("helix.nc")``; ``ValueError``: it does not exist."""
    return _example(_coming_with_stanok("programs/examples", "examples"), name)


def _example(folders: list[Path], name: str) -> Path:
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    known = sorted(path.stem if name.endswith(".toml") else path.name
                   for folder in folders for path in folder.glob("*.*"))
    raise ValueError(f"stanok has no example {name}; it has {', '.join(known) or 'none'}")


def _coming_with_stanok(in_sources: str, installed: str) -> list[Path]:
    package = Path(__file__).resolve().parent
    candidates = [package.parents[3] / in_sources] if len(package.parents) > 3 else []
    candidates += [parent / "share" / "stanok" / installed for parent in package.parents[2:4]]
    return [folder for folder in candidates if folder.is_dir()]
