#!/usr/bin/env python3
"""The path that the page draws is the one that the machine follows: points of the WebSocket beside `--tip-trace`.

usage: drawn_path_test.py STANOK_WEB STANOKD STANOK MACHINE_FILE [unittest arguments]
"""
import csv
import math
import os
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from running_daemon import running_daemon  # noqa: E402
from web_browser import PATIENCE_S, Browser, running_web  # noqa: E402

STANOK_WEB, STANOKD, STANOK, MACHINE = (sys.argv.pop(1) for _ in range(4))
# What the path may leave out (docs/reference/protocol.md#programs), and Float32 of some hundred millimetres.
TOLERANCE_MM = 0.01 + 1e-4

FIGURE = """G0 X10 Y-10 Z20
G1 Z-2 F3000
G1 X30
G3 X40 Y0 I0 J10
G64
G1 X35 Y12
X20 Y15
X10 Y5
G2 X10 Y-10 I-2 J-7.5
G61
G1 Z20
"""
HEAD = "G21 G90 G17 G40 G49 G54\n"
FIVE_AXES = """T2 M6
G43.4 H2
G0 X0 Y0 Z60 B0 C0
G1 X10 Y-10 Z30 F3000
G1 X25 Y5 Z28 B15 C40
G1 X-10 Y20 Z30 B-10 C120
G1 X0 Y0 Z40 B0 C0
G49
"""
PROGRAMS = {
    "plain": HEAD + FIGURE + "M30\n",
    "another work offset": HEAD + "G10 L2 P2 X40 Y-35 Z12\nG55\n" + FIGURE + "M30\n",
    "turned": HEAD + "G68 X5 Y5 R33\n" + FIGURE + "G69\n" + FIGURE + "M30\n",
    "after another kinematic scheme": HEAD + FIGURE + "#kinematics (2, 1)\nG54\n" + FIGURE + "M30\n",
    "tip of the tool with five axes": HEAD + "#kinematics (2, 1)\nG54\n" + FIVE_AXES + "M30\n",
}


def distance(point, one, other):
    """From a point to the line between two others."""
    way = [b - a for a, b in zip(one, other)]
    length2 = sum(w * w for w in way)
    part = sum((p - a) * w for p, a, w in zip(point, one, way)) / length2 if length2 else 0.0
    part = min(1.0, max(0.0, part))
    return math.dist(point, [a + part * w for a, w in zip(one, way)])


def farthest(points, lines):
    """How far the points are from the nearest of the lines at most."""
    return max(min(distance(point, *line) for line in lines) for point in points)


class DrawnPath(unittest.TestCase):
    def traced(self, folder):
        """The programmed point of every cycle, while it moves."""
        file = os.path.join(folder, "tip.csv")
        subprocess.run([STANOK, "simulate", os.path.join(folder, "part.nc"), "--machine", MACHINE,
                        "--tip-trace", f"1={file}"], check=True, capture_output=True, timeout=PATIENCE_S)
        with open(file, encoding="ascii") as rows:
            return [tuple(float(row[word]) for word in "xyz") for row in csv.DictReader(rows)]

    def drawn(self, socket_path):
        """Lines of the planned path, as the page gets them."""
        with tempfile.TemporaryDirectory() as folder, \
                running_web(STANOK_WEB, folder, socket_path, error=subprocess.DEVNULL) as web:
            browser = Browser(web)
            browser.enter_by_link()
            window = browser.open_window()
            window.ask("program.load", program="part.nc")
            end = time.monotonic() + PATIENCE_S
            while not (path := window.ask("program.path", page=0))["complete"]:
                self.assertLess(time.monotonic(), end, path)
                time.sleep(0.05)
            window.binary.clear()
            lines, last = [], None
            for page in range(path["pages"]):
                told = window.ask("program.path", page=page)["geometry"]
                while not (frames := [one for one in window.binary if struct.unpack_from("<4I", one)[2] == page]):
                    window.binary.append(window.receive_frame()[1])
                numbers = struct.unpack_from(f"<{3 * told['count']}f", frames[-1], 16)
                begins = {k for first, behind in told["begins"] for k in range(first, behind)}
                for k, point in enumerate(zip(*[iter(numbers)] * 3)):
                    if last is not None and k not in begins:
                        lines.append((last, point))
                    last = point
            window.close()
        return lines

    def test_points_are_those_of_the_tip(self):
        for name, program in PROGRAMS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                with open(os.path.join(folder, "part.nc"), "w", encoding="ascii") as part:
                    part.write(program)
                tip = self.traced(folder)
                with running_daemon(STANOKD, MACHINE, program) as daemon:
                    lines = self.drawn(daemon.socket_path)
                self.assertGreater(len(lines), 4)
                self.assertGreater(max(math.dist(*line) for line in lines), 1.0, "chords, not every cycle")
                # Every tenth cycle, while it moves: at rest a work offset or a scheme may change.
                way = [here for before, here in zip(tip, tip[1:]) if before != here]
                left_out = farthest(way[::10], lines)
                added = farthest([line[1] for line in lines], list(zip(tip, tip[1:])))
                print(f"{name}: {len(way)} cycles, {len(lines)} lines; {left_out:.5f} and {added:.5f} mm")
                self.assertLessEqual(max(left_out, added), TOLERANCE_MM)


if __name__ == "__main__":
    unittest.main(verbosity=2)
