"""Figures of a run from the commanded positions of its axes, one row a cycle.

The deviation is the larger one of two: how far a row is from the path, and how far a join of two
blocks is from the curve through the rows. Both look within a stretch of the path around the place
reached only, so that a neighbouring row of the path cannot hide anything. Velocity, acceleration and
jerk are differences of first to third order over the cycle: means of the true ones, never larger.
"""

import bisect
import itertools
import math

STRETCH = 1.0  # mm of path to both sides of the place reached
STANDING = 1e-6  # mm or degrees: nearer than this is the same place


def moving_rows(rows):
    """The rows from the last one at the start to the first one at the end."""
    def differs(row, place):
        return max(abs(a - b) for a, b in zip(row, place)) > STANDING

    begin = next((k for k, row in enumerate(rows) if differs(row, rows[0])), len(rows) - 1)
    end = next((k for k in range(len(rows) - 1, -1, -1) if differs(rows[k], rows[-1])), 0)
    return rows[max(0, begin - 1):end + 2]


def places_of(rows, blocks, begins):
    """Of each row: distance from the path, length of the path up to there, error of the rotary axes."""
    found, place = [], 0.0
    for row in rows:
        first = max(0, bisect.bisect_right(begins, place - STRETCH) - 1)
        last = bisect.bisect_right(begins, place + STRETCH)
        (distance, share), k = min((blocks[k].nearest(row), k) for k in range(first, last))
        block = blocks[k]
        place = begins[k] + share * block.length
        turned = max(abs(r - s - share * (e - s)) for r, s, e in zip(row[3:], block.start[3:], block.end[3:]))
        found.append((distance, place, turned))
    return found


def curve_distance(rows, k, point, steps=16):
    """Distance of a point from the curve through the rows beside row k."""
    best = math.dist(rows[k][:3], point)
    for n in (k - 1, k):
        if n < 1 or n + 2 >= len(rows):
            continue
        p0, p1, p2, p3 = (rows[n + m][:3] for m in (-1, 0, 1, 2))
        for step in range(1, steps):
            u = step / steps
            w = ((-u + 2 * u**2 - u**3) / 2, (2 - 5 * u**2 + 3 * u**3) / 2, (u + 4 * u**2 - 3 * u**3) / 2,
                 (u**3 - u**2) / 2)
            best = min(best, math.dist([sum(c * p[a] for c, p in zip(w, (p0, p1, p2, p3))) for a in range(3)], point))
    return best


def missed_joins(rows, reached, blocks, begins):
    """The largest distance of a block's end from the curve through the rows."""
    furthest, worst = list(itertools.accumulate(reached, max)), 0.0
    for block, begin in zip(blocks, begins):
        place, point = begin + block.length, block.end[:3]
        first = max(0, bisect.bisect_left(furthest, place - STRETCH) - 1)
        last = min(len(rows), bisect.bisect_right(furthest, place + STRETCH) + 1)
        nearest = min(range(first, last), key=lambda k: math.dist(rows[k][:3], point))
        worst = max(worst, curve_distance(rows, nearest, point))
    return worst


def differences(column, order):
    for _ in range(order):
        column = [b - a for a, b in zip(column, column[1:])]
    return max(map(abs, column), default=0.0)


def figures(rows, blocks, cycle):
    """Time in s, deviation in mm and degrees, largest velocity, acceleration and jerk of each axis."""
    columns = list(zip(*([rows[0]] * 3 + rows + [rows[-1]] * 3)))
    last, rows = rows[-1], moving_rows(rows)
    begins = [0.0, *itertools.accumulate(block.length for block in blocks)][:-1]
    places = places_of(rows, blocks, begins)
    beside = max(distance for distance, _, _ in places)
    missed = missed_joins(rows, [place for _, place, _ in places], blocks, begins)
    return {
        "time_s": (len(rows) - 1) * cycle,
        "deviation_mm": max(beside, missed),
        "rotary_deviation_deg": max(turned for _, _, turned in places),
        "end_error": max(abs(a - b) for a, b in zip(last, blocks[-1].end)),
        "velocity": [differences(column, 1) / cycle for column in columns],
        "acceleration": [differences(column, 2) / cycle**2 for column in columns],
        "jerk": [differences(column, 3) / cycle**3 for column in columns],
    }
