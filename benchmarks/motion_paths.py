"""Paths that are hard to run well, made from formulas: what motion_against_linuxcnc.py runs.

A path begins at zero and is a list of blocks, straight or an arc about an axis parallel to Z. Its
coordinates are rounded to the decimals of the program before anything else, so that the text and the
geometry are the same numbers. Lengths in mm, angles in degrees, feeds in mm/min.
"""

import math

AXES = "XYZBC"


class Line:
    """A straight block; the rotary axes move in proportion to its length."""

    def __init__(self, start, end):
        self.start, self.end = start, end
        self.length = math.dist(start[:3], end[:3])

    def nearest(self, point):
        """Distance of a point of the tip and the share of the block that is passed there."""
        leg = [e - s for s, e in zip(self.start[:3], self.end[:3])]
        along = sum(l * (p - s) for l, p, s in zip(leg, point, self.start))
        share = min(1.0, max(0.0, along / self.length**2)) if self.length else 0.0
        foot = [s + share * l for s, l in zip(self.start, leg)]
        return math.dist(foot, point[:3]), share


class Arc:
    """An arc in a plane of X and Y."""

    def __init__(self, start, end, center, sense):
        self.start, self.end, self.center, self.sense = start, end, center, sense
        self.radius = math.dist(start[:2], center)
        swept = sense * (self.angle(end) - self.angle(start))
        self.sweep = swept % (2 * math.pi) or 2 * math.pi
        self.length = self.radius * self.sweep

    def angle(self, point):
        return math.atan2(point[1] - self.center[1], point[0] - self.center[0])

    def nearest(self, point):
        """Distance of a point of the tip and the share of the block that is passed there."""
        passed = self.sense * (self.angle(point) - self.angle(self.start)) % (2 * math.pi)
        height = point[2] - self.start[2]
        if passed <= self.sweep:
            return math.hypot(math.dist(point[:2], self.center) - self.radius, height), passed / self.sweep
        ends = (math.dist(point[:3], self.start[:3]), 0.0), (math.dist(point[:3], self.end[:3]), 1.0)
        return min(ends)


class Path:
    """Blocks and their program."""

    def __init__(self, feed, decimals):
        self.decimals, self.blocks, self.words, self.feed_time = decimals, [], [], 0.0
        self.at = (0.0,) * len(AXES)
        self.set_feed(feed)

    def set_feed(self, feed):
        self.feed = feed
        self.words.append(f"F{feed}")

    def line(self, **target):
        """A straight block to the axes named, in small letters; none where they stand already."""
        end = self.rounded(target)
        if end == self.at:
            return
        self.words.append("G1 " + self.text(target))
        self.append(Line(self.at, end))

    def arc(self, sense, center, **target):
        """An arc about a centre, counterclockwise with a sense of 1, clockwise with -1."""
        end = self.rounded(target)
        i, j = (round(c - a, self.decimals) for c, a in zip(center, self.at))
        code = "G3" if sense > 0 else "G2"
        self.words.append(f"{code} {self.text(target)} I{i:.{self.decimals}f} J{j:.{self.decimals}f}")
        self.append(Arc(self.at, end, (self.at[0] + i, self.at[1] + j), sense))

    def append(self, block):
        self.blocks.append(block)
        self.at = block.end
        self.feed_time += block.length / (self.feed / 60)

    def rounded(self, target):
        return tuple(round(target.get(name.lower(), a), self.decimals) for name, a in zip(AXES, self.at))

    def text(self, target):
        return " ".join(f"{name.upper()}{value:.{self.decimals}f}" for name, value in target.items())

    def program(self, tolerance):
        return "\n".join(["G21 G90 G17 G94", f"G64 P{tolerance}", *self.words, "M2", ""])


def square_pocket():
    path = Path(6000, 3)
    for half in range(3, 31, 3):
        path.line(x=half)
        for x, y in ((half, half), (-half, half), (-half, -half), (half, -half), (half, 0)):
            path.line(x=x, y=y)
    return path


def rounded_pocket(radius=3):
    path = Path(6000, 3)
    for half in range(6, 31, 3):
        inner = half - radius
        path.line(x=half)
        path.line(y=inner)
        path.arc(1, (inner, inner), x=inner, y=half)
        path.line(x=-inner)
        path.arc(1, (-inner, inner), x=-half, y=inner)
        path.line(y=-inner)
        path.arc(1, (-inner, -inner), x=-inner, y=-half)
        path.line(x=inner)
        path.arc(1, (inner, -inner), x=half, y=-inner)
        path.line(y=0)
    return path


def rows(path, count, length, step, place):
    """Rows there and back of short blocks; place gives the axes at x in a row."""
    steps = round(length / step)
    for row in range(count):
        ways = range(steps + 1) if row % 2 == 0 else range(steps, -1, -1)
        for k in ways:
            path.line(**place(k * step, row))
    return path


def finishing_rows():
    def place(x, row):
        return {"x": x, "y": 0.4 * row, "z": 2 * math.sin(x / 5) + 0.8 * math.sin(x / 2.1 + 0.3 * row)}

    return rows(Path(5000, 3), 8, 40, 0.2, place)


def tangent_arcs_and_lines():
    path, heading, (x, y) = Path(6000, 6), 0.0, (0.0, 0.0)
    for k in range(40):
        length, radius, sense = (6, 4)[k % 2], (3, 5, 2)[k % 3], (1, -1)[k % 2]
        x, y = x + length * math.cos(heading), y + length * math.sin(heading)
        path.line(x=x, y=y)
        center = (x - sense * radius * math.sin(heading), y + sense * radius * math.cos(heading))
        heading += sense * math.radians(120)
        x = center[0] + sense * radius * math.sin(heading)
        y = center[1] - sense * radius * math.cos(heading)
        path.arc(sense, center, x=x, y=y)
    return path


def adaptive_clearing(radius=10, advance=0.8):
    path = Path(4000, 6)
    reach = radius * math.cos(math.radians(60)), radius * math.sin(math.radians(60))
    for k in range(30):
        center = advance * k
        path.set_feed(12000)
        path.line(x=center + reach[0], y=-reach[1])
        path.set_feed(4000)
        path.arc(1, (center, 0), x=center + reach[0], y=reach[1])
    return path


def trochoid(radius=3, advance=0.6):
    path = Path(6000, 3)
    for k in range(40):
        start = advance * k
        path.arc(1, (start - radius, 0), x=start - 2 * radius, y=0)
        path.arc(1, (start - radius + advance / 2, 0), x=start + advance, y=0)
    return path


def slots(length=30):
    path = Path(8000, 3)
    for number in range(5):
        middle = 12 * number
        for radius in (2, 3, 4):
            path.line(x=0, y=middle - radius)
            path.line(x=length)
            path.arc(1, (length, middle), x=length, y=middle + radius)
            path.line(x=0)
            path.arc(1, (0, middle), x=0, y=middle - radius)
    return path


def spiral(pitch=1.0, radius=10, step=0.25):
    path, angle = Path(6000, 3), 0.0
    while pitch * angle / (2 * math.pi) < radius:
        angle += step / math.hypot(pitch * angle / (2 * math.pi), pitch / (2 * math.pi))
        reach = pitch * angle / (2 * math.pi)
        path.line(x=reach * math.cos(angle), y=reach * math.sin(angle))
    return path


def raster(length=60, advance=0.5):
    path = Path(6000, 3)
    for row in range(20):
        path.line(x=length if row % 2 == 0 else 0)
        path.line(y=advance * (row + 1))
    return path


def coarse_chords():
    path = Path(4000, 3)
    for k in range(1, 101):
        path.line(x=15 * math.cos(k / 4) - 15, y=15 * math.sin(k / 4), z=0.3 * k)
    return path


def five_axis_coarse_legs():
    path = Path(4000, 3)
    for k in range(1, 101):
        path.line(x=15 * math.cos(k / 4) - 15, y=15 * math.sin(k / 4), z=0.3 * k, b=12 * math.sin(0.3 * k), c=4 * k)
    return path


def five_axis_swarf_rows():
    def place(x, row):
        return {"x": x, "y": row, "z": 2 * math.sin(x / 8), "b": 15 * math.sin(x / 12),
                "c": 25 * math.cos(x / 15) - 25}

    return rows(Path(3000, 4), 8, 30, 0.5, place)


def curve(feed, length, step, place):
    """A smooth curve by its parameter as short blocks, moved to begin at zero."""
    path, first = Path(feed, 5), place(0.0)
    for k in range(1, round(length / step) + 1):
        path.line(**{name: value - first[name] for name, value in place(k * step).items()})
    return path


def wave(u):
    return 4 * math.sin(u / 9 + 0.4) + 1.5 * math.sin(u / 3.7 + 0.8) + 0.5 * math.sin(u / 1.9)


def five_axis_wave(u):
    return {"x": u, "z": wave(u), "b": 12 * math.sin(u / 11 + 0.4) + 2 * math.sin(u / 5),
            "c": 20 * math.cos(u / 13 + 0.4) + 2 * math.sin(u / 6)}


def loops(u):
    return {"x": u + 3 * math.sin(5 * u + 0.4), "y": 3 - 3 * math.cos(5 * u + 0.4)}


def square():
    path = Path(5000, 3)
    for x, y in ((20, 0), (20, 20), (0, 20), (0, 0)) * 3:
        path.line(x=x, y=y)
    return path


def circles():
    path = Path(5000, 3)
    for _ in range(8):
        path.arc(-1, (10, 0), x=0, y=0)
    return path


def chords():
    count = round(2 * math.pi * 10 / 0.1)
    return curve(5000, 2 * count, 1, lambda k: {"x": -10 * math.cos(2 * math.pi * k / count),
                                                "y": 10 * math.sin(2 * math.pi * k / count)})


def staircase(step=0.002):
    path = Path(1500, 3)
    for k in range(900):
        path.line(x=step * (k + 1))
        path.line(y=step * (k + 1))
    return path


CASES = {
    "20 mm square, three rounds": square,
    "circles R10, eight rounds": circles,
    "R10 as chords of 0.1 mm, two rounds": chords,
    "stairs of 2 um": staircase,
    "sine": lambda: curve(10000, 100, 0.25, lambda u: {"x": u, "z": 3 * math.sin(u / 4 + 0.4)}),
    "sine in Y": lambda: curve(8000, 100, 0.1, lambda u: {"y": u, "z": 2 * math.sin(u / 3 + 0.4)}),
    "three waves": lambda: curve(12000, 100, 0.2, lambda u: {"x": u, "z": wave(u)}),
    "five-axis waves": lambda: curve(5000, 100, 0.2, five_axis_wave),
    "loops of chords": lambda: curve(6000, 15, 0.008, loops),
    "square pocket": square_pocket,
    "rounded pocket": rounded_pocket,
    "finishing rows, 3 decimals": finishing_rows,
    "tangent arcs and lines": tangent_arcs_and_lines,
    "adaptive clearing": adaptive_clearing,
    "trochoid of half arcs": trochoid,
    "slots": slots,
    "spiral of chords": spiral,
    "raster": raster,
    "coarse chords": coarse_chords,
    "five-axis coarse legs": five_axis_coarse_legs,
    "five-axis swarf rows": five_axis_swarf_rows,
}
