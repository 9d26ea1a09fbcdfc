#!/usr/bin/env python3
"""Records, checks and feed laws in Python against `stanok interpret` and `stanok check --estimate`."""
import json
import os
import signal
import threading
import unittest

import stanok
from surroundings import EXAMPLES, MACHINES, InFolder
from surroundings import stanok as command

MILL = MACHINES / "mill3.toml"
TRUNNION = MACHINES / "trunnion.toml"
LATHE = MACHINES / "lathe.toml"


class Programs(InFolder):
    def test_records_are_those_of_the_command(self):
        for machine, program in (("mill3", "helix.nc"), ("mill3", "bolt_circle.nc"), ("lathe", "chip_breaking.nc"),
                                 ("trunnion", "trunnion.nc")):
            with self.subTest(program):
                given = MACHINES / f"{machine}.toml"
                text = command("interpret", EXAMPLES / program, "--machine", given)
                result = stanok.interpret(given, EXAMPLES / program)
                self.assertEqual(result.records, [json.loads(line) for line in text.splitlines()])
                summary = json.loads(command("interpret", EXAMPLES / program, "--machine", given, "--quiet"))
                self.assertEqual(result.blocks, summary["blocks"])

    def test_texts_of_programs_may_have_any_characters(self):
        text = "a\u2028b\u0085c"
        program = self.write("part.nc", f"(MSG, {text})\nM30\n")
        told = [record["text"] for record in stanok.interpret(MILL, program).records if record["kind"] == "message"]
        self.assertEqual(told, [text])

    def test_feed_laws_are_those_of_the_command(self):
        for program in ("chip_breaking.nc", "slender_shaft.nc"):
            told = json.loads(command("check", EXAMPLES / program, "--machine", LATHE, "--estimate", "--json"))
            result = stanok.check(LATHE, EXAMPLES / program)
            self.assertTrue(result.ok)
            self.assertGreater(len(result.feed_laws), 0)
            self.assertEqual(len(result.feed_laws), len(told["feed_laws"]))
            for block, expected in zip(result.feed_laws, told["feed_laws"]):
                has = {name: value for name, value in vars(block).items() if value is not None}
                self.assertEqual(has, expected)

    def test_tilted_planes_are_those_of_the_command(self):
        program = EXAMPLES / "tilted_planes.nc"
        told = json.loads(command("check", program, "--machine", TRUNNION, "--estimate", "--json"))["tilted_planes"]
        planes = stanok.check(TRUNNION, program).tilted_planes
        self.assertEqual([(plane.line, list(plane.tool), plane.axes) for plane in planes],
                         [(one["line"], one["tool"], one["axes"]) for one in told])
        self.assertEqual([plane.axes for plane in planes][0], {"A": -25.0, "C": 0.0})
        self.assertEqual(planes[0].other.word, "P1")

    def test_all_errors_are_told_with_their_places(self):
        program = self.write("wrong.nc", "G1 X1 F100\nG1 Qx\nG2 X1\nG1 X1e6\nM30\n")
        told = json.loads(command("check", program, "--machine", MILL, "--json", code=6))
        result = stanok.check(MILL, program)
        self.assertFalse(result.ok)
        self.assertEqual([(fault.code, fault.line, fault.column, fault.message) for fault in result.faults],
                         [(one["code"], one["line"], one["column"], one["message"]) for one in told])
        with self.assertRaises(stanok.ProgramError) as caught:
            stanok.interpret(MILL, program)
        self.assertEqual(caught.exception.line, 2)
        self.assertGreater(len(stanok.interpret(MILL, program, check=False).faults), 0)

    def test_a_program_without_an_end_ends_by_steps_or_ctrl_c(self):
        program = self.write("endless.nc", "num turns = 0;\nwhile (true) { turns = turns + 1; }\n")
        with self.assertRaises(stanok.ProgramError):
            stanok.interpret(MILL, program, million_steps=1)
        self.assertFalse(stanok.check(MILL, program, million_steps=1).ok)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                stanok.check(MILL, program, million_steps=1_000_000)
        finally:
            timer.cancel()
            timer.join()

    def test_wrong_arguments_are_errors(self):
        helix = EXAMPLES / "helix.nc"
        for arguments in (dict(channel=7), dict(scheme=99), dict(scheme=-3), dict(million_steps=0), dict(channel="x"),
                          dict(million_steps=2**70), dict(program_root=7)):
            for function in (stanok.check, stanok.interpret):
                with self.subTest(f"{function.__name__} {arguments}"), self.assertRaises((ValueError, TypeError)):
                    function(MILL, helix, **arguments)
        for function in (stanok.check, stanok.interpret):
            with self.assertRaises(ValueError):
                function(MILL, "")
        self.assertFalse(stanok.check(MILL, "none.nc").ok)


if __name__ == "__main__":
    unittest.main()
