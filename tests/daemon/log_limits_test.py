#!/usr/bin/env python3
"""A daemon keeps its logs within the bounds of its machine file, and says so where the disk has no room for them.

usage: log_limits_test.py STANOKD STANOK MACHINE_FILE
"""
import os
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, Refused, patient_machine, wait_for_socket  # noqa: E402

MB = 1_000_000
DAY_S = 86_400


class Machine:
    """A daemon that logs from its start, with a [recorder] of the test's own."""

    def __init__(self, stanokd, machine_file, folder, recorder):
        self.logs = os.path.join(folder, "logs")
        os.makedirs(self.logs, exist_ok=True)
        self.socket_path = os.path.join(folder, "op.sock")
        self.machine_file = patient_machine(machine_file, folder)
        self.command = [stanokd, "--machine", self.machine_file, "--drives", "embedded", "--lcm", "off", "--state",
                        os.path.join(folder, "state"), "--socket", self.socket_path, "--program-root", folder,
                        "--log", self.logs]
        with open(self.machine_file, encoding="utf-8") as file:
            text = file.read()
        if "[recorder]" in text:
            sys.exit("FAILED: the machine file has a [recorder]")
        with open(self.machine_file, "a", encoding="utf-8") as file:
            file.write(f"\n[recorder]\n{recorder}\n")
        self.name = os.path.basename(machine_file).removesuffix(".toml")

    def write(self, name, size, age_days):
        """A sparse file."""
        path = os.path.join(self.logs, name)
        with open(path, "wb") as file:
            file.truncate(size)
        at = time.time() - age_days * DAY_S
        os.utime(path, (at, at))

    def __enter__(self):
        self.process = subprocess.Popen(self.command, stderr=subprocess.DEVNULL)
        wait_for_socket(self.process, self.socket_path)
        self.operator = Operator(self.socket_path)
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(60)


def expect(is_so, what):
    if not is_so:
        sys.exit(f"FAILED: {what}")


def wait_until(is_so, what):
    end = time.monotonic() + 120
    while time.monotonic() < end:
        if is_so():
            return
        time.sleep(0.1)
    sys.exit(f"FAILED: {what}")


def keeps_bounds(stanokd, machine_file):
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(stanokd, machine_file, folder, "logs_max_gb = 0.4\nlogs_max_days = 5\nfree_space_min_gb = 0")
        name = machine.name
        machine.write(f"{name}-20200101-000000.lcm", 300 * MB, 3)
        machine.write(f"{name}-20200102-000000.lcm", 150 * MB, 2)
        machine.write(f"{name}-flight-20200101-000000.lcm", 100 * MB, 4)
        machine.write(f"{name}-20190101-000000.lcm", 1, 6)
        others = ["first part.lcm", f"{name}-notes.lcm", f"{name}-20190101-000000.lcm.bak", "other-20190101-000000.lcm"]
        for other in others:
            machine.write(other, 900 * MB, 90)
        with machine:
            status = machine.operator.ask("log.status")
            kept = status["kept"]
            files = set(os.listdir(machine.logs))
            own = os.path.basename(status["file"]["path"])
            expect(own in files, "a log is written")
            left = {file for file in files if not file.endswith((".csv", ".jsonl", ".txt"))}
            expect(left == {own, f"{name}-20200102-000000.lcm", f"{name}-flight-20200101-000000.lcm", *others},
                   f"what is kept: {files}")
            expect(kept["bytes_max"] == 400 * MB and kept["hours_max"] == 120 and kept["free_bytes_min"] is None, kept)
            expect(kept["bytes"] <= 400 * MB, kept)
            machine.write(f"{name}-20200103-000000.lcm", 200 * MB, 1)
            wait_until(lambda: machine.operator.ask("log.status")["kept"]["bytes"] <= 400 * MB and
                       f"{name}-20200102-000000.lcm" not in os.listdir(machine.logs), "it goes on to look")
            expect(own in os.listdir(machine.logs), "the log that is written stays")


def rests_without_room(stanokd, stanok, machine_file):
    with tempfile.TemporaryDirectory() as folder:
        with Machine(stanokd, machine_file, folder, "free_space_min_gb = 1000000") as machine:
            status = machine.operator.ask("log.status")
            expect(status["file"]["rests"] and "free_space_min_gb" in status["file"]["error"], status)
            alarms = machine.operator.ask("alarm.list")["alarms"]
            expect([alarm["code"] for alarm in alarms] == ["E9026"], alarms)
            expect("logging is paused" in alarms[0]["text"], alarms)
            machine.operator.ask("machine.on")
            shown = subprocess.run([stanok, "--socket", machine.socket_path, "alarm", "list"], check=True,
                                   capture_output=True, text=True).stdout
            expect("E9026" in shown, shown)
            machine.operator.ask("alarm.ack")
            expect(machine.operator.ask("alarm.list")["alarms"] == [], "it is acknowledged")
            expect(not [file for file in os.listdir(machine.logs) if file.endswith(".lcm")], "nothing is written")
            machine.operator.ask("log.stop")
            expect(not machine.operator.ask("log.status")["file"]["rests"], "it has ended")
            try:
                machine.operator.ask("log.start")
                expect(False, "a log begins without room")
            except Refused as refused:
                expect("free_space_min_gb" in str(refused), refused)


def main():
    stanokd, stanok, machine_file = sys.argv[1:4]
    keeps_bounds(stanokd, machine_file)
    rests_without_room(stanokd, stanok, machine_file)


if __name__ == "__main__":
    main()
