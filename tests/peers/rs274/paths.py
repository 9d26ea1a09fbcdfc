"""Compares two lists of events as paths: where the tool goes, not in how many pieces.

Radius compensation may cut a path into other elements (a corner arc in two, a line that has no length
left) and still mean the same. Each path is a list of lines and arcs; points of the one must lie on the
other within the tolerance, and the other way round.
"""

import math

from events import PLANES

SAMPLE_STEP = 1.0  # mm between the points that are looked at
SAGITTA = 1e-4  # mm between an arc and the chords that stand for it


def elements_of(events):
    """(start, event) of every move."""
    position, elements = (0.0,) * 6, []
    for event in events:
        if event.end:
            elements.append((position, event))
            position = event.end
    return elements


def arc_angles(start, event):
    first, second, _ = PLANES[event.plane]
    begin = math.atan2(start[second] - event.centre[1], start[first] - event.centre[0])
    finish = math.atan2(event.end[second] - event.centre[1], event.end[first] - event.centre[0])
    sign = 1 if event.turns > 0 else -1
    sweep = sign * (finish - begin) % (2 * math.pi) or 2 * math.pi
    return begin, sign * (sweep + 2 * math.pi * (abs(event.turns) - 1))


def points_of(start, event, step):
    """Points along a move, its ends included; `step` says how far apart for a radius (None: a line)."""
    if event.kind != "arc":
        count = max(1, math.ceil(math.dist(start[:3], event.end[:3]) / step(None)))
        return [tuple(a + (b - a) * k / count for a, b in zip(start[:3], event.end[:3]))
                for k in range(count + 1)]
    first, second, along = PLANES[event.plane]
    radius = math.hypot(start[first] - event.centre[0], start[second] - event.centre[1])
    begin, sweep = arc_angles(start, event)
    count = max(8, math.ceil(abs(sweep) * radius / step(radius)))
    points = []
    for k in range(count + 1):
        angle = begin + sweep * k / count
        point = [0.0] * 3
        point[first] = event.centre[0] + radius * math.cos(angle)
        point[second] = event.centre[1] + radius * math.sin(angle)
        point[along] = start[along] + (event.end[along] - start[along]) * k / count
        points.append(tuple(point))
    return points


def chord(radius):
    return math.inf if radius is None else 2 * math.sqrt(2 * radius * SAGITTA)


def polyline(elements):
    return [p for start, event in elements for p in points_of(start, event, chord)]


def samples(elements):
    return [p for start, event in elements
            for p in points_of(start, event, lambda _: SAMPLE_STEP)]


def distance_to_line(point, start, end):
    direction = [b - a for a, b in zip(start, end)]
    length_squared = sum(d * d for d in direction)
    share = 0.0
    if length_squared > 0:
        share = sum((p - a) * d for p, a, d in zip(point, start, direction)) / length_squared
    share = min(max(share, 0.0), 1.0)
    return math.dist(point, [a + share * d for a, d in zip(start, direction)])


def farthest(points, others):
    """The point of `points` that lies farthest from the polyline of `others`, and how far."""
    worst, place = 0.0, None
    for point in points:
        distance = min(distance_to_line(point, a, b) for a, b in zip(others, others[1:]))
        if distance > worst:
            worst, place = distance, point
    return worst, place


def difference(ours, theirs, tolerance):
    """What is wrong, or None; both are lists of elements."""
    ends = [next((event.end[:3] for _, event in reversed(one)), None) for one in (ours, theirs)]
    if None in ends or math.dist(*ends) > tolerance:
        return f"stanok ends at {ends[0]}, rs274 at {ends[1]}"
    for name, own, other in (("stanok", ours, theirs), ("rs274", theirs, ours)):
        distance, place = farthest(samples(own), polyline(other))
        if distance > tolerance:
            at = ", ".join(f"{coordinate:.4f}" for coordinate in place)
            return f"{name} goes through {at}, {distance:.4f} mm from the path of the other"
    return None
