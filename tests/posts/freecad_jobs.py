"""Jobs of FreeCAD's Path workbench, generated and posted without a display: run by freecadcmd.

Environment: STANOK_POST is the folder of stanok_post.py, STANOK_JOBS the folder to write into, STANOK_ONLY the names of
jobs, separated by commas (all if empty). Each job leaves NAME.json: its programs, the tools, the corner of the blank,
and samples of the finished faces of its solid as [x, y, z, nx, ny, nz], in the coordinates of the job. Faces that the
stock has already are left out. Samples keep away from edges, where the surface of the virtual workpiece is beveled
within a cell.

Every solid can be made by its tools: inner radii are at least those of the cutters, holes end in cones of 118 degrees.
"""

import json
import math
import os
import pathlib
import sys
import traceback
from types import SimpleNamespace

import FreeCAD
import Part
import PathScripts.PathAdaptive as PathAdaptive
import PathScripts.PathDrilling as PathDrilling
import PathScripts.PathDressupLeadInOut as PathDressupLeadInOut
import PathScripts.PathDressupRampEntry as PathDressupRampEntry
import PathScripts.PathEngrave as PathEngrave
import PathScripts.PathHelix as PathHelix
import PathScripts.PathJob as PathJob
import PathScripts.PathMillFace as PathMillFace
import PathScripts.PathPocketShape as PathPocketShape
import PathScripts.PathProfile as PathProfile
import PathScripts.PathSlot as PathSlot
import PathScripts.PathToolBit as PathToolBit
import PathScripts.PathToolController as PathToolController
import PathScripts.PathUtils as PathUtils
from PathScripts.PathPost import CommandPathPost
from PathScripts.PathPostProcessor import PostProcessor

sys.path.insert(0, os.environ["STANOK_POST"])  # as FreeCAD has the macro folder in it
sys.dont_write_bytecode = True

FOLDER = pathlib.Path(os.environ["STANOK_JOBS"])
RESOLUTION = 0.2  # of the virtual workpiece, mm
FROM_EDGES = 2.5 * RESOLUTION
SPACING = 0.5  # of the samples, mm
UP = FreeCAD.Vector(0, 0, 1)
POINT = math.tan(math.radians(59))  # half of 118 degrees: radius over height of the cone


def box(x, y, z, at=(0, 0, 0)):
    return Part.makeBox(x, y, z, FreeCAD.Vector(*at))


def cylinder(radius, height, at=(0, 0, 0)):
    return Part.makeCylinder(radius, height, FreeCAD.Vector(*at))


def rounded_box(x, y, z, radius, at=(0, 0, 0)):
    """A box whose upright edges are rounded."""
    solid = box(x, y, z, at)
    upright = [edge for edge in solid.Edges if abs(edge.Vertexes[0].Z - edge.Vertexes[-1].Z) > 1e-6]
    return solid.makeFillet(radius, upright)


def drilled(radius, depth, at):
    """What a drill of 118 degrees removes: `at` is the middle of the top, `depth` the depth of its point."""
    cone = radius / POINT
    x, y, z = at
    tip = Part.makeCone(0, radius, cone, FreeCAD.Vector(x, y, z - depth))
    return tip.fuse(cylinder(radius, depth - cone, (x, y, z - depth + cone)))


def groove(points, radius, depth, top):
    """What an end mill removes along a polyline."""
    solid = None
    for start, end in zip(points, points[1:]):
        length, angle = math.dist(start, end), math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
        piece = box(length, 2 * radius, depth, (0, -radius, 0))
        for at in (0, length):
            piece = piece.fuse(cylinder(radius, depth, (at, 0, 0)))
        piece.Placement = FreeCAD.Placement(FreeCAD.Vector(*start, top - depth), FreeCAD.Rotation(UP, angle))
        solid = piece if solid is None else solid.fuse(piece)
    return solid.removeSplitter()


class Job:
    """A job of one solid: stock with allowances, tools, operations, and its programs."""

    def __init__(self, name, solid, sides=0.0, top=0.0):
        self.name, self.solid = name, solid
        self.document = FreeCAD.newDocument(name)
        model = self.document.addObject("Part::Feature", "Solid")
        model.Shape = solid
        self.document.recompute()
        self.job = PathJob.Create("Job", [model])
        self.clone = self.job.Model.Group[0]
        for key in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos"):
            setattr(self.job.Stock, key, sides)
        self.job.Stock.ExtZneg, self.job.Stock.ExtZpos = 0.0, top
        self.tools = []
        self._first = self.job.Tools.Group[0]
        self.document.recompute()

    def tool(self, number, kind, diameter, **more):
        """A controller of FreeCAD, and a row of stanok's tool table."""
        shape = {"flat": "endmill", "drill": "drill"}[kind]
        if self._first is not None:
            controller, self._first = self._first, None
            controller.ToolNumber = number
            controller.Tool = PathToolBit.Factory.Create("Bit", f"{shape}.fcstd")
        else:
            bit = PathToolBit.Factory.Create("Bit", f"{shape}.fcstd")
            controller = PathToolController.Create(f"TC {number}", bit, number)
            self.job.Proxy.addToolController(controller)
        controller.Tool.Diameter = diameter
        if kind == "drill":
            controller.Tool.TipAngle = 118.0
        controller.Label, controller.Tool.Label = f"TC {number}", f"{shape} {diameter:g}"
        controller.HorizFeed, controller.VertFeed, controller.SpindleSpeed = "1500 mm/min", "400 mm/min", 8000
        row = {"number": number, "kind": kind, "radius": diameter / 2, "length": 70.0 + number, "flute_length": 40.0}
        self.tools.append({**row, **({"point_angle": 118.0} if kind == "drill" else {}), **more})
        self.document.recompute()
        return controller

    def operation(self, module, controller, faces=(), label=None, **properties):
        PathUtils.UserInput = SimpleNamespace(selectedToolController=lambda: controller)
        operation = module.Create(label or module.__name__.rpartition(".")[2])
        operation.ToolController = controller
        if faces:
            operation.Base = [(self.clone, tuple(faces))]
        if module is PathPocketShape:
            properties.setdefault("OffsetPattern", "ZigZagOffset")
        for key, value in properties.items():
            operation.setExpression(key, None)
            setattr(operation, key, value)
        self.document.recompute()
        return operation

    def faces(self, condition):
        found = [f"Face{index}" for index, face in enumerate(self.clone.Shape.Faces, 1) if condition(face)]
        assert found, f"{self.name}: no such face"
        return found

    def floors(self, z):
        return self.faces(lambda face: abs(face.BoundBox.ZMin - z) + abs(face.BoundBox.ZMax - z) < 1e-6)

    def bores(self, radius):
        def is_bore(face):
            return face.Surface.TypeId == "Part::GeomCylinder" and abs(face.Surface.Radius - radius) < 1e-6
        return self.faces(is_bore)

    def finish(self, arguments="", **more):
        self.document.recompute()
        arguments = f"--safe-z=200 --blank-resolution={RESOLUTION} {arguments}"
        post = PostProcessor.load("stanok")
        programs = [post.export(objects, "-", arguments) for objects in CommandPathPost().buildPostList(self.job)]
        stock = self.job.Stock.Shape.BoundBox
        record = {"programs": programs, "tools": self.tools, "blank_corner": [stock.XMin, stock.YMin, stock.ZMin],
                  "samples": samples(self.solid, stock), **more}
        (FOLDER / f"{self.name}.json").write_text(json.dumps(record), encoding="utf-8")
        FreeCAD.closeDocument(self.document.Name)


def samples(solid, stock):
    return [sample for face in solid.Faces if not is_of_stock(face.BoundBox, stock) for sample in samples_of(face)]


def is_of_stock(face, stock):
    """Whether a face lies in a side of the stock."""
    sides = (("XMin", "XMax"), ("YMin", "YMax"), ("ZMin", "ZMax"))
    return any(abs(getattr(face, low) - at) + abs(getattr(face, high) - at) < 1e-6
               for low, high in sides for at in (getattr(stock, low), getattr(stock, high)))


def samples_of(face):
    edges = Part.Compound([edge for edge in face.Edges if not edge.isSeam(face)])
    first_u, last_u, first_v, last_v = face.ParameterRange
    found = []
    for u in steps(first_u, last_u, stretch(face, "u")):
        for v in steps(first_v, last_v, stretch(face, "v")):
            point = face.valueAt(u, v)
            if face.isPartOfDomain(u, v) and Part.Vertex(point).distToShape(edges)[0] >= FROM_EDGES:
                found.append([*point, *face.normalAt(u, v)])
    return found


def stretch(face, direction):
    """Length on the face for a step of 1 of a parameter, in its middle."""
    first_u, last_u, first_v, last_v = face.ParameterRange
    u, v, step = (first_u + last_u) / 2, (first_v + last_v) / 2, 1e-4
    other = face.valueAt(u + step, v) if direction == "u" else face.valueAt(u, v + step)
    return face.valueAt(u, v).distanceToPoint(other) / step


def steps(first, last, length):
    count = max(2, math.ceil((last - first) * length / SPACING))
    return [first + (last - first) * (index + 0.5) / count for index in range(count)]


# ---- the jobs --------------------------------------------------------------------------------------------------


def plate_with_pocket():
    return box(50, 40, 12).cut(rounded_box(30, 20, 6, 5, (10, 10, 6)))


def plate_with_round_pocket():
    ring = cylinder(14, 5, (25, 20, 7)).cut(cylinder(5, 5, (25, 20, 7)))
    return box(50, 40, 12).cut(ring)


def plate_with_holes():
    solid = box(50, 40, 14)
    for x, y in ((10, 10), (40, 10), (40, 30), (10, 30)):
        solid = solid.cut(drilled(3, 9, (x, y, 14)))
    return solid


def profile(name, arguments="", dress=None, **properties):
    job = Job(name, rounded_box(40, 30, 10, 4), sides=2)
    outer = job.operation(PathProfile, job.tool(1, "flat", 8), StepDown=5.0, FinalDepth=0.0, **properties)
    if dress:
        dress(job, outer)
    job.finish(arguments)


def ramps(job, base):
    dressed = job.document.addObject("Path::FeaturePython", "RampEntryDressup")
    dressed.Proxy = PathDressupRampEntry.ObjectDressup(dressed)
    dressed.Base = base
    job.job.Proxy.addOperation(dressed, base)
    dressed.Proxy.setup(dressed)
    job.document.recompute()


def leads(job, base):
    dressed = job.document.addObject("Path::FeaturePython", "LeadInOutDressup")
    dressed.Proxy = PathDressupLeadInOut.ObjectDressup(dressed)
    dressed.Base = base
    job.job.Proxy.addOperation(dressed, base)
    dressed.Proxy.setup(dressed)
    job.document.recompute()


def pocket(name, arguments="", **properties):
    """FreeCAD's patterns ZigZag and Line leave scallops at the walls; the others go along the walls at the end."""
    job = Job(name, plate_with_pocket())
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(6), StepDown=3.0, StepOver=50, **properties)
    job.finish(arguments)


def round_pocket():
    job = Job("pocket_with_island", plate_with_round_pocket())
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(7), StepDown=2.5, StepOver=40, OffsetPattern="Offset")
    job.finish()


def adaptive_pocket():
    job = Job("adaptive_pocket", plate_with_pocket())
    job.operation(PathAdaptive, job.tool(1, "flat", 6), job.floors(6), StepDown=6.0, StepOver=25, Side="Inside",
                  Tolerance=0.01, OperationType="Clearing", FinishingProfile=True)
    job.finish()


def adaptive_and_finishing():
    job = Job("adaptive_then_finished", plate_with_pocket())
    tool = job.tool(1, "flat", 8)
    job.operation(PathAdaptive, tool, job.floors(6), StepDown=6.0, StepOver=25, Side="Inside",
                  Tolerance=0.01, OperationType="Clearing", StockToLeave=0.3, FinishingProfile=False)
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(6), StepDown=6.0, StepOver=60)
    job.finish()


def helix_bore(name, arguments="", **properties):
    solid = box(40, 40, 10).cut(cylinder(7, 10, (20, 20, 0)))
    job = Job(name, solid)
    job.operation(PathHelix, job.tool(3, "flat", 8), job.bores(7), StepDown=1.5, FinalDepth=-0.5, **properties)
    job.finish(arguments, home={"Z": 200.0})


def holes(name, arguments="", **properties):
    job = Job(name, plate_with_holes())
    job.operation(PathDrilling, job.tool(5, "drill", 6), job.bores(3), FinalDepth=5.0, **properties)
    job.finish(arguments)


def through_holes_and_profile():
    solid = rounded_box(50, 40, 8, 6)
    for x in (12, 38):
        solid = solid.cut(cylinder(2.5, 8, (x, 20, 0)))
    job = Job("drilled_and_profiled", solid, sides=2)
    job.operation(PathDrilling, job.tool(7, "drill", 5), job.bores(2.5), FinalDepth=-2.0)
    job.operation(PathProfile, job.tool(8, "flat", 10), FinalDepth=0.0, StepDown=8.0, processHoles=False)
    job.finish()


def slot():
    solid = box(40, 24, 10).cut(box(40, 8, 4, (0, 8, 6)))
    job = Job("slot", solid)
    job.operation(PathSlot, job.tool(1, "flat", 8), job.floors(6), StepDown=2.0, FinalDepth=6.0, ExtendPathStart=6.0,
                  ExtendPathEnd=6.0)
    job.finish()


def engraving(name, points, arguments=""):
    radius, depth = 1.0, 2.0
    job = Job(name, box(40, 30, 8).cut(groove(points, radius, depth, 8)))
    wire = job.document.addObject("Part::Feature", "Letters")
    wire.Shape = Part.makePolygon([FreeCAD.Vector(x, y, 8) for x, y in points])
    job.operation(PathEngrave, job.tool(4, "flat", 2), BaseShapes=[wire], StartDepth=8.0, FinalDepth=8 - depth, StepDown=0.5)
    job.finish(arguments)


def faced_and_pocketed(name, arguments="", **more):
    job = Job(name, plate_with_pocket(), top=1.5)
    face = job.tool(1, "flat", 16)
    job.operation(PathMillFace, face, ExtraOffset=8.0, StepOver=60, FinalDepth=12.0, StepDown=1.0, BoundaryShape="Stock")
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(6), StartDepth=12.0, StepDown=3.0, StepOver=50)
    job.finish(arguments, **more)


def three_tools():
    solid = box(60, 40, 14).cut(rounded_box(24, 24, 5, 5, (6, 8, 9)))
    for y in (10, 30):
        solid = solid.cut(drilled(2.5, 8, (46, y, 14)))
    job = Job("three_tools", solid, top=1.0)
    job.operation(PathMillFace, job.tool(1, "flat", 20), ExtraOffset=10.0, FinalDepth=14.0, StepOver=60,
                  BoundaryShape="Stock")
    job.operation(PathPocketShape, job.tool(2, "flat", 8), job.floors(9), StartDepth=14.0, StepDown=2.5, StepOver=50)
    job.operation(PathDrilling, job.tool(3, "drill", 5), job.bores(2.5), StartDepth=14.0, FinalDepth=6.0, PeckEnabled=True,
                  PeckDepth=2.0)
    job.finish()


def two_offsets(name, order):
    job = Job(name, plate_with_pocket())
    job.job.Fixtures = ["G54", "G55"]
    job.job.OrderOutputBy = order
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(6), StepDown=6.0, StepOver=60)
    job.finish(offsets={"G54": [0, 0, 0], "G55": [120, 0, -20]})


def boss_outside():
    solid = box(40, 40, 6).fuse(cylinder(10, 6, (20, 20, 6))).removeSplitter()
    job = Job("boss_adaptive", solid)
    job.operation(PathAdaptive, job.tool(1, "flat", 8), job.floors(12), StepDown=6.0, StepOver=25, Side="Outside",
                  Tolerance=0.01, OperationType="Clearing", FinishingProfile=True, FinalDepth=6.0)
    job.finish()


def window():
    solid = box(50, 40, 8).cut(rounded_box(26, 18, 8, 5, (12, 11, 0)))
    job = Job("window_profile", solid)
    job.operation(PathProfile, job.tool(1, "flat", 9), job.floors(8), processHoles=True, processPerimeter=False,
                  FinalDepth=0.0, StepDown=4.0)
    job.finish()


def both_sides(name, pocket_depth):
    """The first set-up, and the flipped one that begins with what the first has left."""
    top = rounded_box(24, 16, pocket_depth, 4, (8, 7, 12 - pocket_depth))
    bottom = cylinder(7, 3, (20, 15, 0))
    whole = box(40, 30, 12).cut(top).cut(bottom)
    job = Job(f"{name}_1", box(40, 30, 12).cut(top))
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(12 - pocket_depth), StepDown=4.0, StepOver=50)
    job.finish()
    flipped = whole.copy()
    flipped.rotate(FreeCAD.Vector(0, 15, 6), FreeCAD.Vector(1, 0, 0), 180)
    job = Job(f"{name}_2", flipped)
    job.operation(PathPocketShape, job.tool(2, "flat", 6), job.floors(9), StepDown=3.0, StepOver=40)
    job.finish("--blank-file=first.stl", turned_from=f"{name}_1")


ZIGZAG = ((6, 6), (14, 22), (22, 8), (30, 22), (34, 8))
JOBS = {
    "profile": lambda: profile("profile"),
    "profile_ramped": lambda: profile("profile_ramped", dress=ramps),
    "profile_led_in": lambda: profile("profile_led_in", dress=leads),
    "profile_inches": lambda: profile("profile_inches", "--inches"),
    "pocket_zigzag": lambda: pocket("pocket_zigzag", OffsetPattern="ZigZagOffset"),
    "pocket_offset": lambda: pocket("pocket_offset", OffsetPattern="Offset"),
    "pocket_haas": lambda: pocket("pocket_haas", "--dialect=haas --line-numbers", OffsetPattern="Offset"),
    "pocket_with_island": round_pocket,
    "adaptive_pocket": adaptive_pocket,
    "adaptive_then_finished": adaptive_and_finishing,
    "boss_adaptive": boss_outside,
    "helix": lambda: helix_bore("helix"),
    "helix_climb_g28": lambda: helix_bore("helix_climb_g28", "--retract=g28 --dialect=fanuc", Direction="CCW"),
    "holes": lambda: holes("holes"),
    "holes_pecked": lambda: holes("holes_pecked", PeckEnabled=True, PeckDepth=2.5),
    "holes_dwelled": lambda: holes("holes_dwelled", "--dialect=fanuc", DwellEnabled=True, DwellTime=0.2),
    "drilled_and_profiled": through_holes_and_profile,
    "slot": slot,
    "engraved": lambda: engraving("engraved", ZIGZAG),
    "engraved_inches": lambda: engraving("engraved_inches", ((5, 5), (35, 5), (35, 25), (20, 15)), "--inches --precision 5"),
    "faced_and_pocketed": lambda: faced_and_pocketed("faced_and_pocketed"),
    "three_tools": three_tools,
    "offsets_by_fixture": lambda: two_offsets("offsets_by_fixture", "Fixture"),
    "offsets_by_tool": lambda: two_offsets("offsets_by_tool", "Tool"),
    "window_profile": window,
    "both_sides": lambda: both_sides("both_sides", 5),
}


def main():
    only = [name for name in os.environ.get("STANOK_ONLY", "").split(",") if name]
    for name, make in JOBS.items():
        if only and name not in only:
            continue
        try:
            make()
        except Exception:  # noqa: BLE001: the next job has a document of its own; the test reports what is missing
            (FOLDER / f"{name}.fault").write_text(traceback.format_exc(), encoding="utf-8")


main()
