#!/usr/bin/env python3
"""The notebooks of python/notebooks: run from the first cell to the last, and kept without what a run leaves.

77: python3-nbclient, python3-ipykernel or python3-matplotlib are not here.
"""
import importlib.util
import json
import os
import re
import sys
import tempfile
import unittest

from surroundings import ROOT

NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))
SECONDS_MAX = 240


def run(notebook):
    """The notebook with its outputs; its assertions are in it."""
    import nbclient
    import nbformat
    read = nbformat.read(notebook, as_version=4)
    nbformat.validate(read)
    with tempfile.TemporaryDirectory() as folder:
        nbclient.NotebookClient(read, timeout=SECONDS_MAX, kernel_name="python3",
                                resources={"metadata": {"path": folder}}).execute()
        left = os.listdir(folder)
    if left:
        raise AssertionError(f"{notebook.name} leaves {left} behind")
    return read


class Notebooks(unittest.TestCase):
    def test_there_are_some(self):
        self.assertGreaterEqual(len(NOTEBOOKS), 3)

    def test_they_are_kept_without_outputs_and_paths(self):
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                text = notebook.read_text(encoding="utf-8")
                for cell in json.loads(text)["cells"]:
                    self.assertFalse(cell.get("outputs"))
                    self.assertIsNone(cell.get("execution_count"))
                self.assertIsNone(re.search(r'[\s"\'](/home|/root|/tmp|/usr|/work|/var)/', text))

    def test_they_run(self):
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                outputs = [output for cell in run(notebook).cells for output in cell.get("outputs", ())]
                pictures = [output for output in outputs if "image/png" in output.get("data", {})]
                self.assertGreaterEqual(len(pictures), 2)
                self.assertFalse([output for output in outputs if output.get("name") == "stderr"])


if __name__ == "__main__":
    for module in ("nbclient", "nbformat", "ipykernel", "matplotlib"):
        if importlib.util.find_spec(module) is None:
            print(f"SKIPPED: {module} is not here")
            sys.exit(77)
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # else the kernel warns of itself
    os.environ.setdefault("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    unittest.main()
