#!/usr/bin/env python3
"""Values that are not likely, at a running daemon: refused, asked about on a terminal, taken when they are confirmed,
and kept from programs.

usage: entry_limits_test.py STANOKD STANOK MILL_FILE
"""
import os
import pty
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

STANOKD, STANOK, MILL = sys.argv[1:4]
PROGRAM = "G21 G90 G17 G94\nG10 L2 P1 X99999\nM30\n"


class EntryLimits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.running = running_daemon(STANOKD, MILL, PROGRAM)
        cls.daemon = cls.running.__enter__()
        cls.operator = Operator(cls.daemon.socket_path)
        cls.operator.ask("machine.on")

    @classmethod
    def tearDownClass(cls):
        cls.operator.close()
        cls.running.__exit__(None, None, None)

    def code(self, method, **parameters):
        answer = self.operator.answer(method, **parameters)
        return answer["error"]["data"]["code"] if "error" in answer else ""

    def length(self, tool=1):
        return self.operator.ask("tool.get", number=tool)["length"]

    def offset(self, axis, name="G55"):
        return self.operator.ask("offset.list")["offsets"][name][axis]

    def words(self, *words):
        return [STANOK, *words, "--socket", self.daemon.socket_path]

    def without_terminal(self, *words):
        return subprocess.run(self.words(*words), stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)

    def on_a_terminal(self, answer, *words):
        """Exit code, and what the terminal is sent; `answer` is typed when it is asked for."""
        ours, its = pty.openpty()
        process = subprocess.Popen(self.words(*words), stdin=its, stdout=its, stderr=its,
                                   env={**os.environ, "NO_COLOR": "1", "TERM": "xterm"})
        os.close(its)
        sent, asked = b"", False
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other side is closed
                break
            if not piece:
                break
            sent += piece
            if not asked and b"[y/N]" in sent:
                asked = True
                os.write(ours, answer.encode())
        os.close(ours)
        return process.wait(), sent.decode()

    def test_entries_are_refused_until_they_are_confirmed(self):
        before = self.length()
        for value in (-5, 99999):
            self.assertEqual(self.code("tool.set", number=1, key="length", value=value), "E6095")
            self.assertNotEqual(self.length(), value)
            self.assertEqual(self.code("tool.set", number=1, key="length", value=value, confirmed=1), "")
            self.assertEqual(self.length(), value)
        self.assertEqual(self.code("tool.set", number=1, key="length", value=before, confirmed=1), "")
        self.assertEqual(self.code("offset.set", offset="G56", axis="X", value=99999), "E6095")
        self.assertEqual(self.offset("X", "G56"), 0)
        self.assertEqual(self.code("offset.set", offset="G56", axis="X", value=99999, confirmed=1), "")
        self.assertEqual(self.offset("X", "G56"), 99999)

    def test_true_says_the_same_as_1(self):
        self.assertEqual(self.code("tool.set", number=2, key="wear_radius", value=80, confirmed=False), "E6095")
        self.assertEqual(self.code("tool.set", number=2, key="wear_radius", value=80, confirmed=True), "")
        self.assertEqual(self.code("tool.set", number=2, key="wear_radius", value=0), "")

    def test_a_text_is_refused_with_its_rows(self):
        tables = "[[tool]]\nnumber = 2\nradius = 5000\n[offset.G57]\nX = 99999\nY = 1\n"
        message = self.operator.answer("tool.load", tables=tables)["error"]["message"]
        self.assertIn("tool 2, radius: 5000 mm is more than 250 mm (tool_radius_max)", message)
        self.assertIn("G57 X: 99999 mm is more than", message)
        self.assertEqual(self.offset("Y", "G57"), 0)

    def test_touching_off_to_a_length_below_the_least_is_asked_about(self):
        self.assertLess(0, self.length())
        self.hand("T1 M6", "G49")
        status = self.operator.ask("channel.status", channel=1)
        value = status["position"]["Z"] + 5  # the tip of a tool of -5 mm is there
        touch = {"number": 1, "axis": "Z", "value": value, "situation": status["situation"], "channel": 1}
        answer = self.operator.answer("tool.touch", **touch)
        self.assertEqual(answer["error"]["data"]["code"], "E6093")
        self.assertIn("-5 mm is less than 0 mm (tool_length_min)", answer["error"]["message"])

    def hand(self, *lines):
        for line in lines:
            while (code := self.code("mdi", text=line, channel=1, wait="done")) == "E6008":
                time.sleep(0.1)  # the drives are not ready yet
            self.assertEqual(code, "", line)

    def test_programs_are_refused_whether_run_or_by_hand(self):
        before = self.offset("X", "G54")
        self.assertEqual(self.code("mdi", text="G10 L1 P1 Z-5", channel=1, wait="done"), "E5022")
        self.reset()
        self.operator.ask("program.run", program="part.nc", channel=1)
        while not (alarms := [a for a in self.operator.ask("alarm.list")["alarms"] if a["file"]]):
            pass
        self.assertEqual(alarms[-1]["code"], "E5022")
        self.assertEqual((alarms[-1]["line"], alarms[-1]["column"]), (2, 1))
        self.assertEqual(self.offset("X", "G54"), before)
        self.reset()

    def reset(self):
        self.operator.ask("program.reset", channel=1)
        while self.operator.ask("channel.status", channel=1)["state"] != "Reset":
            pass

    def test_the_command_line_asks_on_a_terminal(self):
        code, sent = self.on_a_terminal("n\n", "offset", "set", "G55", "X", "99999")
        self.assertIn("G55 X: 99999 mm is more than", sent)
        self.assertIn("Really? [y/N]", sent)
        self.assertNotEqual(code, 0)
        self.assertEqual(self.offset("X"), 0)
        code, sent = self.on_a_terminal("y\n", "offset", "set", "G55", "X", "99999")
        self.assertEqual(code, 0, sent)
        self.assertEqual(self.offset("X"), 99999)
        code, sent = self.on_a_terminal("y\n", "tool", "set", "3", "length", "99999")
        self.assertEqual(code, 0, sent)
        self.assertEqual(self.length(3), 99999)

    def test_the_command_line_asks_nobody_without_a_terminal(self):
        told = self.without_terminal("offset", "set", "G58", "Y", "99999")
        self.assertNotEqual(told.returncode, 0)
        self.assertIn("E6095", told.stderr)
        self.assertIn("--confirmed 1", told.stderr)
        self.assertNotIn("[y/N]", told.stderr)
        self.assertEqual(self.offset("Y", "G58"), 0)
        told = self.without_terminal("offset", "set", "G58", "Y", "99999", "--confirmed", "1")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual(self.offset("Y", "G58"), 99999)
        code, sent = self.on_a_terminal("y\n", "tool", "set", "2", "wear_length", "80", "--json")
        self.assertNotEqual(code, 0)
        self.assertNotIn("[y/N]", sent)

    def test_check_and_simulate_find_it(self):
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, "part.nc")
            with open(part, "w", encoding="utf-8") as file:
                file.write(PROGRAM)
            for command in ("check", "simulate"):
                with self.subTest(command=command):
                    told = subprocess.run([STANOK, command, "--machine", MILL, part], cwd=folder,
                                          capture_output=True, text=True, check=False)
                    self.assertNotEqual(told.returncode, 0)
                    self.assertIn("E5022", told.stdout + told.stderr)
                    self.assertIn("part.nc:2:1", told.stdout + told.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
