#!/usr/bin/env python3
"""Programs in the form that stock posts of other CAM systems write (docs/programmer/cam.md): they are checked and
simulated, and so are codes that the guide names; others are refused.

usage: forms_test.py STANOK ROOT_OF_THE_PROJECT
"""
import pathlib
import sys
import tempfile
import unittest

STANOK, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/posts"))

import readings  # noqa: E402

MACHINE = ROOT / "config/machines/trunnion.toml"
TAKEN = {"haas": ("G254\nG0 C30\nG255", "M3 S1000\nG234 H2\nG1 X1 F100\nG49")}
REFUSED = {"haas": ("G268",), "linuxcnc": ("G83 X0 Y0 Z-5 R5 Q2 P0 F100",)}


class Forms(unittest.TestCase):
    def test_every_form_is_checked_and_simulated(self):
        forms = sorted((ROOT / "tests/posts/forms").glob("*.nc"))
        self.assertEqual(len(forms), 6)
        for form in forms:
            for command in ("check", "simulate"):
                with self.subTest(form=form.name, command=command):
                    code, output = readings.run(STANOK, command, "--machine", MACHINE, form)
                    self.assertEqual(code, 0, output)
                    self.assertNotIn("warning", output)

    def checked(self, codes_of):
        """Code, result and output of each."""
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "code.nc"
            for dialect, codes in codes_of.items():
                for code in codes:
                    program.write_text(f"(dialect {dialect})\nT2 M6\nG43 H2\n{code}\nM30\n", encoding="utf-8")
                    yield code, *readings.run(STANOK, "check", "--machine", MACHINE, program)

    def test_codes_that_the_guide_names_are_taken(self):
        for code, result, output in self.checked(TAKEN):
            self.assertEqual(result, 0, f"{code}: {output}")

    def test_codes_that_the_guide_does_not_name_are_refused(self):
        for code, result, output in self.checked(REFUSED):
            self.assertNotEqual(result, 0, code)
            self.assertIn("code.nc:4:", output)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
