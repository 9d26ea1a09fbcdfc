#!/usr/bin/env python3
"""Kinematics in Python: against the axes of simulations, against matrices written here, and itself."""
import unittest

import numpy as np
import stanok
from surroundings import EXAMPLES, MACHINES, InFolder, columns_of_csv, same_bits
from surroundings import stanok as command

TRUNNION = MACHINES / "trunnion.toml"
RANDOM = np.random.default_rng(20260728)


def turn(axis, angle_deg):
    """The matrix that turns about a main axis, counter-clockwise."""
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    i, j = [k for k in range(3) if k != axis]
    matrix = np.eye(3)
    sign = -1.0 if axis == 1 else 1.0
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -sign * s, sign * s, c
    return matrix


class AgainstSimulations(InFolder):
    """The cycle has the axes from the same functions: equal to the bit, through the command line as well."""

    PROGRAM = ("T1 M6\nG54 G43.4 H1\nG0 X0 Y0 Z60 A0 C0\nG1 X10 Y5 Z40 A20 C35 F1200\nX-10 Y15 Z45 A-15 C80\n"
               "G2 X-20 Y25 I-5 J5\nG1 X0 Y0 Z60 A0 C0\nM30\n")

    def test_axes_are_the_inverse_of_the_points_bit_for_bit(self):
        program = self.write("part.nc", self.PROGRAM)
        tip, axes = self.folder / "tip.csv", self.folder / "axes.csv"
        command("simulate", program, "--machine", TRUNNION, "--tip-trace", f"1={tip}", "--axis-trace", f"1={axes}")
        points, readings = columns_of_csv_rows(tip), columns_of_csv_rows(axes)
        result = stanok.simulate(TRUNNION, program, columns="all")
        setpoints = result[1]
        length, offset = self.tool_and_offset(program)
        kinematics = stanok.Kinematics(TRUNNION, mode="tip", nose_to_tip=(0.0, 0.0, -length), offset=offset)
        # Where the tip is led: from the block behind G43.4 on, until the program ends.
        led = (setpoints.line >= 4) & (setpoints.line <= 7)
        self.assertGreater(int(led.sum()), 1000)
        self.assertTrue(same_bits(kinematics.inverse(setpoints.tip_position[led]), setpoints.position[led]))
        jets = kinematics.jets(setpoints.tip_position[led], setpoints.tip_velocity[led])
        np.testing.assert_allclose(jets.velocity, setpoints.velocity[led], rtol=1e-12, atol=1e-12)
        # What the command line traces, as texts of 17 digits: the same again.
        by_time = {row["t"]: row for row in readings}
        compared = 0
        for row in points:
            if not 4 <= int(row["line"]) <= 7:
                continue
            point = np.array([float(row[word]) for word in "xyzac"])
            expected = np.array([float(by_time[row["t"]][word]) for word in "xyzac"])
            if compared % 50 == 0:
                self.assertTrue(same_bits(kinematics.inverse(point), expected))
            compared += 1
        self.assertGreater(compared, 1000)

    def tool_and_offset(self, program):
        records = stanok.interpret(TRUNNION, program).records
        lengths = [record["offset"][2] for record in records if record.get("what") == "tool_length"]
        offsets = [record["offset"] for record in records if record.get("what") == "frame"]
        self.assertGreater(lengths[-1], 1.0)
        self.assertGreater(offsets[-1]["Z"], 1.0)
        return lengths[-1], offsets[-1]


def columns_of_csv_rows(path):
    """Rows of a trace by their heading; lines of remarks are left out."""
    text = path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    columns = columns_of_csv(path)
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


class AgainstMatrices(unittest.TestCase):
    def test_a_turned_and_shifted_workpiece(self):
        mill = MACHINES / "mill3.toml"
        kinematics = stanok.Kinematics(mill, offset={"X": 10.0, "Y": -4.0, "Z": 2.5},
                                       turns=[((1, 0, 0), 30.0), ((0, 0, 2), 45.0)])
        points = RANDOM.uniform(-50, 50, (200, 3))
        matrix = turn(2, 45.0) @ turn(0, 30.0)
        expected = points @ matrix.T + [10.0, -4.0, 2.5]
        np.testing.assert_allclose(kinematics.inverse(points), expected, rtol=0, atol=1e-12)

    def test_derivatives_against_differences(self):
        for machine in ("trunnion", "mill5", "e7106mf4"):
            read = stanok.load_machine(MACHINES / f"{machine}.toml")
            for channel in read.channels.values():
                for scheme in channel.schemes:
                    with self.subTest(f"{machine} {channel.id} {scheme.id}"):
                        self.expect_derivatives(stanok.Kinematics(read, channel.id, scheme.id, mode="tip",
                                                                  nose_to_tip=(1.0, 2.0, -80.0)))

    def expect_derivatives(self, kinematics):
        width = len(kinematics.axes)
        points = RANDOM.uniform(5, 40, (50, width))
        jacobian = kinematics.jacobian(points)
        self.assertEqual(jacobian.shape, (50, width, width))
        step = 1e-5
        for p in range(width):
            shift = np.zeros(width)
            shift[p] = step
            difference = (kinematics.inverse(points + shift) - kinematics.inverse(points - shift)) / (2 * step)
            # Differences of second order: the third derivative times step²/6, and digits lost in 2 step.
            np.testing.assert_allclose(jacobian[:, :, p], difference, rtol=1e-6, atol=1e-6)
        velocity = RANDOM.uniform(-9, 9, points.shape)
        jets = kinematics.jets(points, velocity)
        self.assertTrue(same_bits(jets.position, kinematics.inverse(points)))
        np.testing.assert_allclose(jets.velocity, np.einsum("nap,np->na", jacobian, velocity), rtol=1e-9, atol=1e-9)
        before, after = (kinematics.inverse(points + sign * 1e-4 * velocity) for sign in (-1, 1))
        second = (after - 2 * jets.position + before) / 1e-8
        np.testing.assert_allclose(jets.acceleration, second, rtol=1e-3, atol=1e-3)

    def test_axes_that_take_part(self):
        # mill5 and its like: all of them; three axes of e7106mf4: X Y Z, the rotary axes are parked.
        self.assertEqual(stanok.Kinematics(TRUNNION).taking_part, (True,) * 5)
        three = stanok.Kinematics(MACHINES / "e7106mf4.toml", scheme=1)
        self.assertEqual(dict(zip(three.words, three.taking_part)),
                         {word: word in "XYZ" for word in three.words})

    def test_forward_of_inverse_is_the_point(self):
        for mode in ("axes", "tip"):
            kinematics = stanok.Kinematics(TRUNNION, mode=mode, nose_to_tip=(0, 0, -60), offset={"X": 3.0, "C": 10.0})
            points = RANDOM.uniform(-80, 80, (500, 5))
            np.testing.assert_allclose(kinematics.forward(kinematics.inverse(points)), points, rtol=0, atol=1e-10)


class Faults(unittest.TestCase):
    def test_wrong_arguments_are_errors_and_nothing_ends_the_interpreter(self):
        for arguments in (dict(channel=9), dict(scheme=77), dict(mode="some"), dict(nose_to_tip=(1, 2)),
                          dict(offset={"Q": 1.0}), dict(turns=[((0, 0, 0), 10.0)]), dict(turns=[((1, 0), 10.0)]),
                          dict(turns=[3]), dict(offset=5), dict(channel="a")):
            with self.subTest(str(arguments)), self.assertRaises((ValueError, TypeError, AttributeError)):
                stanok.Kinematics(TRUNNION, **arguments)
        kinematics = stanok.Kinematics(TRUNNION)
        for values in (1.0, [1.0, 2.0], np.zeros((2, 4)), np.zeros((2, 2, 5)), "text", [["a"] * 5], [[1, 2], [3]]):
            with self.subTest(str(values)), self.assertRaises((ValueError, TypeError)):
                kinematics.inverse(values)
        with self.assertRaises(ValueError):
            kinematics.jets(np.zeros((2, 5)), np.zeros((3, 5)))
        self.assertEqual(kinematics.inverse(np.zeros((0, 5))).shape, (0, 5))
        self.assertEqual(kinematics.inverse(np.zeros(5)).shape, (5,))
        self.assertTrue(np.isnan(kinematics.inverse(np.full(5, np.nan))).any())


if __name__ == "__main__":
    unittest.main()
