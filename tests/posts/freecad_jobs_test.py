#!/usr/bin/env python3
"""Jobs of FreeCAD through the post, `stanok check` and `stanok simulate`: the virtual part is the solid.

At each sample of the finished faces of a solid, the distance to the virtual part is measured along the normal of the
face: above 0 is material that is left, below 0 is a gouge. 99.9 % of a job's samples are within 0.02 mm, and no gouge
is deeper than 0.03 mm. The same part shifted by 0.1 mm must fail, so that the comparison can.

usage: freecad_jobs_test.py STANOK ROOT_OF_THE_PROJECT [JOB ...]
exit code 77: FreeCAD or NumPy is missing (tools/install-packages.sh cam)
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

STANOK, ROOT, ONLY = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]
FREECAD = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
if FREECAD is None:
    print("skipped: FreeCAD is not installed (tools/install-packages.sh cam)")
    sys.exit(77)
try:
    import numpy
except ImportError:
    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])  # NumPy is Debian's
    print("skipped: NumPy is not installed (tools/install-packages.sh cam)")
    sys.exit(77)

WITHIN_MM, SHARE, GOUGE_MM = 0.02, 0.999, 0.03
SHIFT_MM = (0.06, 0.06, 0.053)  # 0.1 mm along a diagonal: seen by walls and by floors
FAR_MM = 0.5  # a surface that is farther from a sample than this is missing
CELL_MM = 0.5  # of the table in which triangles are found; theirs are smaller
JOBS = 20  # at least


class Surface:
    """Triangles of an STL file, found by the cells in which their middles lie."""

    def __init__(self, file, corner):
        data = file.read_bytes()
        rows = numpy.frombuffer(data[84:], dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("rest", "<u2")])
        self.triangles = rows["corners"].reshape(-1, 3, 3).astype(float) + numpy.array(corner)
        cells = numpy.floor(self.triangles.mean(axis=1) / CELL_MM).astype(int)
        self._table = {}
        order = numpy.lexsort(cells.T)
        ends = numpy.flatnonzero(numpy.any(numpy.diff(cells[order], axis=0), axis=1)) + 1
        for group in numpy.split(order, ends):
            self._table[tuple(cells[group[0]])] = group

    def along(self, point, normal):
        """Signed distance from a point to the nearest triangle along a normal; FAR_MM where there is none."""
        cell = numpy.floor(point / CELL_MM).astype(int)
        near = [self._table[key] for key in ((cell[0] + i, cell[1] + j, cell[2] + k) for i in (-1, 0, 1) for j in (-1, 0, 1)
                                             for k in (-1, 0, 1)) if key in self._table]
        if not near:
            return FAR_MM
        found = crossings(point, normal, self.triangles[numpy.concatenate(near)])
        return found[numpy.argmin(numpy.abs(found))] if found.size else FAR_MM


def crossings(point, direction, triangles):
    """Distances along a line to the triangles that it meets, by Cramer's rule; edges count for both sides."""
    a, u, v = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    across = numpy.cross(direction, v)
    determinant = numpy.einsum("ij,ij->i", u, across)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        from_a = point - a
        first = numpy.einsum("ij,ij->i", from_a, across) / determinant
        turned = numpy.cross(from_a, u)
        second = turned @ direction / determinant
        distance = numpy.einsum("ij,ij->i", v, turned) / determinant
        met = (first >= -1e-6) & (second >= -1e-6) & (first + second <= 1 + 1e-6) & (numpy.abs(distance) < FAR_MM)
    return distance[met]


def deviations(surface, samples, shift=(0, 0, 0)):
    return numpy.array([surface.along(sample[:3] + numpy.array(shift), sample[3:]) for sample in samples])


def share_within(found):
    return numpy.mean(numpy.abs(found) <= WITHIN_MM)


def described(found):
    return f"{100 * share_within(found):.2f} % within {WITHIN_MM} mm, from {found.min():.4f} to {found.max():.4f} mm"


def is_right(found):
    return share_within(found) >= SHARE and found.min() >= -GOUGE_MM


def machine_of(folder, job):
    """mill3 with the tools and offsets of a job."""
    text = (ROOT / "config/machines/mill3.toml").read_text(encoding="utf-8")
    text = text.replace('name = "mill3"', 'name = "mill3"\ntables = "tables.toml"', 1)
    (folder / "mill.toml").write_text(text, encoding="utf-8")
    lines = []
    for tool in job["tools"]:
        lines += ["[[tool]]"] + [f"{key} = {json.dumps(value)}" for key, value in tool.items()]
    for name, zero in job.get("offsets", {"G54": [0, 0, 0]}).items():
        lines += [f"[offset.{name}]"] + [f"{axis} = {float(value)}" for axis, value in zip("XYZ", zero)]
    lines += ["[reference_point.1.G28]"] + [f"{axis} = {value}" for axis, value in job.get("home", {}).items()]
    (folder / "tables.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder / "mill.toml"


def turned_over(source, corner, target):
    """The part of a first set-up as the blank of the flipped one: half a turn about the line Y15 Z6, in job coordinates."""
    data = bytearray(source.read_bytes())
    rows = numpy.frombuffer(data, dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("rest", "<u2")], offset=84)
    points = rows["corners"].reshape(-1, 3, 3) + numpy.array(corner, dtype="f4")
    rows["corners"] = (points * [1, -1, -1] + [0, 30, 12]).reshape(-1, 9)
    target.write_bytes(data)


class FreecadJobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": str(cls.folder), "STANOK_ONLY": ",".join(ONLY),
                       "STANOK_POST": str(ROOT / "posts/freecad"), "STANOK_JOBS": str(cls.folder)}
        made = subprocess.run([FREECAD, str(ROOT / "tests/posts/freecad_jobs.py")], env=environment, cwd=cls.folder,
                              capture_output=True, text=True, check=False)
        cls.output = made.stdout[-4000:] + made.stderr[-4000:]
        cls.jobs = {file.stem: json.loads(file.read_text(encoding="utf-8")) for file in sorted(cls.folder.glob("*.json"))}

    def test_every_job_is_generated_and_posted(self):
        faults = [f"{file.stem}: {file.read_text(encoding='utf-8')}" for file in self.folder.glob("*.fault")]
        self.assertEqual(faults, [])
        self.assertGreaterEqual(len(self.jobs), 1 if ONLY else JOBS, self.output)

    def test_every_part_is_its_solid_and_would_not_be_if_it_were_shifted(self):
        parts = {}
        for name, job in self.jobs.items():
            with self.subTest(job=name):
                part, corner = parts[name] = self.cut(name, job, parts)
                self.compare(name, Surface(part, corner), numpy.array(job["samples"]))

    def cut(self, name, job, parts):
        """The STL file of the virtual part, and the corner of its blank in the coordinates of the job."""
        folder = self.folder / name
        folder.mkdir()
        machine = machine_of(folder, job)
        corner = job["blank_corner"]
        if "turned_from" in job:
            turned_over(*parts[job["turned_from"]], folder / "first.stl")
            corner = (0.0, 0.0, 0.0)
        program = folder / "part.nc"
        program.write_text("".join(job["programs"]), encoding="utf-8")
        self.stanok("check", program, machine)
        self.stanok("simulate", program, machine, "--workpiece-out", folder / "part.stl")
        return folder / "part.stl", corner

    def stanok(self, command, program, machine, *more):
        words = [str(word) for word in (STANOK, command, "--machine", machine, program, *more)]
        result = subprocess.run(words, capture_output=True, text=True, check=False)
        output = result.stdout + result.stderr
        self.assertEqual(result.returncode, 0, output)
        self.assertNotIn("W92", output)  # rapids through material, shanks, holders, a spindle that is off

    def compare(self, name, surface, samples):
        found = deviations(surface, samples)
        print(f"{name}: {len(samples)} samples, {described(found)}", flush=True)
        self.assertGreater(len(samples), 200)
        self.assertTrue(is_right(found), described(found))
        self.assertFalse(is_right(deviations(surface, samples, SHIFT_MM)), "a shift of 0.1 mm is not seen")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
