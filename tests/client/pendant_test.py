#!/usr/bin/env python3
"""A wheel and keys move the axes of a real daemon: events of a device through a pipe.

usage: pendant_test.py STANOKD STANOK MACHINE_FILE
"""
import contextlib
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

STANOKD, STANOK, MACHINE = sys.argv[1:4]
PROGRAM = "G21 G90 F600\nG1 X100\nM30\n"
EV_SYN, EV_KEY, EV_REL, REL_DIAL = 0, 1, 2, 7
KEYS = ["--on", "256=Y", "--on", "257=step:0.1", "--on", "258=hold", "--on", "259=resume"]


def event(kind, code, value, age_s=0.0):
    """struct input_event of 64 bit."""
    at = time.time() - age_s
    return struct.pack("@qqHHi", int(at), int(at % 1 * 1e6), kind, code, value)


def notches(count, age_s=0.0):
    return event(EV_REL, REL_DIAL, count, age_s) + event(EV_SYN, 0, 0, age_s)


def press(code):
    return event(EV_KEY, code, 1) + event(EV_SYN, 0, 0) + event(EV_KEY, code, 0) + event(EV_SYN, 0, 0)


class Wheel(unittest.TestCase):
    def setUp(self):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.daemon = stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM))
        self.operator = Operator(self.daemon.socket_path)
        self.addCleanup(self.operator.close)
        self.operator.ask("machine.on")
        self.operator.ask("mdi", text="G4 P0.01", wait="done")  # when the drives hold their axes
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        self.device = os.path.join(folder, "event0")
        os.mkfifo(self.device)

    def start(self, *options):
        self.pendant = subprocess.Popen([STANOK, "pendant", self.device, "--socket", self.daemon.socket_path, *options],
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True)
        self.pipe = os.open(self.device, os.O_WRONLY)
        self.addCleanup(self.end)
        if "--show" not in options:
            self.assertIn("listening", self.pendant.stderr.readline())

    def end(self):
        if self.pendant.poll() is None:
            self.pendant.kill()
        self.pendant.communicate()

    def send(self, data):
        os.write(self.pipe, data)

    def at(self, axis="X"):
        return self.operator.ask("channel.status")["axes"][axis]["position"]

    def wait_for(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "it does not come about")
            time.sleep(0.02)

    def wait_at(self, place, axis="X"):
        self.wait_for(lambda: abs(self.at(axis) - place) < 1e-6)

    def test_it_moves_the_chosen_axis_by_the_chosen_step(self):
        self.start("--axis", "X", *KEYS)
        x, y = self.at(), self.at("Y")
        for _ in range(10):
            self.send(notches(1))
        self.wait_at(x + 0.1)
        self.send(press(256) + press(257))
        self.send(notches(7) + notches(-2))
        self.wait_at(y + 0.5, "Y")
        self.assertAlmostEqual(self.at(), x + 0.1, places=6)

    def test_an_event_in_pieces_is_one_event(self):
        self.start("--axis", "X")
        x = self.at()
        whole = notches(3)
        for k in range(0, len(whole), 5):
            self.send(whole[k:k + 5])
        self.wait_at(x + 0.03)

    def test_late_turns_move_nothing(self):
        self.start("--axis", "X")
        x = self.at()
        # Stopped while the wheel is turned: what it reads when it goes on is old by then.
        self.pendant.send_signal(signal.SIGSTOP)
        for _ in range(20):
            self.send(notches(1))
        time.sleep(1.0)
        self.pendant.send_signal(signal.SIGCONT)
        self.send(notches(1, age_s=5.0))
        self.assertIn("dropped", self.pendant.stderr.readline())
        self.send(notches(1))
        self.wait_at(x + 0.01)

    def test_it_holds_and_resumes_a_program(self):
        self.start("--axis", "X", *KEYS)
        self.operator.ask("program.run", program="part.nc")
        self.wait_for(lambda: self.operator.ask("channel.status")["speed_mm_s"] > 5.0)
        self.send(press(258))
        self.wait_for(lambda: self.operator.ask("channel.status")["held_by"] is not None)
        self.send(press(259))
        self.wait_for(lambda: self.operator.ask("channel.status")["held_by"] is None)

    def test_it_says_what_is_refused_and_that_the_device_is_gone(self):
        self.start("--axis", "Q")
        self.send(notches(1))
        self.assertIn("E6052", self.pendant.stderr.readline())
        os.close(self.pipe)
        self.assertEqual(self.pendant.wait(timeout=60), 1)
        self.assertIn("is gone", self.pendant.stderr.read())

    def test_it_shows_events_without_a_machine(self):
        self.start("--show")
        self.send(notches(-1) + press(256))
        self.assertEqual([self.pendant.stdout.readline() for _ in range(3)],
                         ["wheel 7 -1\n", "key 256 down\n", "key 256 up\n"])

    def test_a_wrong_key_is_an_error(self):
        for wrong in ("256", "x=Y", "256=step:0", "=Y"):
            ended = subprocess.run([STANOK, "pendant", "/dev/null", "--on", wrong, "--socket", self.daemon.socket_path],
                                   capture_output=True, text=True, check=False, timeout=60)
            self.assertEqual(ended.returncode, 2, wrong)
            self.assertIn("--show", ended.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
