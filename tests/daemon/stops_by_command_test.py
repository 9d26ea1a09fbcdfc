#!/usr/bin/env python3
"""Stops by the command line against a daemon that has no place, no descriptor, no time, or stands still.

usage: stops_by_command_test.py STANOKD STANOK MACHINE_FILE
"""
import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, allow_many_descriptors, connect, request, running_daemon  # noqa: E402

STANOKD, STANOK, MACHINE = sys.argv[1:4]
PROGRAM = "G21 G90 F1000\nwhile (true) {\nG1 X100\nX0\n}\n"
PLACES = 64


class Stopped(unittest.TestCase):
    """A program runs; whatever else is the matter with the daemon, each stop of the command line is obeyed."""

    def start(self, **options):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.daemon = stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM, **options))
        self.operator = Operator(self.daemon.socket_path)
        self.run_program()

    def run_program(self):
        self.operator.ask("machine.on")
        self.operator.ask("program.run", program="part.nc")
        self.wait_for(lambda: self.status()["speed_mm_s"] > 10.0)

    def status(self):
        return self.operator.ask("channel.status")

    def wait_for(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "it does not come about")
            time.sleep(0.02)

    def stanok(self, *arguments):
        return subprocess.run([STANOK, *arguments, "--socket", self.daemon.socket_path], capture_output=True,
                              text=True, check=False, timeout=60)

    def obeys(self, *arguments):
        ended = self.stanok(*arguments)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.wait_for(lambda: self.status()["program_status"] != "Running" and self.status()["speed_mm_s"] == 0.0)

    def obeys_holds(self):
        self.obeys("program", "hold")
        self.operator.ask("program.resume")
        self.obeys("program", "hold", "--all")
        self.operator.ask("program.resume")

    def test_all_places_are_taken(self):
        self.start()
        idle = [connect(self.daemon.socket_path) for _ in range(PLACES + 5)]
        self.addCleanup(lambda: [one.close() for one in idle])
        refused = self.stanok("machine", "status")
        self.assertEqual(refused.returncode, 3, refused.stderr)
        self.obeys_holds()
        self.obeys("program", "stop")
        for command in ("program reset", "machine off", "machine estop"):
            self.operator.ask("program.reset")
            self.run_program()
            self.obeys(*command.split())

    def test_no_descriptor_is_left(self):
        idle = []
        self.addCleanup(lambda: [one.close() for one in idle])
        self.start(descriptors=60)
        for _ in range(PLACES):
            idle.append(connect(self.daemon.socket_path))
        self.assertLess(sum(self.is_greeted(one) for one in idle), 50)
        self.obeys_holds()
        self.obeys("machine", "estop")

    @staticmethod
    def is_greeted(connection):
        connection.settimeout(0.2)
        try:
            return b'"hello"' in connection.recv(4096)
        except TimeoutError:
            return False

    def test_others_flood_it(self):
        self.start()
        floods = threading.Event()

        def flood():
            with contextlib.suppress(OSError):
                one = connect(self.daemon.socket_path)
                self.addCleanup(one.close)
                one.setblocking(False)
                lines = b"".join(request(n, "rpc.discover") for n in range(100))
                while not floods.is_set():
                    with contextlib.suppress(BlockingIOError):
                        one.send(lines)
                    time.sleep(0.001)

        threads = [threading.Thread(target=flood, daemon=True) for _ in range(8)]
        for thread in threads:
            thread.start()
        for command in ("program hold", "program reset", "machine estop"):
            ended = self.stanok(*command.split())
            self.assertEqual(ended.returncode, 0, ended.stderr)
        floods.set()
        for thread in threads:
            thread.join()
        self.wait_for(lambda: self.status()["speed_mm_s"] == 0.0)

    def test_a_daemon_that_stands_still_is_told_of(self):
        self.start()
        os.kill(self.daemon.process.pid, signal.SIGSTOP)
        try:
            with subprocess.Popen([STANOK, "machine", "estop", "--timeout", "3", "--socket", self.daemon.socket_path],
                                  stderr=subprocess.PIPE, text=True) as stop:
                self.assertIn("use the emergency stop of the machine", stop.stderr.readline())
                self.assertIsNone(stop.poll(), "it waits on")
                self.assertIn("E9016", stop.stderr.read())
        finally:
            os.kill(self.daemon.process.pid, signal.SIGCONT)
        self.wait_for(lambda: self.status()["speed_mm_s"] == 0.0)


if __name__ == "__main__":
    allow_many_descriptors()
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
