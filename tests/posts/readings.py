"""Where the tool was: programs through `stanok check` and `stanok simulate`, and the tip read from the machine axes.

Nothing of the posts and nothing of stanok's kinematics is used: the tip in the work offset W is computed here from the
positions of the machine axes, the tool length and the geometry in the machine file.
"""

import csv
import math
import pathlib
import subprocess

# Rounded corners of the path (path_tolerance 0.01 of the machines) and words rounded to 0.001 mm in three axes.
NEAR_MM = 0.012
TURN_DEG = 0.06  # orientation_tolerance 0.05 of the trunnion mill, and rounded vectors


class Mill:
    """Three axes; G54 and tools are those of its tables file."""

    def __init__(self, file, lengths):
        self.file = pathlib.Path(file)
        self.lengths = lengths

    def tip(self, row, length):
        return (float(row["x"]), float(row["y"]), float(row["z"]) - length)

    def direction(self, _row):
        return (0.0, 0.0, 1.0)


class Trunnion(Mill):
    """A rocks the cradle, C turns the plate: p_M = c + Rx(A) (d + Rz(C) p_base), with G54 at Z60 of the base."""

    CENTRE = (0.0, 10.0, -600.0)  # table_centre
    TO_PLATE = (0.0, -35.0, 40.0)  # centre_to_centre
    G54 = (0.0, 0.0, 60.0)

    def tip(self, row, length):
        tip_M = (float(row["x"]), float(row["y"]), float(row["z"]) - length)
        in_cradle = about_x(minus(tip_M, self.CENTRE), -float(row["a"]))
        return minus(about_z(minus(in_cradle, self.TO_PLATE), -float(row["c"])), self.G54)

    def direction(self, row):
        return about_z(about_x((0.0, 0.0, 1.0), -float(row["a"])), -float(row["c"]))


def mill3(root):
    return Mill(root / "config/machines/mill3_probe.toml", {1: 60.0, 2: 75.0})


def trunnion(root):
    return Trunnion(root / "config/machines/trunnion.toml", {1: 110.0, 2: 130.0, 3: 125.0})


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def plus(p, q):
    return tuple(a + b for a, b in zip(p, q))


def about_x(p, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2])


def about_z(p, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2])


def run(*command):
    """Exit code, and both outputs together."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    return result.returncode, result.stdout + result.stderr


class Run:
    """A program that was checked and simulated: the rows of its machine axes, with tip and direction in W."""

    def __init__(self, stanok, mill, text, folder, tool):
        program, trace = pathlib.Path(folder) / "program.nc", pathlib.Path(folder) / "axes.csv"
        program.write_text(text, encoding="utf-8")
        for command in (("check",), ("simulate", "--axis-trace", f"1={trace}")):
            code, output = run(stanok, command[0], "--machine", mill.file, program, *command[1:])
            if code != 0 or "error[" in output:
                raise AssertionError(f"stanok {command[0]}: {output}\n{text}")
        self.text = text
        self.tips, self.directions, self.lines = self._read(trace, mill, mill.lengths[tool])

    def _read(self, trace, mill, length):
        with open(trace, encoding="utf-8") as file:
            file.readline()  # names of the axes
            rows = list(csv.DictReader(file))
        kept = [row for index, row in enumerate(rows) if index == 0 or self._moves(rows[index - 1], row)]
        return ([mill.tip(row, length) for row in kept], [mill.direction(row) for row in kept],
                [int(float(row["line"])) for row in kept])

    @staticmethod
    def _moves(before, row):
        return any(before[axis] != row[axis] for axis in ("x", "y", "z", "a", "c") if axis in row)

    def passes(self, points, near=NEAR_MM):
        """Fails unless the tip passes all points of W in this order. Returns the rows where it did."""
        found, start = [], 0
        for number, point in enumerate(points):
            start = next((row for row in range(start, len(self.tips)) if self._distance(row, point) <= near), None)
            if start is None:
                nearest = min(range(len(self.tips)), key=lambda row: self._distance(row, point))
                raise AssertionError(f"the tip does not pass point {number} {point} in its order; the nearest row is at "
                                     f"{self.tips[nearest]}, line {self.lines[nearest]}\n{self.text}")
            found.append(start)
        return found

    def cuts_only(self, path, below, near=NEAR_MM):
        """Fails where the tip, every 10 ms, is lower than `below` and farther than `near` from the polyline in W."""
        for tip, line in zip(self.tips[::10], self.lines[::10]):
            if tip[2] < below and min(to_segment(tip, a, b) for a, b in zip(path, path[1:])) > near:
                raise AssertionError(f"the tip is at {tip}, off the path, in line {line}\n{self.text}")

    def leans(self, row, direction, within=TURN_DEG):
        """Fails unless the tool points along the vector at a row."""
        cosine = sum(a * b for a, b in zip(self.directions[row], direction)) / math.hypot(*direction)
        angle = math.degrees(math.acos(min(1.0, cosine)))
        if angle > within:
            raise AssertionError(f"the tool leans by {angle:.3f} deg from {direction}, line {self.lines[row]}\n{self.text}")

    def _distance(self, row, point):
        """From a point to the path between the row before and this one."""
        return to_segment(point, self.tips[max(row - 1, 0)], self.tips[row])


def to_segment(p, a, b):
    along = minus(b, a)
    squared = sum(value * value for value in along)
    t = 0.0 if squared == 0 else sum(u * v for u, v in zip(minus(p, a), along)) / squared
    t = min(1.0, max(0.0, t))
    return math.dist(p, tuple(u + t * v for u, v in zip(a, along)))


def arc_points(start, end, centre, clockwise, pieces=96):
    """Points on a helix about Z from start to end, both of W; a full turn where they are one above the other."""
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    last = math.atan2(end[1] - centre[1], end[0] - centre[0])
    sweep = (first - last if clockwise else last - first) % (2 * math.pi) or 2 * math.pi
    radius = math.hypot(start[0] - centre[0], start[1] - centre[1])
    points = []
    for piece in range(1, pieces + 1):
        angle = first + (-sweep if clockwise else sweep) * piece / pieces
        z = start[2] + (end[2] - start[2]) * piece / pieces
        points.append((centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle), z))
    return points
