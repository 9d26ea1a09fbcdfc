#!/usr/bin/env python3
"""A start behind a block search, against a running daemon: with the approach that was shown, or not at all.

usage: start_from_line_test.py STANOKD STANOK MACHINE_FILE
"""
import json
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

STANOKD, STANOK, MACHINE = sys.argv[1:4]
PROGRAM = "G21 G90 G54\nT1 M6\nS1000 M3\nM8\nG0 X10 Y10 Z5\nG1 Z-1 F600\nX50\nY40\nG0 Z20\nM30\n"


class StartFromALine(unittest.TestCase):
    def setUp(self):
        running = running_daemon(STANOKD, MACHINE, PROGRAM)
        self.daemon = running.__enter__()
        self.addCleanup(running.__exit__, None, None, None)
        self.operator = Operator(self.daemon.socket_path)
        self.addCleanup(self.operator.close)
        self.operator.ask("machine.on")
        self.operator.ask("home")
        self.line("G0 X-60 Y-40 Z-5")
        self.operator.ask("program.load", program="part.nc", wait="done")

    def line(self, text):
        self.operator.ask("mdi", text=text, wait="done")

    def start(self, **parameters):
        answer = self.operator.answer("program.start", wait="done", **parameters)
        return answer["error"]["data"]["code"] if "error" in answer else ""

    def place(self):
        return self.operator.ask("channel.status")["point_W"]

    def test_the_way_is_told_and_confirmed(self):
        approach = self.operator.ask("program.search", target="8")["approach"]
        self.assertEqual([move["kind"] for move in approach["moves"]], ["lift", "lateral", "plunge"])
        self.assertAlmostEqual(approach["moves"][1]["to"]["Z"], 5.0)
        self.assertEqual(approach["moves"][2]["feed_mm_min"], 600.0)
        self.assertEqual(len(approach["changes"]), 3)
        before = self.place()
        self.assertEqual(self.start(), "E6045")
        self.assertEqual(self.start(approach=approach["number"] + 1), "E6046")
        self.assertEqual(self.start(approach=approach["number"]), "E6047")
        self.assertEqual(self.place(), before)
        self.assertEqual(self.start(approach=approach["number"], restore=1), "")
        self.assertAlmostEqual(self.place()["Z"], 20.0)

    def test_what_has_changed_since_is_another_way(self):
        number = self.operator.ask("program.search", target="8")["approach"]["number"]
        self.line("G0 X-50")
        self.assertEqual(self.start(approach=number, restore=1), "E6046")
        number = self.operator.ask("program.search", target="8")["approach"]["number"]
        self.operator.ask("tool.set", number=1, key="length", value=51.0)
        self.assertEqual(self.start(approach=number, restore=1), "E6046")
        number = self.operator.ask("program.search", target="8")["approach"]["number"]
        self.assertEqual(self.start(approach=number, restore=1), "")

    def test_the_terminal_shows_the_way(self):
        told = self.stanok("program", "search", "8")
        for word in ("lift", "plunge", "600", "tool 1 instead of 0", "--approach 1"):
            self.assertIn(word, told.stdout)
        refused = self.stanok("program", "start")
        self.assertIn("E6045", refused.stderr)
        self.assertNotEqual(refused.returncode, 0)
        started = self.stanok("program", "start", "--approach", "1", "--restore", "--wait", "--json")
        self.assertEqual(started.returncode, 0, started.stdout + started.stderr)
        self.assertTrue(json.loads(started.stdout)["ok"])

    def stanok(self, *arguments):
        return subprocess.run([STANOK, *arguments, "--socket", self.daemon.socket_path], capture_output=True,
                              text=True, check=False, timeout=120)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
