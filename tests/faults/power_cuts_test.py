#!/usr/bin/env python3
"""The power fails behind answered changes: what was answered is there.

Changes of tools, offsets, queue and programs at random, by two clients; then the daemon is killed at a random moment,
and its folder is built anew from what was synchronised by then (power_cuts.cc). Every second time, what was written and
not synchronised is there as well, for some of the files.

usage: power_cuts_test.py STANOKD MACHINE_FILE SHIM [CUTS]
"""
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, Refused, patient_machine, wait_for_socket  # noqa: E402

STANOKD, MACHINE, SHIM = sys.argv[1:4]
CUTS = int(sys.argv[4]) if len(sys.argv) > 4 else 12
SEED = int(os.environ.get("STANOK_SEED", "53"))


def plausible(value):
    """Hundredths of a millimetre, up to 400 mm and back: tools have a longest length, changes a largest size."""
    longest = 40000
    way = value % (2 * longest)
    return min(way, 2 * longest - way) / 100


class Disk:
    """The image that the shim keeps, and the folder that comes of it."""

    def __init__(self, folder):
        self.folder = folder

    def text(self, key):
        try:
            with open(os.path.join(self.folder, key), "rb") as file:
                return file.read()
        except FileNotFoundError:
            return b""

    def build(self, key, source, target, keeps_more):
        """What is in `source` now is what stands there without having been synchronised."""
        os.mkdir(target)
        for line in self.text(key).decode().splitlines():
            entry, kind, name = line.split(" ", 2)
            if kind == "d":
                self.build(entry, os.path.join(source, name), os.path.join(target, name), keeps_more)
                continue
            text = self.text(entry)
            now = os.path.join(source, name)
            if keeps_more() and os.path.isfile(now):
                with open(now, "rb") as file:
                    text = file.read()
            with open(os.path.join(target, name), "wb") as file:
                file.write(text)


class Ledger:
    """What was answered, and what may be true beside it."""

    def __init__(self):
        self.lock = threading.Lock()
        self.values = {}  # answered, by name
        self.asked = {}  # the last one that was asked for
        self.ids = set()

    def may_be(self, name):
        return {self.values.get(name), self.asked.get(name)}


class PowerCuts(unittest.TestCase):
    def setUp(self):
        self.chance = random.Random(SEED)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.machine = patient_machine(MACHINE, self.folder)
        self.root = os.path.join(self.folder, "root0")
        os.makedirs(os.path.join(self.root, "programs"))

    def start(self, cut):
        disk = os.path.join(self.folder, f"disk{cut}")
        os.mkdir(disk)
        self.socket = os.path.join(self.folder, "op.sock")
        # Sanitizers want to be the first library of a process.
        preload = ":".join(part for part in (os.environ.get("LD_PRELOAD", ""), SHIM) if part)
        environment = dict(os.environ, LD_PRELOAD=preload, POWER_ROOT=self.root, POWER_DISK=disk,
                           ASAN_OPTIONS="verify_asan_link_order=0:detect_leaks=0")
        process = subprocess.Popen([STANOKD, "--machine", self.machine, "--drives", "embedded", "--lcm", "off", "--state",
                                    os.path.join(self.root, "state"), "--socket", self.socket, "--program-root",
                                    os.path.join(self.root, "programs")], env=environment, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        wait_for_socket(process, self.socket)
        return process, Disk(disk)

    def change(self, operator, ledger, client, value):
        """One of the kinds of changes; each client has names of its own."""
        kind, shown = self.chance.randrange(4), plausible(value)
        name, ask = {
            0: (f"length of T{client}", lambda: operator.ask("tool.set", number=client, key="length", value=shown)),
            1: (f"G5{3 + client} X", lambda: operator.ask("offset.set", offset=f"G5{3 + client}", axis="X", value=shown)),
            2: (f"p{value}-{client}.nc", lambda: operator.ask("program.write", program=f"p{value}-{client}.nc",
                                                              text=f"G1 X{value} F9\n")),
            3: (f"queue {client}", lambda: operator.ask("queue.add", program=f"{client}-{value}.nc", channel=1)),
        }[kind]
        value = value if kind > 1 else shown
        with ledger.lock:
            ledger.asked[name] = value
        answer = ask()
        with ledger.lock:
            ledger.values[name] = value
            if kind == 3:
                new = answer["queues"][0]["programs"]
                ledger.ids |= {entry["id"] for entry in new}

    def work(self, ledger, client, values):
        try:
            operator = Operator(self.socket)
            for value in values:
                self.change(operator, ledger, client, value)
        except (OSError, ConnectionError, ValueError):
            pass  # the power has failed

    def find(self, ledger, name, value):
        """It may be this; from here on it is: of a change without an answer either may have come."""
        self.assertIn(value, ledger.may_be(name), name)
        ledger.values[name] = ledger.asked[name] = value

    def check(self, operator, ledger):
        lengths = {tool["number"]: tool["length"] for tool in operator.ask("tool.list")["tools"]}
        offsets = operator.ask("offset.list")["offsets"]
        queue = operator.ask("queue.list", channel=1)["queues"][0]["programs"]
        for name in ledger.asked:
            known = ledger.may_be(name)
            if name.startswith("length"):
                self.find(ledger, name, lengths.get(int(name[-1])))
            elif name.startswith("G5"):
                self.find(ledger, name, offsets.get(name[:3], {}).get("X"))
            elif name.startswith("queue"):
                mine = [int(entry["program"].split("-")[1].split(".")[0]) for entry in queue
                        if entry["program"].startswith(name[-1])]
                if ledger.values.get(name) is not None:
                    self.assertIn(ledger.values[name], mine, name)
            elif ledger.values.get(name) is not None:
                with open(os.path.join(self.root, "programs", name), encoding="utf-8") as file:
                    self.assertIn(file.read(), {f"G1 X{value} F9\n" for value in known}, name)
        for entry in queue:
            operator.ask("queue.remove", id=entry["id"], channel=1)
        return {entry["id"] for entry in queue}

    def test_what_was_answered_is_there(self):
        ledger, value, answered = Ledger(), 0, 0
        for cut in range(CUTS + 1):
            process, disk = self.start(cut)
            try:
                operator = Operator(self.socket)
                self.check(operator, ledger)
                given = ledger.ids
                operator.close()
                if cut == CUTS:
                    break
                # What is true now is what counts from here on.
                ledger, before = Ledger(), ledger
                ledger.ids = set()
                clients = [threading.Thread(target=self.work, args=(ledger, client, range(value + 1, value + 400)))
                           for client in (1, 2)]
                for client in clients:
                    client.start()
                most = self.chance.randrange(1, 40)
                while len(ledger.values) == 0 or (most := most - 1) > 0:
                    self.assertTrue(any(client.is_alive() for client in clients), "no client asks for anything")
                    time.sleep(0.005)
            finally:
                process.kill()
                process.wait()
            for client in clients:
                client.join()
            value += 400
            answered += len(ledger.values)
            self.assertFalse(given & ledger.ids, "an id was given twice")
            ledger.ids |= given
            self.merge(before, ledger)
            self.rebuild(disk, cut)
        print(f"{CUTS} cuts, {answered} names with answered changes behind them, none lost")

    @staticmethod
    def merge(before, ledger):
        for name, known in before.values.items():
            if not name.startswith("queue"):
                ledger.values.setdefault(name, known)
                ledger.asked.setdefault(name, before.asked[name])

    def rebuild(self, disk, cut):
        """The folder as the disk has it."""
        status = subprocess.run(["stat", "-c", "%i", self.root], check=True, capture_output=True, text=True)
        key = next(name for name in os.listdir(disk.folder)
                   if name.startswith(status.stdout.strip() + ".") and not name.endswith(".new"))
        target = os.path.join(self.folder, f"root{cut + 1}")
        keeps_more = (lambda: self.chance.random() < 0.5) if cut % 2 else (lambda: False)
        disk.build(key, self.root, target, keeps_more)
        shutil.rmtree(self.root)
        shutil.rmtree(disk.folder)
        self.root = target


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
