#!/usr/bin/env python3
"""Logs in Python against `stanok log export` and `stanok log info`: the same bits, in bounded memory.

usage: logs_test.py [--bytes N]: also a log of N bytes, read with a bound on the memory.
"""
import json
import os
import resource
import shutil
import subprocess
import sys
import unittest

import numpy as np
import stanok
from surroundings import EXAMPLES, MACHINES, InFolder, columns_of_csv, same_bits
from surroundings import stanok as command
from simulation_test import expect_export

MILL = MACHINES / "mill3.toml"

# Read in a process of its own: what the interpreter and the arrays of NumPy take is there already when the
# limit comes. It is one of private memory, in which every array lies.
BOUNDED = """
import resource, sys
import stanok
log, rows, more = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
now = next(int(line.split()[1]) * 1024 for line in open("/proc/self/status") if line.startswith("VmData"))
resource.setrlimit(resource.RLIMIT_DATA, (now + more, now + more))
if rows == 0:
    stanok.read_log(log)
count, top = 0, 0.0
for part in stanok.read_log(log, chunk=rows):
    count += part.rows
    top = max(top, part.path_speed.max())
print(count, top, part.cycle[-1])
"""


def read_bounded(log, rows, more):
    """Reads a log by chunks (0: at once) in a process with `more` bytes of memory for it."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    return subprocess.run([sys.executable, "-c", BOUNDED, log, str(rows), str(more)], capture_output=True, text=True,
                          check=False, env=environment)


class Logs(InFolder):
    def simulated(self, machine=MILL, program=EXAMPLES / "helix.nc", *options):
        log = self.folder / "run.lcm"
        command("simulate", program, "--machine", machine, "--log", log, *options)
        return log

    def exported(self, log, channel=1):
        table = self.folder / "run.csv"
        command("log", "export", log, "--csv", table, "--channel", channel)
        return columns_of_csv(table)

    def test_a_log_tells_what_gave_words_their_meaning(self):
        program = self.folder / "frames.nc"
        program.write_text("G21 G90\nG10 L2 P2 X10 Y20 Z30\nG0 X1\nG55 G52 X1\nG0 X2\nG20 G43.1 Z2\nG0 X0\nM30\n")
        log = self.simulated(MILL, program)
        told = list(stanok.open_log(log).situations())
        numbers = [one["situation"] for one in told]
        self.assertEqual(numbers, sorted(set(numbers)))
        shifted = next(one for one in told if one["terms"]["local_shift"]["X"] == 1.0)
        self.assertEqual(shifted["work_offset"], "G55")
        self.assertEqual(shifted["terms"]["work_offset"], {"X": 10.0, "Y": 20.0, "Z": 30.0})
        self.assertEqual(shifted["frame"]["offset"], {"X": 11.0, "Y": 20.0, "Z": 30.0})
        self.assertEqual(shifted["units"], "mm")
        longer = next(one for one in told if one["length"]["length"][2] != 0.0)
        self.assertAlmostEqual(longer["length"]["length"][2], 50.8, 12)
        self.assertEqual(longer["units"], "inch")
        self.assertIn("G43.1", longer["codes"])
        # As the command line tells it, for one channel too.
        lines = command("log", "situations", log, "--json", "--channel", 1).splitlines()
        self.assertEqual([json.loads(line) for line in lines], told)
        table = command("log", "situations", log).splitlines()
        self.assertEqual(len(table), len(told) + 1)
        self.assertEqual(list(stanok.open_log(log).situations(channel=2)), [])

    def test_a_log_has_the_bits_of_its_export(self):
        log = self.simulated()
        setpoints = stanok.read_log(log)
        self.assertEqual(tuple(setpoints), stanok.ALL_COLUMNS)
        expect_export(self, setpoints, self.exported(log))

    def test_chunks_are_the_whole_in_pieces(self):
        log = self.simulated()
        whole = stanok.read_log(log)
        for rows in (777, 10_000, 10**9):
            parts = list(stanok.read_log(log, chunk=rows))
            self.assertTrue(all(part.rows == rows for part in parts[:-1]))
            for column in stanok.ALL_COLUMNS:
                self.assertTrue(same_bits(np.concatenate([part[column] for part in parts]), whole[column]), column)

    def test_several_channels(self):
        log = self.folder / "run.lcm"
        command("simulate", "--machine", MACHINES / "millturn4.toml", "--run", f"1={EXAMPLES / 'millturn4.nc'}",
                "--log", log, "--until", 6, code=4)
        opened = stanok.open_log(log)
        self.assertEqual(len(opened.channels), 4)
        with self.assertRaisesRegex(ValueError, "choose one"):
            opened.setpoints()
        for channel in opened.channels[:2]:
            setpoints = opened.setpoints(channel=channel)
            self.assertEqual(setpoints.channel, channel)
            expect_export(self, setpoints, self.exported(log, channel))

    def test_info_is_that_of_the_command(self):
        log = self.simulated()
        opened = stanok.open_log(log)
        self.assertEqual(opened.info, json.loads(command("log", "info", log, "--json")))
        self.assertTrue(opened.is_sound and not opened.is_cut)

    def test_events_are_those_of_the_simulation(self):
        program = self.write("part.nc", "G1 X1 F600\n(MSG, half way)\nX2\n(MSG, done)\nM30\n")
        log = self.simulated(MILL, program)
        simulated = stanok.simulate(MILL, program).events
        self.expect_told(log, simulated)
        self.assertGreaterEqual(len(simulated), 2)

    def expect_told(self, log, events):
        """The log tells of these events, and of the file of each."""
        told = [(event.cycle, event.channel, event.code, event.text, event.file, event.line)
                for event in stanok.open_log(log).events()]
        for event in events:
            self.assertIn((event.cycle, event.channel, event.code, event.text, event.file, event.line), told)

    def test_an_event_names_the_file_in_which_it_is(self):
        self.write("deep.nc", "O<deep> sub\nG4 P0.2\n(MSG, in deep)\nO<deep> endsub\n")
        self.write("called.nc", "O<called> sub\n(MSG, in called)\nO<deep> call\nO<called> endsub\n")
        self.write("unused.nc", "O<unused> sub\n(MSG, never)\nO<unused> endsub\n")
        program = self.write("part.nc", "#include \"unused.nc\"\nG1 X1 F600\nO<called> call\n(MSG, in part)\nM30\n")
        log = self.simulated(MILL, program)
        simulated = stanok.simulate(MILL, program).events
        self.expect_told(log, simulated)
        self.assertEqual([(event.text, event.file) for event in simulated],
                         [("in called", "called.nc"), ("in deep", "deep.nc"), ("in part", "part.nc")])

    def test_events_of_channels_name_the_programs_of_these(self):
        # Each ends before or after the first state of its run, which comes 50 ms after the start.
        one = self.write("one.nc", "(MSG, from one)\nG4 P0.3\nM30\n")
        two = self.write("two.nc", "G4 P0.2\n(MSG, from two)\nM30\n")
        log, machine = self.folder / "run.lcm", MACHINES / "millturn4.toml"
        programs = dict(zip(stanok.load_machine(machine).channels, (one, two)))
        command("simulate", "--machine", machine, "--log", log,
                *(word for channel, program in programs.items() for word in ("--run", f"{channel}={program}")))
        simulated = stanok.simulate(machine, programs).events
        self.expect_told(log, simulated)
        self.assertEqual({(event.text, event.file) for event in simulated},
                         {("from one", "one.nc"), ("from two", "two.nc")})

    def test_a_damaged_log_is_read_as_far_as_it_can_be(self):
        log = self.simulated()
        content = bytearray(log.read_bytes())
        content[1_000_000:1_000_100] = bytes(100)
        del content[-1000:]
        log.write_bytes(content)
        opened = stanok.open_log(log)
        self.assertFalse(opened.is_sound)
        self.assertTrue(opened.is_cut)
        expect_export(self, opened.setpoints(), self.exported(log))

    def test_what_is_no_log_is_an_error(self):
        text = self.write("text.lcm", "this is no log\n" * 100)
        empty = self.write("empty.lcm", "")
        for path in (text, empty):
            with self.assertRaises((stanok.LogError, ValueError)):
                stanok.read_log(path)
        for path in (self.folder / "none.lcm", self.folder):
            with self.assertRaises(stanok.LogError) as caught:
                stanok.open_log(path)
            self.assertIn(str(path), str(caught.exception))
        log = self.simulated()
        for arguments in (dict(channel=9), dict(columns=["no"]), dict(chunk=0), dict(chunk=-1), dict(chunk=2**70),
                          dict(columns=[], chunk=5), dict(channel="x")):
            with self.assertRaises((ValueError, TypeError, OverflowError)):
                list(stanok.read_log(log, **arguments))

    def test_random_bytes_end_nothing(self):
        log = self.simulated(MILL, self.write("part.nc", "G1 X1 F600\nM30\n"))
        content = np.frombuffer(log.read_bytes(), dtype=np.uint8)
        random = np.random.default_rng(20260727)
        for _ in range(60):
            damaged = content.copy()
            places = random.integers(0, len(damaged), 200)
            damaged[places] = random.integers(0, 256, 200)
            log.write_bytes(damaged.tobytes())
            try:
                list(stanok.read_log(log, chunk=500))
                list(stanok.open_log(log).events())
            except (stanok.LogError, ValueError):
                pass

    def expect_bounded(self, bytes_min):
        """A log of at least so many bytes is read in chunks with 96 MiB, and cannot be read at once with them."""
        piece = self.simulated()
        rows = stanok.read_log(piece, columns=["cycle"]).rows
        log, copies = self.folder / "long.lcm", 0
        with open(log, "wb") as stream:
            while stream.tell() < bytes_min:
                with open(piece, "rb") as source:
                    shutil.copyfileobj(source, stream, 1 << 20)
                copies += 1
        more = 96 << 20
        ended = read_bounded(log, 20_000, more)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        count, top, last = ended.stdout.split()
        self.assertEqual(int(count), copies * rows)
        self.assertEqual(int(last), rows)
        self.assertGreater(float(top), 0.0)
        at_once = read_bounded(log, 0, more)
        self.assertIn("MemoryError", at_once.stderr)
        return copies * rows

    def test_a_long_log_is_read_in_bounded_memory(self):
        self.expect_bounded(200 << 20)


class VeryLongLog(Logs):
    """Of as many bytes as the command line says."""

    bytes_min = 0

    def test_a_long_log_is_read_in_bounded_memory(self):
        rows = self.expect_bounded(self.bytes_min)
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(f"{self.bytes_min} bytes, {rows} rows: {usage.ru_utime:.0f} s, at most {usage.ru_maxrss >> 10} MiB")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--bytes":
        VeryLongLog.bytes_min = int(sys.argv[2])
        unittest.main(argv=[sys.argv[0], "VeryLongLog.test_a_long_log_is_read_in_bounded_memory"])
    unittest.main(defaultTest="Logs")
