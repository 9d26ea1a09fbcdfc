#!/usr/bin/env python3
"""Figures of a cut from its log: equal to `stanok process identify`, and those of the simulated cut."""
import json
import unittest

import numpy as np
import stanok
from stanok import cutting
from surroundings import EXAMPLES, MACHINES, InFolder
from surroundings import stanok as command

LATHE = MACHINES / "lathe.toml"
CUT = ("G21 G90 G18 G7 G40 G54\nT0101\nG97 S300 M3\nG4 F1.5\nS600\nG4 F1.5\nG95\nG0 X60 Z2\nG1 Z-10 F0.1\nZ-20 F0.3\n"
       "Z-30 F0.15\nZ-40 F0.4\nG0 X72\nZ5 M5\nM30\n")
STOCK = [(0.0, 32.0), (-20.0, 33.0), (-40.0, 32.0)]  # as lathe.toml has it


class Turning(InFolder):
    def test_figures_are_those_of_the_command_and_of_the_cut(self):
        log = self.folder / "cut.lcm"
        stanok.simulate(LATHE, self.write("cut.nc", CUT), drives="simulated", log=log)
        text = command("process", "identify", log, "--stock", "0:32,-20:33,-40:32", "--coefficient", 1600, "--json")
        cut = cutting.identify_turning(log, STOCK, coefficient_n=1600.0)
        self.assertEqual(cut.report, json.loads(text))
        # [simulation.cutting] of lathe.toml: C = 1600 N, efficiency 0.85; y = 0.75 where it says nothing.
        self.assertAlmostEqual(cut.estimate("coefficient_over_efficiency_n").value / (1600.0 / 0.85), 1.0, delta=0.01)
        self.assertAlmostEqual(cut.estimate("exponent").value, 0.75, delta=0.01)
        self.assertAlmostEqual(cut.estimate("efficiency").value, 0.85, delta=0.01)
        # Depths are those of the stock at a turned radius of 30 mm.
        depths = cut.depth_mm[(cut.travel_mm > 0.0) & (cut.depth_mm > 0.0)]
        self.assertGreater(len(depths), 10_000)
        self.assertLess(float(np.minimum(np.abs(depths - 2.0), np.abs(depths - 3.0)).max()), 0.01)
        read = np.isfinite(cut.power_w)
        self.assertEqual(int(read.sum()), cut.report["readings"])
        residual = cut.power_w[read] - cut.fitted_w[read]
        self.assertLess(float(np.abs(np.median(residual))), 1.0)


class Grinding(InFolder):
    def test_what_a_log_lacks_is_told_as_by_the_command(self):
        log = self.folder / "cycle.lcm"
        stanok.simulate(MACHINES / "mill3.toml", EXAMPLES / "helix.nc", log=log)
        with self.assertRaises(RuntimeError) as caught:
            cutting.identify_grinding(log, EXAMPLES / "plunge_grinding.toml")
        self.assertTrue(str(caught.exception))
        with self.assertRaises(RuntimeError):
            cutting.identify_turning(log, STOCK)


class Chatter(InFolder):
    def test_lobes_are_those_of_the_command(self):
        for name, speeds in (("slot_lobes.toml", (2000, 20000)), ("grinding_lobes.toml", (50, 400))):
            for method in ("zeroth-order", "semi-discretisation")[:2 if name == "slot_lobes.toml" else 1]:
                with self.subTest(f"{name} {method}"):
                    text = command("process", "lobes", EXAMPLES / name, "--speeds", "{}:{}".format(*speeds), "--count",
                                   12, "--method", method, "--json")
                    found = cutting.lobes(EXAMPLES / name, speeds, count=12, method=method)
                    self.assertEqual(found.report, json.loads(text))
                    self.assertEqual(found.depth_mm.shape, (12,))

    def test_a_deep_cut_chatters_and_a_shallow_one_does_not(self):
        found = cutting.lobes(EXAMPLES / "slot_lobes.toml", (2000, 20000))
        always = float(found.depth_mm.min())
        judged = cutting.lobes(EXAMPLES / "slot_lobes.toml", (2000, 20000), cuts=[(9000, 0.9 * always), (9000, 1e3)])
        self.assertEqual([cut["stable"] for cut in judged.report["cuts"]], [True, False])


class Faults(InFolder):
    def test_wrong_arguments_are_errors(self):
        for stock in ([], [(0.0, -1.0)], [(0.0, 1.0), (0.0, 1.0)], [(0.0,)], "stock", None):
            with self.subTest(str(stock)), self.assertRaises((ValueError, TypeError)):
                cutting.identify_turning(self.folder / "none.lcm", stock)
        for arguments in (dict(force_ratio=0.0), dict(efficiency=2.0), dict(wheel_speed_m_per_s=float("nan"))):
            with self.assertRaises(ValueError):
                cutting.identify_grinding("none.lcm", "none.toml", **arguments)
        slot = EXAMPLES / "slot_lobes.toml"
        for arguments in (dict(speeds=(5, 1)), dict(speeds=(0, 1)), dict(speeds=(1, 2, 3)), dict(count=1),
                          dict(method="none"), dict(cuts=[(1.0, -1.0)]), dict(cuts=[1.0]), dict(count=10**9)):
            with self.subTest(str(arguments)), self.assertRaises((ValueError, TypeError)):
                cutting.lobes(slot, **arguments)
        with self.assertRaises(stanok.MachineFileError):
            cutting.lobes(self.write("wrong.toml", "kind = 5\n"))
        for channel, spindle in ((99, 1), (-1, 1), (1, 99), (1, 0), (1, -2**31)):
            log = self.folder / "cut.lcm"
            if not log.exists():
                stanok.simulate(LATHE, self.write("part.nc", "G0 X60 Z2\nM30\n"), log=log)
            with self.subTest(f"{channel} {spindle}"), self.assertRaises((RuntimeError, ValueError, TypeError)):
                cutting.identify_turning(log, STOCK, channel=channel, spindle=spindle)


if __name__ == "__main__":
    unittest.main()
