#!/usr/bin/env python3
"""Type hints and documentation of the package: mypy agrees, the stub is what the module is, all is documented.

77: mypy is not here.
"""
import importlib.util
import inspect
import os
import subprocess
import sys
import tempfile
import unittest

import stanok
from stanok import _native, cutting, grinding
from surroundings import ROOT, InFolder

PACKAGE = ROOT / "python" / "stanok"


class Types(InFolder):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.cache = folder.name

    def judged(self, *arguments):
        """What mypy says, reading the sources and not what is built."""
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
        environment.pop("PYTHONPATH")
        return subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", self.cache, *map(str, arguments)],
                              capture_output=True, text=True, check=False, env=environment)

    def test_hints_are_sound(self):
        ended = self.judged("--strict", PACKAGE)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)

    def test_a_wrong_use_is_found(self):
        script = self.write("script.py", "import stanok\n"
                            "result = stanok.simulate('m.toml', 'p.nc')\n"
                            "reveal_type(result[1].position)\n"
                            "stanok.simulate('m.toml', 'p.nc', until='soon')\n"
                            "for part in stanok.read_log('run.lcm', chunk=5):\n    reveal_type(part)\n")
        ended = self.judged("--strict", script)
        self.assertIn('Unexpected keyword argument "until"', ended.stdout)
        self.assertIn("numpy.dtype[numpy.floating", ended.stdout)
        self.assertIn('Revealed type is "stanok.setpoints.Setpoints"', ended.stdout)

    def test_the_stub_is_what_the_module_is(self):
        classes = [name for name, value in vars(_native).items() if inspect.isclass(value)]
        # pybind11 has a metaclass of its own, which no stub can name.
        known = self.write("known.txt", "".join(f"stanok._native.{name}\n" for name in classes))
        # The module lies in the PYTHONPATH as it is built; mypy reads the stub there.
        ended = subprocess.run([sys.executable, "-m", "mypy.stubtest", "stanok._native", "--allowlist", known],
                               capture_output=True, text=True, check=False,
                               env={**os.environ, "MYPYPATH": os.environ["PYTHONPATH"]})
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)


class Documentation(unittest.TestCase):
    def test_everything_public_is_documented(self):
        for module in (stanok, cutting, grinding):
            self.assertTrue(module.__doc__)
            for name in module.__all__:
                thing = getattr(module, name)
                if not (inspect.isclass(thing) or inspect.isfunction(thing)):
                    continue
                with self.subTest(name):
                    self.assertTrue(thing.__doc__)
                    self.assertFalse(thing.__doc__.startswith(f"{name}("), "dataclasses make that one up")
                for member, value in vars(thing).items() if inspect.isclass(thing) else ():
                    is_told = isinstance(value, property) or inspect.isfunction(value)
                    if is_told and not member.startswith("_"):
                        with self.subTest(f"{name}.{member}"):
                            self.assertTrue(value.__doc__)

    def test_help_has_shapes_and_units(self):
        ended = subprocess.run([sys.executable, "-c", "import stanok; help(stanok.Setpoints); help(stanok.simulate)"],
                               capture_output=True, text=True, check=True)
        for text in ("``(n, k)`` mm or deg", "``(n,)`` s, machine time", "mm/s", "Raises:", "program_root"):
            self.assertIn(text, ended.stdout)


if __name__ == "__main__":
    if importlib.util.find_spec("mypy") is None:
        print("SKIPPED: mypy is not here")
        sys.exit(77)
    unittest.main()
