#!/usr/bin/env python3
"""Tool libraries through the command line: what `stanok tool export` writes is judged by readers that are not ours.

usage: tool_libraries_test.py STANOK SAMPLES
"""
import csv
import io
import json
import os
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zipfile

STANOK, SAMPLES = sys.argv.pop(1), sys.argv.pop(1)

TABLES = """# tools of the mill
[[tool]]
number = 1
name = "end mill 6"
length = 77.125
radius = 3.0
flute_length = 18.0
shank_diameter = 6.0
overhang = 35.0
holder_diameter = 32.0
holder_length = 55.0
wear_length = -0.012
wear_radius = 0.004

[[tool]]
number = 2
name = "drill 8.5"
kind = "drill"
length = 92.4
radius = 4.25
point_angle = 140.0

[[tool]]
number = 7
name = "bull 10 R1"
kind = "bull"
length = 80.0
radius = 5.0
corner_radius = 1.0
"""


def table_of_linuxcnc(text):
    """Words of each line by their letters, and the comment."""
    tools = {}
    for line in text.splitlines():
        words, _, comment = line.partition(";")
        fields = {word[0]: float(word[1:]) for word in words.split()}
        tools[int(fields["T"])] = {**fields, "comment": comment.strip()}
    return tools


class ToolLibraries(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.tables = self.path("tables.toml")
        self.write("tables.toml", TABLES)

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def stanok(self, *words, code=0):
        done = subprocess.run([STANOK, "tool", *words], capture_output=True, text=True, timeout=60, cwd=self.folder.name)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def answer(self, *words, code=0):
        return json.loads(self.stanok(*words, "--json", code=code).stdout)

    def test_linuxcnc_reads_its_table(self):
        done = self.stanok("export", self.tables, "--format", "linuxcnc")
        tools = table_of_linuxcnc(done.stdout)
        self.assertEqual(sorted(tools), [1, 2, 7])
        self.assertEqual(tools[1], {"T": 1, "P": 1, "Z": 77.125, "D": 6, "comment": "end mill 6"})
        self.assertEqual(tools[7]["D"], 10)
        self.assertRegex(done.stderr, "tool 7: not carried: .*corner_radius 1")
        inches = table_of_linuxcnc(self.stanok("export", self.tables, "--format", "linuxcnc", "--unit", "inch").stdout)
        self.assertAlmostEqual(inches[1]["Z"] * 25.4, 77.125, places=12)

    def test_spreadsheets_read_its_table(self):
        text = self.stanok("export", self.tables, "--format", "csv").stdout
        rows = {int(row["number"]): row for row in csv.DictReader(io.StringIO(text))}
        self.assertEqual(float(rows[1]["wear_length_mm"]), -0.012)
        self.assertEqual(rows[2]["kind"], "drill")
        self.assertEqual(float(rows[7]["corner_radius_mm"]), 1)
        self.assertEqual(self.answer("export", self.tables, "--format", "csv")["not_carried"], [])

    def test_freecad_reads_its_library_and_bits(self):
        for folder in ("Tools", "Tools/Library", "Tools/Bit"):
            os.mkdir(self.path(folder))
        answer = self.answer("export", self.tables, "--output", "Tools/Library/mill.fctl")
        self.assertEqual(answer["written"][-1], "Tools/Library/mill.fctl")
        library = json.loads(self.read("Tools/Library/mill.fctl"))
        self.assertEqual([entry["nr"] for entry in library["tools"]], [1, 2, 7])
        bits = [json.loads(self.read("Tools/Bit/" + entry["path"])) for entry in library["tools"]]
        self.assertEqual([bit["shape"] for bit in bits], ["endmill.fcstd", "drill.fcstd", "bullnose.fcstd"])
        self.assertEqual(bits[0]["parameter"]["Diameter"], "6 mm")
        self.assertEqual(bits[1]["parameter"]["TipAngle"], "140 deg")
        self.assertEqual(bits[2]["parameter"]["FlatRadius"], "1 mm")
        self.assertIn((1, "length"), [(one["tool"], one["field"]) for one in answer["not_carried"]])
        done = self.stanok("export", self.tables, "--output", "Tools/Library/mill.fctl", code=1)
        self.assertIn("--force", done.stderr)
        done = self.stanok("export", self.tables, "--format", "freecad", code=2)
        self.assertIn("--output", done.stdout + done.stderr)

    def test_fusion_reads_its_library(self):
        self.stanok("export", self.tables, "--output", "mill.tools", "--unit", "inch")
        with zipfile.ZipFile(self.path("mill.tools")) as packed:
            self.assertIsNone(packed.testzip())
            self.assertEqual(packed.namelist(), ["tools.json"])
            library = json.loads(packed.read("tools.json"))
        tools = {tool["post-process"]["number"]: tool for tool in library["data"]}
        self.assertEqual(tools[2]["type"], "drill")
        self.assertEqual(tools[1]["unit"], "inches")
        self.assertAlmostEqual(tools[1]["geometry"]["DC"] * 25.4, 6, places=12)
        self.assertEqual(tools[1]["holder"]["segments"][0]["lower-diameter"], 32 / 25.4)
        self.stanok("export", self.tables, "--output", "mill.json")
        self.assertEqual(json.loads(self.read("mill.json"))["data"][0]["geometry"]["LCF"], 18)

    def test_a_bomb_is_refused_soon(self):
        with zipfile.ZipFile(self.path("bomb.tools"), "w", zipfile.ZIP_DEFLATED) as packed:
            packed.writestr("tools.json", b" " * (300 << 20))
        done = self.stanok("import", "bomb.tools", code=1)
        self.assertIn("unpacks to more than 64 MiB", done.stderr)

    def test_controls_read_their_listings(self):
        for name, factor in (("fanuc", 1), ("haas", 2)):
            text = self.stanok("export", self.tables, "--format", name).stdout
            values = {(int(line[1]), int(line[2])): float(line[3])
                      for line in re.finditer(r"^G10 L(\d+) P(\d+) R(-?\d+\.\d{3})( \(.*\))?$", text, re.M)}
            self.assertEqual(len(values), 12)
            self.assertEqual(values[10, 1], 77.125)
            self.assertEqual(values[11, 1], -0.012)
            self.assertEqual(values[12, 2], 4.25 * factor)
            self.assertEqual(values[13, 1], 0.004 * factor)
            self.assertTrue(text.isascii())
            back = self.write(name + ".txt", text)
            answer = self.answer("import", back, "--format", name, "--offsets-only")
            self.assertEqual(answer["remarks"][0].count("--cutter"), 1)
            self.assertNotIn("name", answer["tables"])
            self.assertEqual(tomllib.loads(answer["tables"])["tool"][0]["radius"], 3)

    def test_what_is_imported_is_a_tables_file(self):
        done = self.stanok("import", os.path.join(SAMPLES, "linuxcnc", "lathe.tbl"))
        tools = {tool["number"]: tool for tool in tomllib.loads(done.stdout)["tool"]}
        self.assertEqual(tools[2]["orientation"], 2)
        self.assertEqual(tools[2]["length_x"], -24)
        self.assertEqual(tools[3]["radius"], 6)
        self.assertIn("--unit inch", done.stderr)

    def test_nothing_is_overwritten_or_written_in_error(self):
        table = self.write("tool.tbl", "T1 P1 Z5 D6 ;cutter\n")
        self.stanok("import", table, "--output", self.tables, code=1)
        self.assertEqual(self.read("tables.toml"), TABLES)
        self.stanok("import", table, "--output", self.tables, "--force")
        self.assertEqual(len(tomllib.loads(self.read("tables.toml"))["tool"]), 1)
        wrong = self.write("wrong.tbl", "T1 P1 Z5\nT2 P2 Zx\n")
        refused = self.answer("import", wrong, "--output", "new.toml", code=1)
        self.assertFalse(refused["ok"])
        fault = refused["diagnostics"][0]
        self.assertEqual((fault["file"], fault["line"], fault["column"]), (wrong, 2, 7))
        self.stanok("import", wrong, "--into", self.tables, code=1)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["tables.toml", "tool.tbl", "wrong.tbl"])

    def test_tools_of_equal_numbers_are_refused_or_replaced(self):
        table = self.write("tool.tbl", "T1 P1 Z79.5 D6 ;cutter\nT9 P9 Z50 D3\n")
        done = self.stanok("import", table, "--into", self.tables, code=1)
        self.assertIn("tables.toml:2:1: tool 1 is also in the imported file; --replace", done.stderr)
        self.assertEqual(self.read("tables.toml"), TABLES)
        answer = self.answer("import", table, "--into", self.tables, "--replace")
        self.assertEqual((answer["added"], answer["replaced"], answer["tools"]), (1, 1, 2))
        tools = {tool["number"]: tool for tool in tomllib.loads(self.read("tables.toml"))["tool"]}
        self.assertEqual(tools[1]["length"], 79.5)
        self.assertEqual(tools[1]["flute_length"], 18, "what the library does not have stays")
        self.assertTrue(self.read("tables.toml").startswith("# tools of the mill\n"))

    def test_not_carried_is_listed_by_tool_and_field(self):
        table = self.write("tool.tbl", "T1 P5 Z5 D6 A1.5\n")
        lost = self.answer("import", table)["not_carried"]
        self.assertEqual([(one["tool"], one["field"], one["value"]) for one in lost], [(1, "P", "5"), (1, "A", "1.5")])

    def test_the_format_must_be_known(self):
        unknown = self.write("tools.xyz", "T1 P1\n")
        done = self.stanok("import", unknown, code=2)
        self.assertIn("--format", done.stdout + done.stderr)
        self.assertIn("linuxcnc", done.stdout + done.stderr)
        self.stanok("import", unknown, "--format", "linuxcnc", "--unit", "mm")
        self.stanok("import", unknown, "--format", "nonsense", code=2)
        self.stanok("export", self.tables, code=2)

    def test_every_sample_is_imported_and_loads_again(self):
        count = 0
        for format_name in sorted(os.listdir(SAMPLES)):
            for name in sorted(os.listdir(os.path.join(SAMPLES, format_name))):
                sample = os.path.join(SAMPLES, format_name, name)
                if not os.path.isfile(sample):
                    continue
                count += 1
                with self.subTest(sample=sample):
                    answer = self.answer("import", sample, "--format", format_name)
                    self.assertEqual(len(tomllib.loads(answer["tables"])["tool"]), answer["tools"])
                    again = self.write("again.toml", answer["tables"])
                    self.assertTrue(self.answer("export", again, "--format", "linuxcnc")["ok"])
        self.assertGreaterEqual(count, 35)

    def test_a_machine_file_that_names_a_table_of_linuxcnc_says_so(self):
        self.write("tool.tbl", "T1 P1 Z5 D6\n")
        machine = self.write("machine.toml", '[machine]\nname = "m"\ntables = "tool.tbl"\n')
        done = subprocess.run([STANOK, "machine", "check", machine], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("tool.tbl:1:1: this is a LinuxCNC tool table", done.stderr)
        self.assertIn("stanok tool import tool.tbl", done.stderr)


# What a row of the formats' table promises, seen from outside: the list that help texts show.
class Help(unittest.TestCase):
    def test_names_the_formats(self):
        done = subprocess.run([STANOK, "tool", "import", "--help"], capture_output=True, text=True, timeout=60)
        text = " ".join(done.stdout.split())
        self.assertIn("linuxcnc, csv, freecad, fusion, fusion-csv, fanuc, haas", text)


if __name__ == "__main__":
    unittest.main()
