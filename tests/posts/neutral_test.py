#!/usr/bin/env python3
"""The neutral post: text of its programs, errors, and where the tool goes on the shipped machines.

usage: neutral_test.py STANOK ROOT_OF_THE_PROJECT
"""
import contextlib
import copy
import io
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

STANOK, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path[:0] = [str(ROOT / "posts/neutral"), str(ROOT / "tests/posts")]

import readings  # noqa: E402
import stanok_neutral  # noqa: E402
import stanok_program  # noqa: E402

TOP = {
    "name": "plate", "tools": [{"number": 2, "name": "end mill 10", "kind": "flat", "diameter": 10}],
    "blank": {"box": [80, 60, 20], "zero": [40, 30, 20], "resolution": 0.5}, "machine": {"safe_z": 200},
    "operations": [{
        "name": "rim (first)", "tool": 2, "speed": 6000, "coolant": "flood",
        "moves": [{"rapid": [-30, 0, 10]}, {"feed": [None, None, -2], "f": 300}, {"feed": [-10, None, None], "f": 800},
                  {"arc": "ccw", "to": [10, 0, -3], "center": [0, 0], "f": 800},
                  {"arc": "cw", "to": [10, 0, None], "center": [5, 0], "f": 800}, {"rapid": [None, None, 10]},
                  {"drill": "peck", "points": [[20, 10], [20, -10]], "top": 2, "bottom": -8, "peck": 3, "f": 150},
                  {"dwell": 0.5}, {"comment": "done (all)"}, {"stop": "optional"}],
    }],
}
TOP_TEXT = """(dialect stanok)
(plate)
(T2: end mill 10, kind flat, diameter 10)
G21 G90 G94 G17 G40 G49 G69 G80 G91.1
(operation: rim [first])
G53 G0 Z200
T2 M6
G54
#workpiece (0, 0.5, 0, 80, 60, 20, 40, 30, 20)
S6000 M3
G43 H2
M8
G0 X-30 Y0
Z10
G1 Z-2 F300
X-10 F800
G3 X10 Y0 Z-3 I10 J0
G2 X10 Y0 I-5 J0
G0 Z10
G98
G83 X20 Y10 Z-8 R2 Q3 F150
G83 X20 Y-10 Z-8 R2 Q3
G80
G4 P0.5
(done [all])
M1
G53 G0 Z200
M9
M5
M30
"""


def operation(**keys):
    return {"name": "part", "tool": 2, "speed": 5000, **keys}


def job_of(*operations, **keys):
    return {"operations": list(operations), **keys}


class Text(unittest.TestCase):
    def test_a_job_is_written_block_by_block(self):
        self.assertEqual(stanok_neutral.program_of(TOP), TOP_TEXT)

    def test_the_guide_shows_what_is_written(self):
        guide = (ROOT / "docs/programmer/posts.md").read_text(encoding="utf-8")
        job, program = re.search(r"```json\n(.*?)```\n\nbecomes\n\n```\n(.*?)```", guide, re.DOTALL).groups()
        self.assertEqual(stanok_neutral.program_of(json.loads(job)), program)
        slope = re.search(r'```json\n(\{"name": "slope".*?)```', guide, re.DOTALL).group(1)
        tilt = math.degrees(math.atan2(0.4226, 0.9063))  # 24.99924
        sloping = stanok_neutral.program_of(job_of(json.loads(slope)))
        self.assertIn(f"G68.2 X0 Y-30 Z0 I0 J{round(tilt, 6)} K0\nG53.1\n", sloping)
        script = re.search(r"```python\n(.*?)```", guide, re.DOTALL).group(1)
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            exec(script, {})  # noqa: S102: the script of the guide
        self.assertIn("G0 X-30 Y0\nZ10\nG1 Z-2 F300\nX30 F800\n", shown.getvalue())

    def test_options_change_the_text(self):
        text = stanok_neutral.program_of(TOP, line_numbers=True, comments=False, retract="g28", dialect="fanuc")
        self.assertTrue(text.startswith("(dialect fanuc)\nN10 G21"))
        self.assertIn("N20 G91 G28 Z0\nN30 G90\n", text)
        self.assertNotIn("rim", text)

    def test_tools_change_with_spindle_off_and_offsets_with_z_up(self):
        moves = [{"rapid": [0, 0, 5]}]
        text = stanok_neutral.program_of(job_of(operation(moves=moves), operation(tool=1, moves=moves),
                                                operation(tool=1, offset="G54.1 P3", moves=moves)))
        self.assertIn("G53 G0 Z0\nM5\nT1 M6\nS5000 M3\nG43 H1\n", text)
        self.assertIn("G53 G0 Z0\nG54.1 P3\nG43 H1\nG0 X0 Y0\nZ5\n", text)

    def test_dwells_have_a_point(self):
        moves = [{"rapid": [0, 0, 5]}, {"dwell": 2},
                 {"drill": "dwell", "points": [[0, 0]], "top": 1, "bottom": -1, "dwell": 3, "f": 100}]
        text = stanok_neutral.program_of(job_of(operation(moves=moves)))
        self.assertIn("G4 P2.\nG98\nG82 X0 Y0 Z-1 R1 P3. F100\n", text)

    def test_a_short_arc_is_a_line_and_a_long_one_between_the_same_words_a_circle(self):
        step = math.radians(0.002)  # 0.00035 mm at a radius of 10: both ends are written X10 Y0
        near = [10 * math.cos(step), 10 * math.sin(step), None]
        for direction, code in (("ccw", None), ("cw", "G2 X10 Y0 I-10 J0 F200")):
            moves = [{"rapid": [10, 0, 1]}, {"arc": direction, "to": near, "center": [0, 0], "f": 200}]
            lines = stanok_neutral.program_of(job_of(operation(moves=moves))).splitlines()
            self.assertEqual([line for line in lines if "I-10" in line], [code] if code else [])

    def test_planes_of_a_normal_are_those_of_their_rotation(self):
        seed = 20241105
        print(f"seed {seed}")
        random_ = random.Random(seed)
        for _ in range(500):
            normal = [random_.gauss(0, 1) for _ in range(3)]
            along = [random_.gauss(0, 1) for _ in range(3)] if random_.random() < 0.5 else None
            first, tilt, third = stanok_program.Plane.of_normal((0, 0, 0), normal, along).euler

            def turned(p):
                return readings.about_z(readings.about_x(readings.about_z(p, third), tilt), first)
            z_W, x_W = turned((0, 0, 1)), turned((1, 0, 0))
            length = math.hypot(*normal)
            self.assertLess(math.dist(z_W, [value / length for value in normal]), 1e-9)
            if along is None:
                self.assertLess(abs(x_W[2]), 1e-9)
            else:  # the side of `along`, in the plane of it and the normal
                self.assertGreater(sum(a * b for a, b in zip(x_W, along)), 0)
                y_W = turned((0, 1, 0))
                self.assertLess(abs(sum(a * b for a, b in zip(y_W, along))), 1e-9)


FAULTS = [  # what is changed in TOP, and what the message says
    (lambda job: job.update(speed=1), 'the job has the unknown key "speed"'),
    (lambda job: job.pop("operations"), 'the job lacks "operations"'),
    (lambda job: job.update(units="cm"), '"units" is \'cm\'; it must be one of mm, inch'),
    (lambda job: job["machine"].update(decimals=9), '"decimals" is 9; it must be 1 to 6'),
    (lambda job: job["operations"][0].update(tool="2"), 'operation 1 "rim (first)": "tool" must be a whole number'),
    (lambda job: job["operations"][0].update(speed=0), '"speed" must be above 0; "spindle": "off" leaves the spindle off'),
    (lambda job: job["operations"][0].update(offset="G60"), "G60 is no work offset"),
    (lambda job: job["operations"][0].update(coolant="air"), '"coolant" is \'air\'; it must be one of off, flood, mist'),
    (lambda job: job["operations"][0].update(plane={}), '"plane" needs either "euler" or "normal"'),
    (lambda job: job["operations"][0].update(plane={"normal": [0, 0, 0]}), "the vector [0, 0, 0] has no length"),
    (lambda job: job["operations"][0].update(five_axis="tcp"), "it must be vectors or angles"),
    (lambda job: job["operations"][0]["moves"][1].pop("f"), 'move 2: "f" is missing'),
    (lambda job: job["operations"][0]["moves"][1].update(f=0), "move 2: the feed must be above 0"),
    (lambda job: job["operations"][0]["moves"][1].update(feed=[0, 0]), 'move 2: "feed" must be a list of 3 numbers'),
    (lambda job: job["operations"][0]["moves"][1].update(feed=[0, 0, float("nan")]), 'must be a list of 3 numbers'),
    (lambda job: job["operations"][0]["moves"][1].update(tool=[0, 0, 1]), 'a tool vector needs "five_axis": "vectors"'),
    (lambda job: job["operations"][0]["moves"][1].update(angles={"A": 1}), 'angles need "five_axis": "angles"'),
    (lambda job: job["operations"][0]["moves"][3].update(center=[-10, 0]), "the center of the arc is its start"),
    (lambda job: job["operations"][0]["moves"][3].update(arc="left"), '"arc" is \'left\'; it must be one of cw, ccw'),
    (lambda job: job["operations"][0].update(moves=job["operations"][0]["moves"][3:]), "the arc begins at an unknown point"),
    (lambda job: job["operations"][0].update(moves=[{"rapid": [None, None, 5]}]), "must be a rapid with X, Y and Z"),
    (lambda job: job["operations"][0].update(moves=job["operations"][0]["moves"][6:]), "must be a rapid with X, Y and Z"),
    (lambda job: job["operations"][0]["moves"][6].pop("peck"), '"drill": "peck" needs "peck" above 0'),
    (lambda job: job["operations"][0]["moves"][6].update(pitch=1), '"pitch" does not belong to "drill": "peck"'),
    (lambda job: job["operations"][0]["moves"][6].update(deep=1), 'move 7: the move has the unknown key "deep"'),
    (lambda job: job["operations"][0]["moves"][6].update(bottom="-8"), '"bottom" must be a number'),
    (lambda job: job["operations"][0]["moves"].append({"moove": 1}), "a move has one of the keys rapid, feed, arc"),
    (lambda job: job["blank"].pop("zero"), '"blank" lacks "zero"'),
]


class Faults(unittest.TestCase):
    def test_each_fault_is_named_with_its_place(self):
        for change, message in FAULTS:
            job = copy.deepcopy(TOP)
            change(job)
            with self.subTest(message=message), self.assertRaises(stanok_program.ProgramError) as raised:
                stanok_neutral.program_of(job)
            self.assertIn(message, str(raised.exception))

    def test_cycles_and_arcs_are_refused_under_tool_vectors(self):
        for move in ({"drill": "drill", "points": [[0, 0]], "top": 1, "bottom": -1, "f": 100},
                     {"arc": "cw", "to": [0, 0, 0], "center": [1, 0], "f": 100}):
            moves = [{"rapid": [0, 0, 5], "tool": [0, 0, 1]}, move]
            with self.assertRaisesRegex(stanok_program.ProgramError, 'in a plane only; give the operation a "plane"'):
                stanok_neutral.program_of(job_of(operation(five_axis="vectors", moves=moves)))


class CommandLine(unittest.TestCase):
    def post(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            source, target = pathlib.Path(folder) / "job.json", pathlib.Path(folder) / "part.nc"
            source.write_text(text, encoding="utf-8")
            post = [sys.executable, "-B", ROOT / "posts/neutral/stanok_neutral.py", source, "-o", target, *options]
            result = subprocess.run(post, capture_output=True, text=True, check=False)
            return result.returncode, result.stderr, target.read_text(encoding="utf-8") if target.exists() else None

    def test_writes_a_file(self):
        self.assertEqual(self.post(json.dumps(TOP)), (0, "", TOP_TEXT))
        self.assertIn("G53 G0 Z150\n", self.post(json.dumps(TOP), "--safe-z", "150")[2])

    def test_writes_nothing_when_the_job_has_a_fault(self):
        for text, message in (("{", "job.json: Expecting property name"),
                              ('{"operations": [{}]}', 'operation 1 "": the operation lacks')):
            code, errors, program = self.post(text)
            self.assertEqual((code, program), (1, None))
            self.assertIn(message, errors)


class OnMachines(unittest.TestCase):
    def simulated(self, mill, job, tool=2, **overrides):
        with tempfile.TemporaryDirectory() as folder:
            return readings.Run(STANOK, mill, stanok_neutral.program_of(job, **overrides), folder, tool)

    def test_three_axes_go_where_the_job_says(self):
        path = [(-30, 0, 10), (-30, 0, -2), (-10, 0, -2)]
        path += readings.arc_points(path[-1], (10, 0, -3), (0, 0), clockwise=False)
        path += readings.arc_points((10, 0, -3), (10, 0, -3), (5, 0), clockwise=True) + [(10, 0, 10)]
        holes = [point for x, y in ((20, 10), (20, -10)) for point in ((x, y, 10), (x, y, -8), (x, y, 2), (x, y, 10))]
        chords = 5 * (1 - math.cos(math.pi / 96))  # of the polyline here: a turn of radius 5 in 96 pieces
        runs = [(readings.mill3(ROOT), 200, dialect) for dialect in stanok_program.DIALECTS]
        runs.append((readings.trunnion(ROOT), 0, "stanok"))
        for mill, safe_z, dialect in runs:
            with self.subTest(machine=mill.file.name, dialect=dialect):
                ran = self.simulated(mill, TOP, safe_z=safe_z, dialect=dialect)
                ran.passes(path + holes)
                ran.cuts_only(path + holes, below=9.9, near=readings.NEAR_MM + chords)

    def test_inches_are_the_same_path(self):
        moves = [{"rapid": [1, 0, 1]}, {"feed": [1, 0, -0.1], "f": 12},
                 {"arc": "ccw", "to": [-1, 0, None], "center": [0, 0], "f": 30},
                 {"drill": "drill", "points": [[0.5, 0.25]], "top": 0.1, "bottom": -0.5, "f": 10}]
        ran = self.simulated(readings.mill3(ROOT), job_of(operation(moves=moves), units="inch", machine={"safe_z": 8}))
        inches = [(1, 0, 1), (1, 0, -0.1), (0, 1, -0.1), (-1, 0, -0.1), (0.5, 0.25, -0.5)]
        ran.passes([tuple(25.4 * value for value in point) for point in inches])

    def test_a_plane_and_the_upright_operations_beside_it(self):
        upright = operation(name="top", moves=[{"rapid": [-30, 5, 20]}, {"feed": [-30, 5, -1], "f": 500},
                                               {"feed": [20, -5, -1], "f": 900}])
        faces = []
        for normal, along in (([0, -math.sin(0.4), math.cos(0.4)], None), ([0.3, -0.2, 0.9], [1, 0.5, 0])):
            moves = [{"rapid": [-5, 4, 30]}, {"feed": [-5, 4, -1], "f": 500}, {"feed": [10, 4, -1], "f": 900},
                     {"rapid": [10, 4, 20]},
                     {"drill": "drill", "points": [[3, -2]], "top": 2, "bottom": -5, "f": 200}]
            plane = {"origin": [2, -10, -3], "normal": normal, **({"x": along} if along else {})}
            faces.append((operation(name="slope", plane=plane, moves=moves), normal, along))
        ran = self.simulated(readings.trunnion(ROOT), job_of(upright, faces[0][0], upright, faces[1][0], upright))
        top = [(-30, 5, 20), (-30, 5, -1), (20, -5, -1)]
        expected = list(top)
        for _, normal, along in faces:
            expected += [self.of_plane((2, -10, -3), normal, along, p)
                         for p in ((-5, 4, 30), (-5, 4, -1), (10, 4, -1), (10, 4, 20), (3, -2, -5))] + top
        rows = ran.passes(expected)
        for index, row in enumerate(rows):
            face = index // 8
            ran.leans(row, (0, 0, 1) if index % 8 < 3 else faces[face][1], within=0.001)

    @staticmethod
    def of_plane(origin, normal, along, point):
        """A point of a plane in W, by the vectors of its axes: Z is the normal, X along the edge or along a vector."""
        def unit(v):
            return [value / math.hypot(*v) for value in v]

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        z_W = unit(normal)
        x_W = unit(cross((0, 0, 1), z_W)) if along is None else unit(cross(cross(z_W, along), z_W))
        y_W = cross(z_W, x_W)
        return tuple(o + point[0] * x + point[1] * y + point[2] * z for o, x, y, z in zip(origin, x_W, y_W, z_W))

    def test_five_axes_by_vectors(self):
        stations = [((0, 0, 30), (0.1, -0.2, 0.97)), ((10, 5, 20), (0.17, -0.3, 0.98)), ((12, 6, 22), (0.34, -0.2, 0.94)),
                    ((20, 0, 25), (0.1, -0.4, 0.9))]
        moves = [{"feed": list(p), "tool": list(v), "f": 600} for p, v in stations]
        moves[0] = {"rapid": list(stations[0][0]), "tool": list(stations[0][1])}
        ran = self.simulated(readings.trunnion(ROOT), job_of(operation(five_axis="vectors", moves=moves)))
        for row, (_, vector) in zip(ran.passes([p for p, _ in stations]), stations):
            ran.leans(row, vector)

    def test_five_axes_by_angles(self):
        stations = [((0, 0, 30), {"A": 0, "C": 0}), ((10, 5, 20), {"A": -20, "C": -90}),
                    ((-8, 5, 22), {"A": 10.5, "C": -60})]
        moves = [{"feed": list(p), "angles": angles, "f": 600} for p, angles in stations]
        moves[0] = {"rapid": list(stations[0][0]), "angles": stations[0][1]}
        ran = self.simulated(readings.trunnion(ROOT), job_of(operation(five_axis="angles", moves=moves)))
        for row, (_, angles) in zip(ran.passes([p for p, _ in stations]), stations):
            ran.leans(row, readings.about_z(readings.about_x((0, 0, 1), -angles["A"]), -angles["C"]))

    def test_planes_run_on_a_mill_with_head_and_table(self):
        moves = [{"rapid": [0, 0, 30]}, {"feed": [0, 0, 5], "f": 500}, {"feed": [10, 0, 5], "f": 500}]
        job = job_of(operation(moves=moves), operation(plane={"normal": [0.3, 0.1, 0.95]}, moves=moves))
        machine = ROOT / "config/machines/e7106mf4.toml"
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "part.nc"
            program.write_text(stanok_neutral.program_of(job, safe_z=0), encoding="utf-8")
            for command in ("check", "simulate"):
                code, output = readings.run(STANOK, command, "--machine", machine, "--scheme", "1=2", program)
                self.assertEqual(code, 0, output)

    def test_a_tap_has_the_feed_of_its_pitch(self):
        moves = [{"rapid": [0, 0, 10]}, {"drill": "tap", "points": [[5, 5]], "top": 3, "bottom": -6, "pitch": 1.25}]
        job = job_of(operation(speed=637, moves=moves), machine={"safe_z": 200})
        self.assertIn("G84 X5 Y5 Z-6 R3 F796.25\n", stanok_neutral.program_of(job))  # 1.25 mm * 637 / min
        self.simulated(readings.mill3(ROOT), job).passes([(0, 0, 10), (5, 5, -6), (5, 5, 3)])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
