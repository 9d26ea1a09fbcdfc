#!/usr/bin/env python3
"""Grinding in Python against `stanok grind`: the same numbers; and the model against its own equations."""
import json
import os
import signal
import threading
import unittest

import numpy as np
import stanok
from stanok import grinding
from surroundings import EXAMPLES, MACHINES, InFolder
from surroundings import stanok as command

PROCESS = EXAMPLES / "plunge_grinding.toml"
CONTROL = EXAMPLES / "plunge_grinding.txt"


class AgainstTheCommand(InFolder):
    def test_design(self):
        # Chosen places take a second each; given ones are as good for the comparison.
        for options, arguments in (((), {}),
                                   (("--points", 2, "--exact", "--spark-out", 5, "--burn-margin", 0.1),
                                    dict(points=2, exact=True, spark_out_revolutions=5, burn_margin=0.1)),
                                   (("--at", "0.2,0.1,0.02", "--decimals", 5),
                                    dict(at_mm=[0.2, 0.1, 0.02], decimals=5))):
            with self.subTest(str(options)):
                out = self.folder / "control.txt"
                text = command("grind", "design", PROCESS, "--json", "--out", out, *options)
                cycle = grinding.design(PROCESS, **arguments)
                self.assertEqual(cycle.report, json.loads(text))
                self.assertEqual(cycle.control_text.encode(), out.read_bytes())

    def test_a_design_for_a_spread(self):
        text = command("grind", "design", PROCESS, "--json", "--spread", "stiffness=0.1", "--spread", "allowance=0.01")
        cycle = grinding.design(PROCESS, spread={"stiffness": 0.1, "allowance": 0.01})
        self.assertEqual(cycle.report, json.loads(text))

    def test_verification(self):
        text = command("grind", "verify", CONTROL, "--json")
        cycle = grinding.verify(CONTROL)
        self.assertEqual(cycle.report, json.loads(text))
        self.assertEqual(cycle.control_text.encode(), CONTROL.read_bytes())

    def test_study(self):
        text = command("grind", "study", PROCESS, "--vary", "stiffness=2e7:4e7:3", "--vary", "allowance=0.2:0.3:2")
        study = grinding.study(PROCESS, {"stiffness": (2e7, 4e7, 3), "allowance": (0.2, 0.3, 2)})
        self.assertEqual(study.text, text)
        self.assertEqual(study.grid("cycle_time_s").shape, (3, 2))
        self.assertTrue(np.all(np.diff(study.grid("stiffness")[:, 0]) > 0))
        # A stiffer machine takes less time: it is bent less by the same removal.
        self.assertTrue(np.all(np.diff(study.grid("cycle_time_s"), axis=0) < 0))

    def test_parts_of_a_study_are_the_study(self):
        vary = {"stiffness": (2e7, 4e7, 3), "allowance": (0.2, 0.3, 2)}
        words = ["grind", "study", PROCESS, "--set", "stiffness=2e7:4e7:3", "--set", "allowance=0.2:0.3:2"]
        whole = grinding.study(PROCESS, vary)
        # More parts than designs: some are empty.
        for count in (1, 4, 8):
            parts = [grinding.study(PROCESS, vary, part=(k + 1, count)) for k in range(count)]
            for k, part in enumerate(parts):
                self.assertEqual(part.text, command(*words, "--part", f"{k + 1}/{count}"))
                self.assertEqual(list(part), list(whole))
            self.assertEqual("".join(part.text for part in parts), whole.text)
            self.assertEqual(sum(part.rows for part in parts), whole.rows)
            for name in whole:
                column = np.concatenate([part[name] for part in parts])
                self.assertTrue(np.array_equal(column, whole[name], equal_nan=name != "finding"), name)
            joined = grinding.Study.joined(reversed(parts))
            self.assertEqual((joined.text, joined.shape), (whole.text, whole.shape))
            self.assertTrue(np.array_equal(joined.grid("cycle_time_s"), whole.grid("cycle_time_s")))
        with self.assertRaisesRegex(ValueError, "part 1 of 8"):
            parts[0].grid("cycle_time_s")
        for wrong in ([], parts[1:], parts + parts[:1], [grinding.study(PROCESS, {"stiffness": (2e7, 4e7, 2)}, part=(1, 2)),
                                                         grinding.study(PROCESS, {"allowance": (0.2, 0.3, 2)}, part=(2, 2))]):
            with self.assertRaises(ValueError):
                grinding.Study.joined(wrong)

    def test_program(self):
        out = self.folder / "part.nc"
        command("grind", "program", CONTROL, "--out", out, "--machine", MACHINES / "grinder.toml")
        self.assertEqual(grinding.program(CONTROL, machine=MACHINES / "grinder.toml").encode(), out.read_bytes())
        command("grind", "program", CONTROL, "--out", out)
        self.assertEqual(grinding.program(CONTROL).encode(), out.read_bytes())


class AgainstTheModel(InFolder):
    def test_a_law_on_the_model_is_what_verification_simulates(self):
        cycle = grinding.verify(CONTROL)
        run = grinding.plunge(CONTROL, cycle.law)
        self.assertEqual(run.time_s, cycle.time_s)
        self.assertEqual(run.force_max_n, cycle.report["force_max_n"])
        self.assertEqual(run.samples.removal_mm2_per_rad.tobytes(), cycle.samples.removal_mm2_per_rad.tobytes())

    def test_a_slow_steady_feed_removes_its_layer_each_turn(self):
        # Q = a R_eq with a = feed * revolution, R_eq = R R_w / (R + R_w): docs/programmer/grinding.md.
        feed, radius, wheel, revolution_s = 0.01, 30.0, 200.0, 0.5
        run = grinding.plunge(CONTROL, [[0.3, feed], [0.0, feed]])
        expected = feed * revolution_s * radius * wheel / (radius + wheel)
        steady = run.samples.removal_mm2_per_rad[-2000:]
        np.testing.assert_allclose(steady, expected, rtol=1e-3)

    def test_boundary_is_its_formula(self):
        # D(H) = min(Q_max, Q_end + (Q_max - Q_end) H / H_crit), docs/programmer/grinding.md.
        q_max = json.loads(command("grind", "verify", CONTROL, "--json"))["q_max"]
        allowance = np.linspace(0.0, 0.3, 50).reshape(5, 10)
        expected = np.minimum(q_max, 0.05 + (q_max - 0.05) * allowance / 0.09)
        np.testing.assert_allclose(grinding.boundary(CONTROL, allowance), expected, rtol=1e-12)


class Faults(InFolder):
    def test_a_wrong_sheet_is_told_with_line_and_remedy(self):
        wrong = self.write("wrong.toml", PROCESS.read_text(encoding="utf-8").replace("stiffness", "stifness", 1))
        with self.assertRaises(stanok.MachineFileError) as caught:
            grinding.design(wrong)
        self.assertEqual(caught.exception.file, str(wrong))
        self.assertGreater(caught.exception.line, 0)
        control = self.write("wrong.txt", "30.0\nnonsense\n")
        with self.assertRaises(stanok.GrindingError) as caught:
            grinding.verify(control)
        self.assertGreater(caught.exception.line, 0)
        self.assertTrue(caught.exception.code)

    def test_what_is_refused_has_its_code(self):
        with self.assertRaises(stanok.GrindingError) as caught:
            grinding.design(PROCESS, feedback=1.5)
        self.assertEqual(caught.exception.code, "E9107")
        self.assertTrue(caught.exception.remedy)

    def test_wrong_arguments_are_errors_and_nothing_ends_the_interpreter(self):
        for arguments in (dict(points=41), dict(points=3, at_mm=[0.1]), dict(decimals=2), dict(spread={"x": 0.1}),
                          dict(spread={"stiffness": 1.0}), dict(iterations=-1), dict(time_step_s=0.1),
                          dict(burn_margin=float("nan")), dict(at_mm=[0.1, 0.2]), dict(at_mm=["x"])):
            with self.subTest(str(arguments)), self.assertRaises((ValueError, TypeError, stanok.GrindingError)):
                grinding.design(PROCESS, **arguments)
        for law in ([], [[1.0]], [[0.3, 0.1]], [[0.1, 0.1], [0.2, 0.1]], [[0.3, 0.0], [0.0, 0.0]], "law",
                    [[np.nan, 0.1], [0.0, 0.1]], [[0.3, np.inf], [0.0, 0.1]]):
            with self.subTest(str(law)), self.assertRaises((ValueError, TypeError)):
                grinding.plunge(CONTROL, law)
        for vary in ({}, {"nothing": (1, 2, 3)}, {"stiffness": (1, 2)}, {"stiffness": (2e7, 3e7, 10**9)},
                     {"stiffness": (2e7, 3e7, 0)}):
            with self.subTest(str(vary)), self.assertRaises((ValueError, TypeError)):
                grinding.study(PROCESS, vary)
        for part in ((0, 2), (3, 2), (1, 0), (-1, 2), (1, 2**70), (1,), "1/2", 1):
            with self.subTest(str(part)), self.assertRaises((ValueError, TypeError)):
                grinding.study(PROCESS, {"stiffness": (2e7, 3e7, 2)}, part=part)
        for path in ("", "none.txt", self.folder, "none.toml"):
            with self.subTest(str(path)), self.assertRaises((RuntimeError, ValueError, stanok.StanokError)):
                grinding.design(path)

    def test_ctrl_c_ends_a_study(self):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                grinding.study(PROCESS, {"stiffness": (2e7, 4e7, 100_000)})
        finally:
            timer.cancel()
            timer.join()


if __name__ == "__main__":
    unittest.main()
