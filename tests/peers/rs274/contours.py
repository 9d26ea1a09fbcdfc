"""Judges radius compensation by geometry: the tool's centre against the programmed contour.

The contour is what rs274 says of the program without its G41, G42 and G40. From the move after the
lead-in to the one before the lead-out each path must keep the tool's radius as its distance from
the contour, on the side that was asked for. Behind the first contour element, on which the two may
begin at different places, both must be the same path.
"""

import math
import re

import paths
from events import PLANES

CODES = re.compile(r"G4[12]\.1\s*D\S+(\s*L\S+)?|G4[12]\s*(D\S+)?|G40", re.IGNORECASE)
SAME = 1e-6  # mm; distances that differ by less belong to one place of the contour


def without_compensation(text):
    lines = text.splitlines()
    return "\n".join(t if t.startswith("(") else CODES.sub("", t) for t in lines) + "\n"


class Contour:
    """The programmed contour in its plane, as chords of its elements."""

    def __init__(self, elements, plane):
        self.axes = PLANES[plane][:2]
        self.chords = []
        for start, event in elements:
            points = [self.flat(point) for point in paths.points_of(start, event, paths.chord)]
            self.chords += [(a, b) for a, b in zip(points, points[1:]) if math.dist(a, b) > SAME]

    def flat(self, point):
        return tuple(point[axis] for axis in self.axes)

    def distance_and_side(self, point):
        """Side: positive on the left of a chord that is nearest."""
        distances = [paths.distance_to_line(point, a, b) for a, b in self.chords]
        least = min(distances)
        sides = [(b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
                 for (a, b), distance in zip(self.chords, distances) if distance < least + SAME]
        return least, sides

    def fault(self, name, elements, side, radius, tolerance):
        """What is wrong with the compensated path, or None."""
        sign = 1 if side == "left" else -1
        for point in paths.samples(elements):
            distance, sides = self.distance_and_side(self.flat(point))
            at = ", ".join(f"{coordinate:.4f}" for coordinate in point)
            if abs(distance - radius) > tolerance:
                return f"{name} is {distance:.4f} mm off the contour at {at}, not {radius}"
            if max(sign * one for one in sides) <= 0:
                return f"{name} is on the wrong side of the contour at {at}"
        return None


def compensated_part(elements, bare):
    """What lies between lead-in and lead-out, and the programmed elements it belongs to."""
    def untouched(one, other):
        return one[1].kind == other[1].kind and math.dist(one[1].end, other[1].end) < SAME + 2e-4

    before = 0
    while untouched(elements[before], bare[before]):
        before += 1
    after = 1
    while untouched(elements[-after], bare[-after]):
        after += 1
    # elements[before] leads in; elements[-after] is the last compensated one, the lead-out follows.
    return elements[before + 1:len(elements) - after + 1], bare[before + 1:len(bare) - after + 1]


def behind_first_element(own, other, tolerance):
    """Both from the first common end on."""
    for i, (_, mine) in enumerate(own):
        for j, (_, theirs) in enumerate(other):
            if math.dist(mine.end, theirs.end) < tolerance:
                return own[i + 1:], other[j + 1:]
    return own, other


def difference(ours, theirs, bare, shape, tolerance):
    """What is wrong, or None. `bare`: elements of the program without compensation; `shape`: side,
    radius and plane."""
    side, radius, plane = shape
    own, programmed = compensated_part(ours, bare)
    other, _ = compensated_part(theirs, bare)
    contour = Contour(programmed, plane)
    for name, elements in (("stanok", own), ("rs274", other)):
        fault = contour.fault(name, elements, side, radius, tolerance)
        if fault:
            return fault
    own, other = behind_first_element(own, other, tolerance)
    return paths.difference(own, other, tolerance) if own and other else None
