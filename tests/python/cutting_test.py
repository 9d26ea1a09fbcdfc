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
HARD_CUT = ("G21 G90 G18 G7 G40 G54\nT0101\nG97 S300 M3\nG4 F1.5\nS600\nG4 F1.5\nG95\nG0 X60 Z2\nG1 Z-15 F0.2\n"
            "Z-30 F0.4\nZ-50 F0.2\nZ-65 F0.4\nZ-75 F0.2\nZ-85 F0.4\nG0 X72\nZ5 M5\nM30\n")
HARD_STOCK = [(0.0, 32.0, 200.0), (-20.0, 33.0, 200.0), (-40.0, 32.0, 200.0), (-60.0, 32.0, 260.0),
              (-80.0, 32.0, 170.0)]  # as lathe.toml has it, HB


class Turning(InFolder):
    def test_figures_are_those_of_the_command_and_of_the_cut(self):
        log = self.folder / "cut.lcm"
        stanok.simulate(LATHE, self.write("cut.nc", CUT), drives="simulated", log=log)
        text = command("process", "identify", log, "--stock", "0:32,-20:33,-40:32", "--coefficient", 1600, "--json")
        cut = cutting.identify_turning(log, STOCK, coefficient_n=1600.0)
        self.assertEqual(cut.report, json.loads(text))
        self.assertEqual(cut.report["fit"], {"ok": True, "kind": "none", "reason": "", "remedy": ""})
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

    def test_steps_of_hardness_are_a_misfit_unless_the_stock_has_them(self):
        log = self.folder / "cut.lcm"
        stanok.simulate(LATHE, self.write("cut.nc", HARD_CUT), drives="simulated", log=log)
        plain = cutting.identify_turning(log, [(z, radius) for z, radius, _ in HARD_STOCK])
        self.assertEqual((plain.report["fit"]["ok"], plain.report["fit"]["kind"]), (False, "steps"))
        self.assertIn("the model does not fit because the force from Z", plain.report["fit"]["reason"])
        out = self.folder / "out.toml"
        told = command("process", "identify", log, "--stock", "0:32,-20:33,-40:32", "--out", out, code=1)
        self.assertIn("steps of hardness", told)
        self.assertNotIn("exponent y", told)
        self.assertFalse(out.exists())
        cut = cutting.identify_turning(log, HARD_STOCK)
        self.assertEqual(cut.report["fit"]["kind"], "none")
        self.assertAlmostEqual(cut.estimate("coefficient_over_efficiency_n").value / (1600.0 / 0.85), 1.0, delta=0.01)
        self.assertAlmostEqual(cut.estimate("exponent").value, 0.75, delta=0.01)
        # HB_0 of lathe.toml is that of its first section.
        of_machine = json.loads(command("process", "identify", log, "--stock", LATHE, "--json"))
        self.assertEqual(of_machine, cut.report)


# Tool 3: end mill of 6 mm with three teeth. Slots with two feeds, then 3 mm of width, at two speeds; the walls of the
# blank stand in X at 0 and 60.
SLOTS = ("G21 G90 G17 G40 G49 G80 G54 G94 G64\n#workpiece (0, 0.15, 0, 60, 40, 10, 0, 0, 10)\nT3 M6\nS6000 M3\n"
         "G0 X-6 Y10\nG43 H3 Z50\nG0 Z-2\nG1 X66 F600\nG0 Z2\nG0 X-6 Y13\nG0 Z-2\nG1 X66 F1500\nG0 Z2\n"
         "G0 X-6 Y22\nS4000 M3\nG4 P1\nG0 Z-2\nG1 X66 F400\nG0 Z2\nG0 X-6 Y25\nG0 Z-2\nG1 X66 F1200\nG0 Z50\n"
         "G49 M5\nM30\n")
QUARTERS = {8: 2, 12: 1, 18: 2, 22: 1}  # of the tool that meet the material, by line
SLOWER_FROM = 15


class Milling(InFolder):
    FORCE, EDGE, LAG_S = 1150.0, 14.0, 0.03  # N/mm2, N/mm

    def power(self, run):
        """W of each cycle, by formulas: volume and rubbing edges of quarters of the tool between two walls."""
        line, x = run["line"], run["tip_position"][:, 0]
        n = np.where(line < SLOWER_FROM, 6000.0, 4000.0)
        feed = np.abs(np.diff(x, prepend=x[0])) / 1e-3
        radius, length, depth = 3.0, 60.0, 2.0
        to = np.where(x < 0.0, np.arccos(np.clip(-x / radius, 0.0, 1.0)), np.pi / 2)
        begin = np.arccos(np.clip((length - x) / radius, 0.0, 1.0))
        quarters = sum(count * (line == number) for number, count in QUARTERS.items())
        quarters = np.where((x > -radius) & (x < length), quarters, 0)
        volume = quarters * radius * (np.sin(to) - np.sin(begin)) * depth * feed
        rubbing = 3 * depth * quarters * (to - begin) * radius * n / 60.0
        wanted = 1e-3 * (self.FORCE * volume + self.EDGE * rubbing)
        shown, follows = np.zeros(len(wanted)), 1.0 - np.exp(-1e-3 / self.LAG_S)
        for k in range(1, len(wanted)):
            shown[k] = shown[k - 1] + (wanted[k] - shown[k - 1]) * follows
        return n * (0.05 + 4e-6 * n) + shown

    def test_figures_are_those_of_the_command_and_of_the_cut(self):
        mill, cut_file, log = MACHINES / "e7106mf4.toml", EXAMPLES / "slot_lobes.toml", self.folder / "slots.lcm"
        program = self.write("slots.nc", SLOTS)
        run = stanok.simulate(mill, program, columns=("time_s", "line", "tip_position"))[1]
        power = self.power(run)
        rows = "".join(f"{run['time_s'][k]:.3f},{power[k]:.1f}\n" for k in range(0, len(power), 10))
        stanok.simulate(mill, program, sensors=self.write("power.csv", "t,power_w\n" + rows), log=log)
        text = command("process", "identify", log, "--cut", cut_file, "--efficiency", 0.8, "--out", self.folder / "out.toml",
                       "--json")
        cut = cutting.identify_milling(log, cut_file, efficiency=0.8)
        self.assertEqual(cut.report, json.loads(text))
        self.assertEqual(cut.cut_text, (self.folder / "out.toml").read_text(encoding="utf-8"))
        # The virtual workpiece knows the cut to about a hundredth.
        self.assertAlmostEqual(cut.estimate("force_n_per_mm2").value / (0.8 * self.FORCE), 1.0, delta=0.05)
        self.assertAlmostEqual(cut.estimate("edge_force_n_per_mm").value / (0.8 * self.EDGE), 1.0, delta=0.1)
        # A slot of 6 x 2 mm at 10 mm/s.
        self.assertAlmostEqual(float(np.median(cut.removal_mm3_per_s[run["line"][:len(cut.time_s)] == 8])), 120.0, delta=3.0)
        self.assertEqual({len(getattr(cut, name)) for name in ("time_s", "rev_per_min", "rubbing_mm2_per_s", "power_w",
                                                               "fitted_w")}, {len(cut.removal_mm3_per_s)})
        # No other tool cuts.
        with self.assertRaises(RuntimeError):
            cutting.identify_milling(log, cut_file, tool=4)


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
        for arguments in (dict(efficiency=0.0), dict(efficiency=float("nan")), dict(tool=0), dict(tool=-1)):
            with self.assertRaises(ValueError):
                cutting.identify_milling("none.lcm", EXAMPLES / "slot_lobes.toml", **arguments)
        with self.assertRaises(ValueError):
            cutting.identify_milling("none.lcm", EXAMPLES / "grinding_lobes.toml")
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
