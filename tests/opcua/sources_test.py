#!/usr/bin/env python3
"""The sources of stanok-opcua: tsc reads them with all types of the protocol, and the parts are tested alone.

usage: sources_test.py FOLDER_OF_OPCUA [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import glob
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_opcua import Missing, packages  # noqa: E402

OPCUA = sys.argv.pop(1)


class Sources(unittest.TestCase):
    def expect_success(self, *words):
        ended = subprocess.run(["node", *words], cwd=OPCUA, capture_output=True, text=True)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)

    def test_types_are_sound(self):
        self.expect_success(os.path.join("node_modules", "typescript", "bin", "tsc"), "-p", ".")

    def test_the_parts_do_what_they_say(self):
        parts = sorted(glob.glob(os.path.join("tests", "*.test.js"), root_dir=OPCUA))
        self.assertTrue(parts)
        self.expect_success("--test", *parts)


if __name__ == "__main__":
    try:
        packages(OPCUA)
    except Missing as missing:
        print(f"SKIPPED: {missing}")
        sys.exit(77)
    unittest.main()
