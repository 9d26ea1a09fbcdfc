#!/usr/bin/env python3
"""What happened on a machine is known after its daemon was killed: runs with their times and how they ended, where one
was cut off, what operators did; and no number is given twice.

usage: journal_test.py STANOKD MACHINE_FILE
"""
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, patient_machine, wait_for_socket  # noqa: E402

STANOKD, MACHINE = sys.argv[1:]
KILLS = 5
LONG = "G21 G90 G94 G54 F600\n" + "".join(f"G1 X{k % 7}\n" for k in range(1, 2000)) + "M2\n"
SHORT = "G21 G90 G94 F3000\nG1 X1\nM2\n"
WRONG = "G21 G90 G94 F3000\nG1 X1\n#1 = 1/#2\nG1 X#1\nM2\n"


def until(condition):
    """Its first value that is one."""
    while not (value := condition()):
        time.sleep(0.02)
    return value


def record_of(line):
    """Nothing: it is damaged, or being written."""
    with contextlib.suppress(ValueError):
        return json.loads(line.partition(" ")[2])


class Place:
    """A folder in which a daemon is started again and again."""

    def __init__(self, folder):
        self.folder = folder
        self.machine = patient_machine(MACHINE, folder)
        for name, text in (("long.nc", LONG), ("short.nc", SHORT), ("wrong.nc", WRONG)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as program:
                program.write(text)

    @contextlib.contextmanager
    def daemon(self):
        """An operator, and what ends the daemon: killed at the end of the block unless it has ended by then."""
        socket = os.path.join(self.folder, "op.sock")
        process = subprocess.Popen([STANOKD, "--machine", self.machine, "--drives", "embedded", "--lcm", "off", "--state",
                                    os.path.join(self.folder, "state"), "--socket", socket, "--program-root",
                                    self.folder], stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        try:
            wait_for_socket(process, socket)
            operator = Operator(socket)
            yield operator, process
            operator.close()
        finally:
            if process.poll() is None:
                process.kill()
            process.wait()

    def records(self):
        """Of the journal, as they are on the disk."""
        with open(os.path.join(self.folder, "state", "journal.jsonl"), encoding="utf-8") as file:
            return list(filter(None, map(record_of, file)))


class Journal(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = Place(folder.name)

    def begin(self, operator, program):
        operator.ask("machine.on")
        until(lambda: operator.ask("machine.status")["on"])
        operator.ask("program.run", program=program, channel=1)

    def is_on_disk(self, kind, **members):
        return any(record["kind"] == kind and all(record.get(name) == value for name, value in members.items())
                   for record in self.place.records())

    def cut_off(self, operator, number):
        """A long program begins and comes to a line that the disk knows of; the line."""
        self.begin(operator, "long.nc")
        return until(lambda: max((record["line"] for record in self.place.records()
                                  if record["kind"] == "place" and record["number"] == number), default=0) > 3)

    def test_a_killed_daemon_says_where_it_was(self):
        with self.place.daemon() as (operator, _):
            for number in range(1, KILLS):
                self.begin(operator, "short.nc")
                until(lambda: self.is_on_disk("run_ended", number=number))
        ids = []
        for kill in range(KILLS):
            number = KILLS + kill
            begun = time.time()
            with self.place.daemon() as (operator, process):
                self.cut_off(operator, number)
                ids.append(operator.ask("queue.add", program="short.nc", channel=1)["queues"][0]["programs"][-1]["id"])
                process.kill()
                process.wait()
                killed = time.time()
            with self.place.daemon() as (operator, _):
                last = max(record["line"] for record in self.place.records()
                           if record["kind"] == "place" and record["number"] == number)
                alarm = operator.ask("alarm.list", channel=1)["alarms"][-1]
                self.assertEqual((alarm["code"], alarm["file"], alarm["line"]), ("W941", "long.nc", last))
                self.assertIn(f"long.nc:{last}", alarm["text"])
                self.assertGreaterEqual(alarm["at"], killed - 1)
                run = operator.ask("program.history", channel=1)["runs"][-1]
                self.assertEqual((run["number"], run["program"], run["ended"], run["ok"], run["end"]),
                                 (number, "long.nc", True, False, "cut_off"))
                self.assertTrue(begun - 1 <= run["begun_at"] <= run["ended_at"] <= killed + 1, run)
                operator.ask("alarm.ack", channel=1)
                self.assertEqual(operator.ask("alarm.list", channel=1)["alarms"], [])
                until(lambda: sum(record["kind"] == "seen" for record in self.place.records()) == kill + 1)
            with self.place.daemon() as (operator, _):
                self.assertEqual(operator.ask("alarm.list", channel=1)["alarms"], [], "it was seen")
        self.assertEqual(len(set(ids)), KILLS, "no id is given twice")
        self.assertEqual(ids, sorted(ids))

    def test_an_orderly_end_leaves_no_alarm(self):
        with self.place.daemon() as (operator, process):
            self.cut_off(operator, 1)
            process.terminate()
            process.wait()
        with self.place.daemon() as (operator, _):
            self.assertEqual(operator.ask("alarm.list", channel=1)["alarms"], [])
            run = operator.ask("program.history", channel=1)["runs"][-1]
            self.assertEqual((run["ended"], run["ok"], run["end"]), (True, False, "stopped"))

    def test_says_how_runs_ended_and_who_did_what(self):
        with self.place.daemon() as (operator, _):
            for number, program in enumerate(("short.nc", "wrong.nc"), 1):
                self.begin(operator, program)
                until(lambda: self.is_on_disk("run_ended", number=number))
                operator.ask("program.reset", channel=1)
            self.cut_off(operator, 3)
            operator.ask("machine.estop")
            until(lambda: self.is_on_disk("run_ended", number=3))
            self.assertEqual([run["end"] for run in operator.ask("program.history", channel=1)["runs"]],
                             ["done", "alarm", "estop"])
            until(lambda: self.is_on_disk("action", method="machine.estop"))
        with self.place.daemon() as (operator, _):
            runs = operator.ask("program.history", channel=1)["runs"]
            self.assertEqual([run["end"] for run in runs], ["done", "alarm", "estop"])
            told = operator.ask("machine.journal")
            self.assertIsNone(told["error"])
            methods = [record.get("method", record["kind"]) for record in told["records"]]
            self.assertEqual(methods.count("start"), 2)
            for method in ("machine.on", "program.run", "program.reset", "machine.estop"):
                self.assertIn(method, methods)
            self.assertTrue(all(record["at"] > 1.7e9 for record in told["records"]))
            old = operator.ask("alarm.history", channel=1)["alarms"]
            self.assertEqual(operator.ask("alarm.list", channel=1)["alarms"], [])
            self.begin(operator, "wrong.nc")
            until(lambda: operator.ask("alarm.list", channel=1)["alarms"])
            new = operator.ask("alarm.history", channel=1)["alarms"][-1]
            self.assertEqual(new["number"], old[-1]["number"] + 1)

    def test_what_is_damaged_costs_itself_alone(self):
        with self.place.daemon() as (operator, _):
            self.begin(operator, "short.nc")
            until(lambda: self.is_on_disk("run_ended", number=1))
        with open(os.path.join(self.place.folder, "state", "journal.jsonl"), "ab") as file:
            file.write(b"0123456789abcdef {\"kind\":\"run_be")
        with self.place.daemon() as (operator, _):
            self.assertEqual(operator.ask("program.history", channel=1)["runs"][-1]["end"], "done")
            self.begin(operator, "short.nc")
            until(lambda: self.is_on_disk("run_ended", number=2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
