#!/usr/bin/env python3
"""The judge of benchmarks/motion_against_linuxcnc.py on curves whose figures are known by formula."""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
import linuxcnc_peer  # noqa: E402
import motion_paths  # noqa: E402
from trace_figures import figures  # noqa: E402

CYCLE = 0.001


def row(x=0.0, y=0.0, z=0.0, b=0.0, c=0.0):
    return (x, y, z, b, c)


def between(points, count):
    """Rows along straight legs, count of them a leg."""
    legs = zip(points, points[1:])
    steps = [tuple(a + (b - a) * k / count for a, b in zip(*leg)) for leg in legs for k in range(count)]
    return [*steps, points[-1]]


class Figures(unittest.TestCase):
    def test_time_is_that_between_standing_rows(self):
        path = motion_paths.Path(6000, 3)
        path.line(x=10)
        rows = [row()] * 50 + between([row(), row(10)], 100) + [row(10)] * 70
        self.assertAlmostEqual(figures(rows, path.blocks, CYCLE)["time_s"], 0.1)

    def test_jerk_of_a_staircase_of_jerk_is_its_step(self):
        jerk, place, speed, push = 30000.0, 0.0, 0.0, 0.0
        rows = [row()] * 5
        for sign in [1] * 20 + [-1] * 40 + [1] * 20 + [0] * 5:
            place += speed * CYCLE + push * CYCLE**2 / 2 + sign * jerk * CYCLE**3 / 6
            speed += push * CYCLE + sign * jerk * CYCLE**2 / 2
            push += sign * jerk * CYCLE
            rows.append(row(y=place))
        path = motion_paths.Path(6000, 9)
        path.line(y=place)
        found = figures(rows, path.blocks, CYCLE)
        self.assertAlmostEqual(found["jerk"][1] / jerk, 1.0, places=6)
        # A difference is a mean: it lacks j T / 3 at a corner of the acceleration, j T^2 / 6 at the top of the velocity.
        self.assertAlmostEqual(found["acceleration"][1] / (jerk * CYCLE), 20 - 1 / 3, places=6)
        self.assertAlmostEqual(found["velocity"][1] / (jerk * CYCLE**2), 400 - 1 / 6, places=6)
        self.assertEqual(found["velocity"][0], 0.0)

    def test_cut_corner_is_missed_by_its_distance_from_the_chord(self):
        cut, path = 0.2, motion_paths.Path(6000, 3)
        path.line(x=10)
        path.line(y=10)
        rows = between([row(), row(10 - cut), row(10, cut), row(10, 10)], 200)
        self.assertAlmostEqual(figures(rows, path.blocks, CYCLE)["deviation_mm"], cut / math.sqrt(2), places=4)

    def test_cusp_that_is_not_reached_counts_although_all_rows_are_on_the_path(self):
        path = motion_paths.Path(6000, 3)
        path.line(x=10)
        path.line(x=0.5)
        rows = between([row(), row(9.9), row(0.5)], 300)
        self.assertAlmostEqual(figures(rows, path.blocks, CYCLE)["deviation_mm"], 0.1, places=4)

    def test_row_of_the_path_beside_hides_nothing(self):
        path = motion_paths.Path(6000, 3)
        for target in ({"x": 30}, {"y": 0.3}, {"x": 0}):
            path.line(**target)
        rows = between([row(), row(10), row(12, 0.25), row(14), row(30), row(30, 0.3), row(0, 0.3)], 300)
        self.assertAlmostEqual(figures(rows, path.blocks, CYCLE)["deviation_mm"], 0.25, places=3)

    def test_arc_is_followed_by_its_own_points(self):
        path = motion_paths.Path(6000, 6)
        path.arc(1, (0, 5), x=0, y=10)
        path.arc(-1, (0, 15), x=5, y=15)
        first = [row(5 * math.sin(t), 5 - 5 * math.cos(t)) for t in (math.pi * k / 400 for k in range(400))]
        second = [row(-5 * math.sin(t), 15 - 5 * math.cos(t)) for t in (1.5 * math.pi * k / 600 for k in range(601))]
        found = figures(first + second, path.blocks, CYCLE)
        self.assertLess(found["deviation_mm"], 1e-5)
        self.assertAlmostEqual(path.feed_time, 5 * 2.5 * math.pi / 100)

    def test_rotary_axis_is_compared_where_the_tip_is(self):
        path = motion_paths.Path(6000, 3)
        path.line(x=10, b=20)
        path.line(x=20, b=20)
        rows = [row(x=0.05 * k, b=min(20, 0.1 * k + 0.4 * math.sin(math.pi * min(k, 200) / 200))) for k in range(401)]
        self.assertAlmostEqual(figures(rows, path.blocks, CYCLE)["rotary_deviation_deg"], 0.4, places=3)


class Paths(unittest.TestCase):
    def test_all_begin_at_zero_join_and_fit_into_the_queue_of_the_peer(self):
        for name, make in motion_paths.CASES.items():
            path, place = make(), (0.0,) * 5
            self.assertLessEqual(len(path.blocks), linuxcnc_peer.MOST_BLOCKS, name)
            for block in path.blocks:
                self.assertEqual(block.start, place, name)
                self.assertGreater(block.length, 0, name)
                place = block.end
                if isinstance(block, motion_paths.Arc):
                    self.assertAlmostEqual(math.dist(block.end[:2], block.center), block.radius, places=5, msg=name)

    def test_text_has_the_numbers_of_the_geometry(self):
        path = motion_paths.Path(1000, 3)
        path.line(x=1.23456)
        self.assertEqual(path.program(0.01), "G21 G90 G17 G94\nG64 P0.01\nF1000\nG1 X1.235\nM2\n")
        self.assertEqual(path.at[0], 1.235)

    def test_raster_has_its_length(self):
        self.assertAlmostEqual(motion_paths.raster().feed_time, (20 * 60 + 20 * 0.5) / 100)


if __name__ == "__main__":
    unittest.main()
