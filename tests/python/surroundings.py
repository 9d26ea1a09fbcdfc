"""What the tests of the package need: the programs of the build, machines, texts in a folder, equal bits."""
import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
MACHINES = ROOT / "config" / "machines"
EXAMPLES = ROOT / "programs" / "examples"
BIN = Path(os.environ["STANOK_BIN"])


def stanok(*arguments, code=0, environment=None):
    """Standard output of the command line tool."""
    ended = subprocess.run([BIN / "stanok", *map(str, arguments)], capture_output=True, text=True, check=False,
                           env=environment)
    if ended.returncode != code:
        raise AssertionError(f"stanok {arguments}: exit code {ended.returncode}: {ended.stderr}")
    return ended.stdout


def columns_of_csv(path):
    """Columns of a CSV file by their heading, as texts."""
    with open(path, newline="", encoding="utf-8") as stream:
        rows = csv.reader(stream)
        heading = next(rows)
        columns = list(zip(*rows))
    return dict(zip(heading, columns))


def same_bits(array, other):
    """Whether two arrays have one shape, one type and the same bits; -0.0 is not 0.0."""
    array, other = np.asarray(array), np.asarray(other)
    return array.dtype == other.dtype and array.shape == other.shape and array.tobytes() == other.tobytes()


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path
