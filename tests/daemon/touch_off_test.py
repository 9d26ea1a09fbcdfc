#!/usr/bin/env python3
"""Touching off at a running daemon: the axis then stands at the value that was given, in the words of the display.

usage: touch_off_test.py STANOKD LATHE_FILE
"""
import os
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

STANOKD, LATHE = sys.argv[1:3]
PROGRAM = "M0\nM30\n"


class TouchingOff(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.running = running_daemon(STANOKD, LATHE, PROGRAM)
        cls.operator = Operator(cls.running.__enter__().socket_path)
        cls.operator.ask("machine.on")
        cls.hand("G21", "T0101")

    @classmethod
    def tearDownClass(cls):
        cls.operator.socket.close()
        cls.running.__exit__(None, None, None)

    @classmethod
    def hand(cls, *lines):
        for line in lines:
            while True:
                answer = cls.operator.answer("mdi", text=line, channel=1, wait="done")
                code = answer.get("error", {}).get("data", {}).get("code")
                if code != "E6008":  # the drives are not ready yet
                    break
                time.sleep(0.1)
            if code:
                raise AssertionError(f"{line}: {answer['error']}")

    def status(self):
        return self.operator.ask("channel.status", channel=1)

    def settled(self, number):
        """The first status of another situation than this one: the table has taken effect."""
        while True:
            status = self.status()
            if status["situation"] != number:
                return status

    def touch(self, method="offset.touch", **parameters):
        parameters.setdefault("situation", self.status()["situation"])
        answer = self.operator.answer(method, channel=1, **parameters)
        if "error" in answer:
            return answer["error"]["data"]["code"]
        self.settled(parameters["situation"])
        return answer["result"]

    def test_the_axis_stands_at_the_value(self):
        for offset, axis, value in (("G54", "Z", 12.5), ("G55", "Z", -3.0)):
            self.hand(offset)
            result = self.touch(offset=offset, axis=axis, value=value, confirmed=1)
            self.assertAlmostEqual(self.status()["position"][axis], value, 9)
            row = self.operator.ask("offset.list")["offsets"][offset]
            self.assertEqual(row[axis], result["new"])
        self.hand("G54")
        self.assertAlmostEqual(self.status()["position"]["Z"], 12.5, 9)

    def test_a_diameter_says_what_it_is(self):
        self.assertEqual(self.status()["diameter"], ["X"])
        self.assertEqual(self.touch(offset="G54", axis="X", value=60.0, confirmed=1), "E6091")
        self.touch(offset="G54", axis="X", value=60.0, confirmed=1, **{"as": "diameter"})
        self.assertAlmostEqual(self.status()["position"]["X"], 60.0, 9)
        self.touch(offset="G54", axis="X", value=60.0, confirmed=1, **{"as": "radius"})
        self.assertAlmostEqual(self.status()["position"]["X"], 120.0, 9)
        self.assertAlmostEqual(self.status()["point_W"]["X"], 60.0, 9)

    def test_codes_do_not_change_what_a_value_means(self):
        for line in ("G20", "G91", "G8"):
            self.hand(line)
            self.touch(offset="G54", axis="Z", value=25.4, confirmed=1)
            self.assertAlmostEqual(self.status()["position"]["Z"], 25.4, 9)
        self.assertEqual(self.status()["units"], "inch")
        self.hand("G21", "G90", "G7")

    def test_a_tool_gets_its_length(self):
        self.hand("T0101")
        self.touch("tool.touch", number=1, axis="Z", value=3.25, confirmed=1)
        self.assertAlmostEqual(self.status()["position"]["Z"], 3.25, 9)
        self.assertEqual(self.touch("tool.touch", number=2, axis="Z", value=0.0), "E6092")
        self.assertEqual(self.touch("tool.touch", number=1, axis="C", value=0.0), "E6092")

    def test_what_was_not_seen_is_refused(self):
        seen = self.status()["situation"]
        self.hand("G56")
        self.assertEqual(self.touch(offset="G54", axis="Z", value=1.0, situation=seen), "E6090")
        self.hand("G54")

    def test_a_large_change_is_confirmed_and_taken_back(self):
        before = self.operator.ask("offset.list")["offsets"]["G57"]["Z"]
        self.hand("G57")
        self.assertEqual(self.touch(offset="G57", axis="Z", value=9999.0), "E6093")
        result = self.touch(offset="G57", axis="Z", value=9999.0, confirmed=1)
        self.assertEqual(result["old"], before)
        self.assertAlmostEqual(self.status()["position"]["Z"], 9999.0, 9)
        self.assertEqual(self.operator.ask("offset.undo", undo=result["undo"])["new"], before)
        self.assertEqual(self.operator.ask("offset.list")["offsets"]["G57"]["Z"], before)
        again = self.operator.answer("offset.undo", undo=result["undo"])
        self.assertEqual(again["error"]["data"]["code"], "E6094")
        self.hand("G54")

    def test_a_program_keeps_its_frames(self):
        self.operator.ask("program.run", program="part.nc", channel=1)
        while self.status()["held_by"] != "program stop":
            pass
        self.assertEqual(self.touch(offset="G54", axis="Z", value=1.0, confirmed=1), "E6003")
        self.operator.ask("program.stop", channel=1)
        while self.status()["state"] != "Reset":
            pass
        self.hand("T0101")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
