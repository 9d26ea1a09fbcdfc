#!/usr/bin/env python3
"""A simulation that is interrupted while it cuts a fine workpiece ends at once, with what it has: the report is written,
surface and picture are not.

usage: interrupted_simulation_test.py STANOK MILL_FILE
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

STANOK, MACHINE = sys.argv[1:3]
TICKS = os.sysconf("SC_CLK_TCK")
IN_THE_CUT = 4.0  # processor time, s, after which the program of the test is loaded and cuts
AT_ONCE = 1.5  # processor time, s, whatever else the computer does


def processor_time(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


# Faces a slab of 80 x 60 mm in lines 1 mm apart, 30 times; the workpiece in cells of 0.05 mm.
SLAB = """G21 G90 G17
#workpiece (0, 0.05, 0, 80, 60, 30, 0, 0, 30)
G10 L1 P1 Z50 R10
T1 M6
G43 H1
M3 S3000
F3000
for (num level = 29; level > 0; level = level - 1) {
  for (num row = 0; row <= 60; row = row + 2) {
    G0 X-15 Y=row Z=level
    G1 X95
    G1 Y=row+1
    G1 X-15
    G0 Z40
  }
}
M30
"""


class InterruptedSimulation(unittest.TestCase):
    def check(self, number):
        with tempfile.TemporaryDirectory() as folder:
            program, report, surface, picture = (os.path.join(folder, name)
                                                 for name in ("slab.nc", "report.json", "part.stl", "part.png"))
            with open(program, "w", encoding="utf-8") as file:
                file.write(SLAB)
            process = subprocess.Popen([STANOK, "simulate", program, "--machine",
                                        MACHINE, "--workpiece-report",
                                        report, "--workpiece-out", surface, "--picture", picture],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            while processor_time(process.pid) < IN_THE_CUT:
                if process.poll() is not None:
                    self.fail(f"the run is over before it is interrupted: {process.stderr.read()}")
                time.sleep(0.01)
            before = processor_time(process.pid)
            process.send_signal(number)
            errors = process.stderr.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            process.stdout.close()
            process.stderr.close()
            self.assertEqual(process.returncode, 130, errors)
            self.assertLess(usage.ru_utime + usage.ru_stime - before, AT_ONCE)
            with open(report, encoding="utf-8") as file:
                self.assertGreater(json.load(file)["removed_mm3"], 0.0)
            self.assertFalse(os.path.exists(surface) or os.path.exists(picture))
            self.assertIn("interrupted", errors)

    def test_ends_at_once_with_its_report(self):
        self.check(signal.SIGTERM)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
