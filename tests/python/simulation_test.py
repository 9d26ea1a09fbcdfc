#!/usr/bin/env python3
"""stanok.simulate against `stanok simulate` and `stanok log export`: the same bits, the same words."""
import json
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
import stanok
from surroundings import EXAMPLES, MACHINES, InFolder, columns_of_csv, same_bits
from surroundings import stanok as command

MILL = MACHINES / "mill3.toml"
ENDLESS = "while (true) { G1 X10 F6000\nX0\n}\nM30\n"
TYPES = {"cycle": int, "seq": int, "state": int, "flags": int, "run": int, "file": int, "line": int, "block": int,
         "scheme": int}


def heading_of(setpoints, column):
    """Headings of the CSV of `stanok log export` for a column: docs/reference/messages.md."""
    units = {"feed_commanded": "_mm_per_s", "path_speed": "_mm_per_s"}
    if setpoints[column].ndim == 1:
        return [column + units.get(column, "")]
    headings = []
    for axis, word, unit in zip(setpoints.axes, setpoints.words, setpoints.units):
        headings.append({"tip_position": f"tip_{word}_{unit}",
                         "tip_velocity": f"tip_velocity_{word}_{unit}_per_s",
                         "position": f"{axis}_{unit}",
                         "velocity": f"{axis}_velocity_{unit}_per_s",
                         "acceleration": f"{axis}_acceleration_{unit}_per_s2",
                         "jerk": f"{axis}_jerk_{unit}_per_s3",
                         "position_code": f"{axis}_position_code",
                         "velocity_code": f"{axis}_velocity_code"}[column])
    return headings


def expect_export(test, setpoints, exported, columns=stanok.ALL_COLUMNS):
    """Every column has the bits of the texts of the CSV."""
    for column in columns:
        array = setpoints[column]
        matrix = array.reshape(array.shape[0], -1)
        for k, heading in enumerate(heading_of(setpoints, column)):
            expected = np.array([float(text) if array.dtype.kind == "f" else int(text)
                                 for text in exported[heading]], dtype=array.dtype)
            test.assertTrue(same_bits(np.ascontiguousarray(matrix[:, k]), expected), heading)


class Simulate(InFolder):
    def test_arrays_have_the_bits_of_log_export(self):
        for machine, program in (("mill3", "helix.nc"), ("trunnion", "trunnion.nc")):
            with self.subTest(machine):
                log, table = self.folder / f"{machine}.lcm", self.folder / f"{machine}.csv"
                given = MACHINES / f"{machine}.toml"
                until = 8.0
                command("simulate", EXAMPLES / program, "--machine", given, "--log", log, "--until", until, code=4)
                command("log", "export", log, "--csv", table)
                result = stanok.simulate(given, EXAMPLES / program, columns="all", until_s=until)
                self.assertTrue(result.until_reached)
                exported = columns_of_csv(table)
                self.assertEqual(result[1].rows, len(exported["cycle"]))
                self.assertGreater(float(np.ptp(result[1].position, axis=0).max()), 1.0)
                expect_export(self, result[1], exported)

    def test_two_simulations_are_equal_bit_for_bit(self):
        job = EXAMPLES / "helix.nc"
        machine = stanok.load_machine(MILL)
        first, second = (stanok.simulate(machine, job, columns="all") for _ in range(2))
        for column in stanok.ALL_COLUMNS:
            self.assertTrue(same_bits(first[1][column], second[1][column]), column)
        self.assertEqual(first.events, second.events)
        self.assertEqual(first.runs, second.runs)

    def test_figures_are_those_of_the_command(self):
        told = json.loads(command("simulate", EXAMPLES / "helix.nc", "--machine", MILL, "--json"))
        result = stanok.simulate(MILL, EXAMPLES / "helix.nc")
        self.assertEqual(result.cycles, told["cycles"])
        self.assertEqual(result.machine_time_s, told["machine_time_s"])
        run, expected = result.runs[0], told["channels"][0]["runs"][0]
        for name in ("program", "ok", "blocks", "time_s", "path_mm", "end", "end_axes"):
            self.assertEqual(getattr(run, name), expected[name], name)

    def test_shapes_and_what_was_not_kept(self):
        result = stanok.simulate(MILL, EXAMPLES / "helix.nc")
        setpoints = result[1]
        self.assertEqual(tuple(setpoints), stanok.USUAL_COLUMNS)
        self.assertEqual(setpoints.position.shape, (result.cycles, 3))
        self.assertEqual(setpoints.line.dtype, np.int32)
        self.assertEqual(setpoints.axis("Z"), 2)
        with self.assertRaisesRegex(KeyError, "was not kept"):
            setpoints.jerk
        some = stanok.simulate(MILL, EXAMPLES / "helix.nc", columns=["cycle"], every=100)[1]
        self.assertTrue(np.all(np.diff(some.cycle) == 100))

    def test_events_of_an_operator_are_those_of_the_command(self):
        program = self.write("part.nc", "G1 X10 F600\nX0\nM30\n")
        events = [{"cycle": 400, "method": "override.feed", "params": {"percent": 50}},
                  {"cycle": 200, "method": "override.feed", "params": {"percent": 120}}]
        given = self.write("events.jsonl", "".join(json.dumps(event) + "\n" for event in events))
        told = json.loads(command("simulate", program, "--machine", MILL, "--events", given, "--json"))
        result = stanok.simulate(MILL, program, columns="all", events=events)
        self.assertEqual(result.cycles, told["cycles"])
        self.assertEqual(sorted(set(result[1].feed_override)), [0.5, 1.0, 1.2])
        typed = [stanok.OperatorEvent(event["cycle"], event["method"], event["params"]) for event in events]
        again = stanok.simulate(MILL, program, columns="all", events=typed)
        self.assertTrue(same_bits(again[1].position, result[1].position))

    def test_messages_of_the_program_are_events(self):
        program = self.write("part.nc", "G1 X1 F600\n(MSG, half way)\nX2\nM30\n")
        texts = [(event.text, event.line, event.file) for event in stanok.simulate(MILL, program).events]
        self.assertIn(("half way", 2, "part.nc"), texts)

    def test_a_log_is_that_of_the_command(self):
        ours, theirs = self.folder / "ours.lcm", self.folder / "theirs.lcm"
        command("simulate", EXAMPLES / "helix.nc", "--machine", MILL, "--log", theirs)
        stanok.simulate(MILL, EXAMPLES / "helix.nc", log=ours)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())
        with self.assertRaisesRegex(RuntimeError, "nowhere"):
            stanok.simulate(MILL, EXAMPLES / "helix.nc", log=self.folder / "nowhere" / "run.lcm")

    def test_an_array_outlives_its_simulation(self):
        position = stanok.simulate(MILL, EXAMPLES / "helix.nc")[1].position
        kept = position.copy()
        for _ in range(3):
            stanok.simulate(MILL, EXAMPLES / "helix.nc")
        self.assertTrue(same_bits(position, kept))
        position[0, 0] = 1.0  # it belongs to the caller


class Faults(InFolder):
    def test_a_program_error_has_code_place_and_remedy(self):
        program = self.write("wrong.nc", "G1 X1 F100\nG1 Xsomething\nM30\n")
        told = json.loads(command("check", program, "--machine", MILL, "--json", code=6))[0]
        with self.assertRaises(stanok.ProgramError) as caught:
            stanok.simulate(MILL, program)
        error = caught.exception
        self.assertEqual((error.code, error.line, error.column), (told["code"], told["line"], told["column"]))
        self.assertEqual(error.file, "wrong.nc")
        self.assertTrue(error.remedy)
        self.assertIn("wrong.nc:2", str(error))

    def test_an_alarm_of_a_run_keeps_what_there_is(self):
        program = self.write("far.nc", "G1 X10 F600\nX1e5\nM30\n")
        with self.assertRaises(stanok.RunError) as caught:
            stanok.simulate(MILL, program)
        error = caught.exception
        self.assertEqual((error.line, error.file), (2, "far.nc"))
        self.assertTrue(error.code)
        self.assertGreater(error.result[1].rows, 0)
        unchecked = stanok.simulate(MILL, program, check=False)
        self.assertFalse(unchecked.ok)
        self.assertEqual([fault.code for fault in unchecked.alarms], [fault.code for fault in error.result.alarms])

    def test_a_machine_file_tells_all_its_faults(self):
        text = MILL.read_text(encoding="utf-8")
        path = self.write("machine.toml", text.replace("[machine]", "[machine]\nnonsense = 1\nspeed = 2", 1))
        with self.assertRaises(stanok.MachineFileError) as caught:
            stanok.load_machine(path)
        self.assertEqual(len(caught.exception.faults), 2)
        self.assertEqual(caught.exception.file, str(path))
        self.assertGreater(caught.exception.line, 0)
        self.assertTrue(caught.exception.remedy)

    def test_wrong_arguments_are_value_errors_and_nothing_ends_the_interpreter(self):
        helix = EXAMPLES / "helix.nc"
        wrong = [dict(channel=9), dict(channel=-1), dict(schemes={1: 99}), dict(columns=["nothing"]), dict(every=0),
                 dict(columns="some"), dict(until_s=-1.0), dict(until_s=float("nan")), dict(until_s=float("inf")),
                 dict(drives="none"),
                 dict(events=[{"cycle": 1}]), dict(events=[{"method": "nothing", "cycle": 1}]),
                 dict(events=[{"method": "override.feed", "cycle": "x", "params": {"percent": 1}}]),
                 dict(events=[{"method": "override.feed", "cycle": 1, "params": {"percent": 1e9}}]),
                 dict(sensors=self.folder / "none.csv"), dict(sensors=helix), dict(schemes={7: 1}),
                 dict(channel=2**40), dict(every=2**70), dict(columns=[3]), dict(events=[3])]
        for arguments in wrong:
            with self.subTest(str(arguments)):
                with self.assertRaises((ValueError, TypeError, RuntimeError, OverflowError, stanok.StanokError)):
                    stanok.simulate(MILL, helix, **arguments)
        for program in ("", ".", "x" * 5000, "a\0b", self.folder, "..", {}, {1: []}, 7, None):
            with self.subTest(str(program)[:10]):
                with self.assertRaises((ValueError, TypeError, AttributeError, stanok.StanokError)):
                    stanok.simulate(MILL, program)
        for machine in ("", self.folder, "a\0b", helix, 7, None):
            with self.subTest(str(machine)[:10]):
                with self.assertRaises((ValueError, TypeError, stanok.StanokError)):
                    stanok.simulate(machine, helix)

    def test_machine_files_of_any_bytes_end_nothing(self):
        text = np.frombuffer((MACHINES / "trunnion.toml").read_bytes(), dtype=np.uint8)
        random = np.random.default_rng(20260729)
        for number in range(150):
            damaged = text.copy()
            damaged[random.integers(0, len(text), 3)] = random.integers(0, 256, 3)
            path = self.folder / "machine.toml"
            path.write_bytes(damaged.tobytes())
            try:
                machine = stanok.load_machine(path)
                stanok.simulate(machine, EXAMPLES / "helix.nc", until_s=0.2, check=False)
            except (stanok.StanokError, ValueError) as error:
                self.assertTrue(str(error), number)

    def test_texts_of_any_bytes_end_nothing(self):
        seed = 20260726
        random = np.random.default_rng(seed)
        words = [b"G1 ", b"X", b"Y1", b"\n", b"(", b")", b"{", b"}", b"#", b"if", b"=", b"%", b"\xff", b"\x00",
                 b"F1e9 ", b"M98 P1", b"G41", b"\"", b"1e400", b"-", b"O100\n", b"while (1)"]
        for number in range(150):
            text = b"".join(words[k] for k in random.integers(0, len(words), 40))
            path = self.folder / "any.nc"
            path.write_bytes(text)
            try:
                stanok.simulate(MILL, path, until_s=0.5)
            except stanok.StanokError as error:
                self.assertTrue(error.faults, f"seed {seed}, number {number}: {text!r}")


class LongCalls(InFolder):
    def test_other_threads_go_on(self):
        program = self.write("endless.nc", ENDLESS)
        ended = threading.Event()
        thread = threading.Thread(target=lambda: (stanok.simulate(MILL, program, until_s=600.0, columns=["line"]),
                                                  ended.set()))
        thread.start()
        steps = 0
        while not ended.is_set():
            steps += 1
            time.sleep(0)
        thread.join()
        # With the lock held by the simulation this thread would have come a few times at most.
        self.assertGreater(steps, 1000)

    def in_another_interpreter(self, script, *arguments):
        """A script that may end its interpreter; what it says, and its exit code."""
        return subprocess.run([sys.executable, "-c", script, *map(str, arguments)], capture_output=True, text=True,
                              check=False, timeout=120, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})

    def test_the_interpreter_ends_while_a_thread_simulates(self):
        program = self.write("endless.nc", ENDLESS)
        ended = self.in_another_interpreter(
            "import stanok, sys, threading, time\n"
            "thread = threading.Thread(target=lambda: stanok.simulate(*sys.argv[1:], columns=['line'], every=10**6),\n"
            "                          daemon=True)\n"
            "thread.start()\n"
            "for _ in range(50): time.sleep(0.01)\n"
            "assert thread.is_alive()\n", MILL, program)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_where_memory_ends_an_exception_comes(self):
        program = self.write("endless.nc", ENDLESS)
        ended = self.in_another_interpreter(
            "import resource, stanok, sys\n"
            "status = open('/proc/self/status')\n"
            "now = next(int(line.split()[1]) << 10 for line in status if line.startswith('VmData'))\n"
            "resource.setrlimit(resource.RLIMIT_DATA, (now + (200 << 20),) * 2)\n"
            "try:\n"
            "    stanok.simulate(*sys.argv[1:], columns='all')\n"
            "except MemoryError:\n"
            "    print(stanok.simulate(*sys.argv[1:], until_s=1.0).until_reached)\n", MILL, program)
        self.assertEqual((ended.stdout, ended.returncode, ended.stderr), ("True\n", 0, ""))

    def test_two_threads_simulate_one_machine(self):
        machine = stanok.load_machine(MILL)
        results = [None, None]

        def run(place):
            results[place] = stanok.simulate(machine, EXAMPLES / "helix.nc")

        threads = [threading.Thread(target=run, args=(place,)) for place in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(same_bits(results[0][1].position, results[1][1].position))

    def test_ctrl_c_ends_a_simulation(self):
        computes = "num turns = 0;\nwhile (true) { turns = turns + 1; }\n"
        for text in (ENDLESS, computes):
            program = self.write("endless.nc", text)
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            try:
                with self.assertRaises(KeyboardInterrupt):
                    stanok.simulate(MILL, program, columns=["line"])
            finally:
                timer.cancel()
                timer.join()


if __name__ == "__main__":
    unittest.main()
