#!/usr/bin/env python3
"""FreeCAD's post without FreeCAD: objects with the attributes that it reads, and where the tool goes.

usage: freecad_objects_test.py STANOK ROOT_OF_THE_PROJECT
"""
import ast
import importlib.util
import math
import pathlib
import shutil
import sys
import tempfile
import unittest
from types import SimpleNamespace

STANOK, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/posts"))

import readings  # noqa: E402


def loaded():
    """The post as FreeCAD loads it: one file, in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copy(ROOT / "posts/freecad/stanok_post.py", folder)
        spec = importlib.util.spec_from_file_location("stanok_post", copy)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module


POST = loaded()


def command(name, **words):
    return SimpleNamespace(Name=name, Parameters=words)


def thing(label, commands, **attributes):
    return SimpleNamespace(Label=label, Path=SimpleNamespace(Commands=commands), InList=[], **attributes)


def fixture(name="G54"):
    return thing(name, [command(name), command("G0", Z=15.0)])


def quantity(value):
    return SimpleNamespace(Value=value)


def controller(number=2, speed=6000.0, turning="M3", **tool):
    commands = [command("(TC: end mill)"), command("M6", T=number)] + ([command(turning, S=speed)] if turning else [])
    return thing("TC: end mill", commands, ToolNumber=number,
                 Tool=SimpleNamespace(Label="End mill (10)", Diameter=quantity(10.0), **tool))


def operation(*commands, label="Profile", **attributes):
    return thing(label, list(commands), **attributes)


def stock(x, y, z, **attributes):
    box = SimpleNamespace(XMin=x[0], XMax=x[1], YMin=y[0], YMax=y[1], ZMin=z[0], ZMax=z[1], XLength=x[1] - x[0],
                          YLength=y[1] - y[0], ZLength=z[1] - z[0])
    return SimpleNamespace(Shape=SimpleNamespace(BoundBox=box), **attributes)


def with_job(objects, **attributes):
    """The objects of a job, which FreeCAD finds through a group that refers to each operation."""
    blank = stock((-40, 40), (-30, 30), (-20, 0))
    job = SimpleNamespace(Label="Plate", Operations=None, InList=[], Stock=blank, **attributes)
    for obj in objects[1:]:
        obj.InList = [SimpleNamespace(InList=[job])]
    return objects


FEED, PLUNGE = 800 / 60, 300 / 60  # mm/s
CUT = [command("(Contour (outer))"), command("G0", Z=10.0), command("G0", X=-30.0, Y=0.0), command("G0", Z=2.0),
       command("G1", X=-30.0, Y=0.0, Z=-2.0, F=PLUNGE), command("g01", X=-10.0, Y=0.0, Z=-2.0, F=FEED),
       command("G3", X=10.0, Y=0.0, Z=-3.0, I=10.0, J=0.0, K=0.0, F=FEED),
       command("G2", X=10.0, Y=0.0, Z=-3.0, I=-5.0, J=0.0, F=FEED), command("G00", Z=10.0)]
DRILL = [command("G0", Z=10.0), command("G90"), command("G99"), command("G0", X=20.0, Y=10.0),
         command("G83", X=20.0, Y=10.0, Z=-8.0, R=2.0, Q=3.0, F=PLUNGE),
         command("G83", X=20.0, Y=-10.0, Z=-8.0, R=2.0, Q=3.0, F=PLUNGE),
         command("G80"), command("G0", Z=10.0)]


def plate():
    return with_job([fixture(), controller(), operation(*CUT, CoolantMode="Flood"),
                     operation(*DRILL, label="Holes", CoolantMode="None")])


PLATE_TEXT = """(dialect stanok)
(job: Plate)
(T2: End mill [10], D10)
G21 G90 G94 G17 G40 G49 G80 G91.1
G53 G0 Z0
G54
#workpiece (0, 0.2, 0, 80, 60, 20, 40, 30, 20)
(TC: end mill)
T2 M6
G43 H2
S6000 M3
(operation: Profile)
M8
(Contour [outer])
G0 X-30 Y0
Z10
Z2
G1 Z-2 F300
X-10 F800
G3 X10 Y0 Z-3 I10 J0
G2 X10 Y0 I-5 J0
G0 Z10
(operation: Holes)
M9
G90
G99
X20 Y10
G83 X20 Y10 Z-8 R2 Q3 F300
G83 X20 Y-10 Z-8 R2 Q3
G80
G0 Z10
G53 G0 Z0
M5
M30
"""


def posted(objects, arguments=""):
    return POST.export(objects, "-", arguments)


def lines_with(text, word):
    return [line for line in text.splitlines() if word in line.split()]


class Text(unittest.TestCase):
    def test_the_file_stands_alone_and_is_of_python_3_8(self):
        tree = ast.parse((ROOT / "posts/freecad/stanok_post.py").read_text(encoding="utf-8"), feature_version=(3, 8))
        imported = {name.name for node in ast.walk(tree) if isinstance(node, ast.Import) for name in node.names}
        self.assertEqual(imported, {"argparse", "math", "re", "shlex"})
        self.assertFalse([node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)])

    def test_a_job_is_written_block_by_block(self):
        self.assertEqual(posted(plate()), PLATE_TEXT)

    def test_the_text_is_also_in_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            name = pathlib.Path(folder) / "plate.nc"
            text = POST.export(plate(), str(name), "")
            self.assertEqual(name.read_bytes().decode("utf-8"), text)

    def test_every_option_changes_the_text(self):
        text = posted(plate(), "--no-comments --line-numbers --dialect=haas --wcs='G54.1 P5' --safe-z 120.5 --no-blank")
        self.assertTrue(text.startswith("(dialect haas)\nN10 G21 "))
        self.assertIn("\nN20 G53 G0 Z120.5\nN30 G54.1 P5\nN40 T2 M6\n", text)
        self.assertNotIn("#workpiece", text)
        self.assertEqual(text.count("("), 1)
        self.assertTrue(posted(plate(), "--no-header").startswith("G21 "))
        self.assertIn("G91 G28 Z0\nG90\n", posted(plate(), "--retract=g28"))
        self.assertNotIn("G53", posted(plate(), "--retract none"))
        self.assertIn("#workpiece (0, 0.05, 0,", posted(plate(), "--blank-resolution=0.05"))

    def test_inches_and_decimals(self):
        text = posted(plate(), "--inches")
        self.assertIn("G20 G90", text)
        self.assertIn("X-1.1811 Y0\n", text)  # -30 / 25.4
        self.assertIn("G1 Z-0.0787 F11.811\n", text)  # 300 / 25.4
        self.assertIn("X-1.2 Y0\n", posted(plate(), "--inches --precision 1"))

    def test_tools_of_one_number_are_listed_once_with_geometry(self):
        drill = controller(3, TipAngle=quantity(118.0), ShapeName="drill", Length=quantity(50.0))
        text = posted([fixture(), controller(7), operation(*CUT), drill, operation(*DRILL), controller(7), operation(*CUT)])
        self.assertEqual([line for line in text.splitlines() if line.startswith("(T")][:2],
                         ["(T3: End mill [10], drill, D10, point angle 118, length 50)", "(T7: End mill [10], D10)"])
        self.assertEqual(len(lines_with(text, "M6")), 3)
        self.assertIn("(TC: end mill)\nG53 G0 Z0\nM5\nT3 M6\nG43 H3\nS6000 M3\n", text)

    def test_a_round_stock_is_a_cylinder(self):
        objects = plate()
        job = objects[1].InList[0].InList[0]
        job.Stock = stock((-5, 35), (10, 50), (-30, 0), Radius=quantity(20.0), Height=quantity(30.0))
        self.assertIn("#workpiece (1, 0.1, 0, 40, 0, 30, -15, -30, 30)\n", posted(objects))  # its axis is at X15 Y30
        job.Stock = stock((-5, 35), (10, 40), (-30, 10), Radius=quantity(15.0), Height=quantity(40.0))  # lies along X
        self.assertIn("#workpiece (0, 0.1, 0, 40, 30, 40, 5, -10, 30)\n", posted(objects))

    def test_several_offsets_raise_z_between_them(self):
        text = posted([fixture("G54"), controller(), operation(*CUT), fixture("G59.1"), operation(*CUT)])
        self.assertIn("G0 Z10\nG53 G0 Z0\nG59.1\n(operation: Profile)\n", text)
        self.assertEqual(text.count("Z15"), 0)

    def test_z_goes_down_only_over_the_first_point_of_an_operation(self):
        text = posted([fixture("G54"), controller(), operation(*CUT), fixture("G55"), operation(*CUT)])
        self.assertEqual(text.count("\n(Contour [outer])\nG0 X-30 Y0\nZ10\nZ2\n"), 2)
        without = posted([fixture("G54"), controller(), operation(*CUT)], "--retract=none")
        self.assertIn("\nG0 Z10\nX-30 Y0\nZ2\n", without)  # the height at the start is not known

    def test_a_table_turns_before_z_goes_down(self):
        moves = [command("G0", A=90.0), command("G0", Z=10.0), command("G0", X=1.0), command("G0", Y=2.0),
                 command("G0", Z=5.0)]
        self.assertIn("\nG0 A90\nX1\nY2\nZ10\nZ5\n", posted([controller(), operation(*moves)]))

    def test_a_height_that_waits_comes_before_a_cut(self):
        text = posted([controller(), operation(command("G0", Z=5.0), command("G1", Z=-1.0, F=PLUNGE))])
        self.assertIn("\nG0 Z5\nG1 Z-1 F300\n", text)

    def test_an_offset_that_stanok_lacks_can_be_another_one(self):
        text = posted([fixture("G59.7"), controller(), operation(*CUT)], "--wcs=G54.1P7")
        self.assertIn("\nG54.1 P7\n", text)
        self.assertNotIn("G59.7", text)

    def test_an_inactive_operation_is_left_out_and_a_dressup_has_the_coolant_of_its_operation(self):
        base = operation(CoolantMode="Mist", Active=True)
        dressed = operation(*CUT, label="Dogbone", Base=base)
        text = posted([fixture(), controller(), dressed, operation(command("G77"), label="off", Active=False)])
        self.assertIn("(operation: Dogbone)\nM7\n", text)
        self.assertNotIn("off", text)

    def test_a_short_arc_is_a_line_and_a_long_one_between_the_same_words_a_circle(self):
        step = math.radians(0.002)  # 0.00035 mm at a radius of 10: both ends are written X10 Y0
        for name, circles in (("G3", []), ("G2", ["G2 X10 Y0 I-10 J0 F800"])):
            arc = command(name, X=10 * math.cos(step), Y=10 * math.sin(step), I=-10.0, J=0.0, F=FEED)
            text = posted([controller(), operation(command("G0", X=10.0, Y=0.0, Z=1.0), arc)])
            self.assertEqual(lines_with(text, "I-10"), circles)

    def test_arcs_of_other_planes_have_the_centres_of_these(self):
        moves = [command("G0", X=0.0, Y=0.0, Z=0.0), command("G18"),
                 command("G2", X=10.0, Y=0.0, Z=0.0, I=5.0, J=0.0, K=0.0, F=FEED)]
        self.assertEqual(lines_with(posted([controller(), operation(*moves)]), "G2"), ["G2 X10 Z0 K0 I5 F800"])

    def test_a_tap_has_the_feed_of_its_pitch(self):
        tap = command("G84", X=0.0, Y=0.0, Z=-6.0, R=3.0, F=4.0, S=637.0)
        tools = SimpleNamespace(Tool=SimpleNamespace(Pitch=quantity(1.25)))
        text = posted([controller(speed=637.0), operation(command("G0", X=0.0, Y=0.0, Z=5.0), tap, ToolController=tools)])
        self.assertEqual(lines_with(text, "G84"), ["G84 X0 Y0 Z-6 R3 F796.25"])  # 1.25 mm * 637 / min

    def test_dwells_have_a_point(self):
        moves = [command("G4", P=2.0), command("G82", X=0.0, Y=0.0, Z=-1.0, R=1.0, P=0.25, F=PLUNGE)]
        text = posted([controller(), operation(*moves)])
        self.assertIn("G4 P2.\n", text)
        self.assertIn("G82 X0 Y0 Z-1 R1 P0.25 F300\n", text)


AT_ZERO = command("G0", X=0.0, Y=0.0, Z=5.0)
FAULTS = [  # objects, arguments, what the message says
    ([controller(), operation(command("G5", X=1.0))], "", "operation Profile: G5 X1: this command is unknown to the post"),
    ([controller(), operation(command("G91"))], "", "G91: this command is unknown"),
    ([controller(), operation(AT_ZERO, command("G1", X=1.0, F=0.0))], "", "G1 F0 X1: the feed is 0; set the feeds"),
    ([controller(), operation(AT_ZERO, command("G1", X=1.0))], "", "F is missing"),
    ([controller(speed=0.0)], "", "the spindle speed is 0; set it in the tool controller, or its direction to None"),
    ([operation(AT_ZERO)], "", "the move comes before the first tool"),
    ([fixture("G53")], "", "no work offset of stanok; choose G54 to G59.3"),
    ([fixture("G59.4")], "", "no work offset of stanok"),
    ([fixture("G54"), fixture("G55")], "--wcs=G56", "the job has several work offsets"),
    ([controller(), operation(AT_ZERO, command("G2", X=1.0, I=0.5, K=0.1, F=1.0))], "",
     "K does not belong to an arc in G17"),
    ([controller(), operation(AT_ZERO, command("G2", X=1.0, F=1.0))], "", "the arc has no centre"),
    ([controller(), operation(command("G2", X=1.0, I=1.0, F=1.0))], "", "the arc begins where X and Y are not known"),
    ([controller(), operation(command("G1", A=10.0, X=1.0, F=1.0))], "", "rotary axes at feed are not written"),
    ([controller(), operation(command("G84", X=0.0, Y=0.0, Z=-1.0, R=1.0, F=1.0))], "", "the tool has no pitch"),
    ([controller(), operation(CoolantMode="Air")], "", "coolant Air is unknown; use None, Flood or Mist"),
    ([SimpleNamespace(Label="Box", InList=[])], "", "Box has no path"),
    ([], "--units inch", "unrecognized arguments: --units inch"),
    ([], "--wcs=G60", "G60 is no work offset; write G54 to G59"),
    ([], "--precision 9", "argument --precision: invalid choice: 9"),
    ([], "--help", "usage: stanok"),
]


class Faults(unittest.TestCase):
    def test_each_fault_names_operation_and_command(self):
        for objects, arguments, message in FAULTS:
            with self.subTest(message=message), self.assertRaises(POST.PostError) as raised:
                posted(objects, arguments)
            self.assertIn(message, str(raised.exception))

    def test_a_file_is_not_written_when_the_job_has_a_fault(self):
        with tempfile.TemporaryDirectory() as folder:
            name = pathlib.Path(folder) / "part.nc"
            with self.assertRaises(POST.PostError):
                POST.export([controller(), operation(command("G5"))], str(name), "")
            self.assertFalse(name.exists())


class OnMachines(unittest.TestCase):
    def test_the_tool_goes_where_the_commands_say(self):
        path = [(-30, 0, 10), (-30, 0, -2), (-10, 0, -2)]
        path += readings.arc_points(path[-1], (10, 0, -3), (0, 0), clockwise=False)
        path += readings.arc_points((10, 0, -3), (10, 0, -3), (5, 0), clockwise=True) + [(10, 0, 10)]
        path += [(20, 10, 10), (20, 10, -8), (20, 10, 2), (20, -10, 2), (20, -10, -8), (20, -10, 10)]
        chords = 5 * (1 - math.cos(math.pi / 96))  # of the polyline here: a turn of radius 5 in 96 pieces
        mills = [(readings.mill3(ROOT), "--safe-z=200"), (readings.trunnion(ROOT), "")]
        runs = [(mill, safe) for mill, safe in mills]
        runs += [(mills[0][0], f"--safe-z=200 {more}") for more in
                 ("--inches", "--dialect=linuxcnc", "--dialect=fanuc", "--dialect=haas --line-numbers")]
        for mill, arguments in runs:
            with self.subTest(machine=mill.file.name, arguments=arguments), tempfile.TemporaryDirectory() as folder:
                ran = readings.Run(STANOK, mill, posted(plate(), arguments), folder, tool=2)
                ran.passes(path)
                ran.cuts_only(path, below=9.9, near=readings.NEAR_MM + chords)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
