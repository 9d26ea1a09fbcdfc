#!/usr/bin/env python3
"""The first answers of a daemon, asked for as soon as its socket takes a connection, tell how the channels stand: the
number of a situation, and words that the terms between machine and display lead to.

usage: first_answer_test.py STANOKD MACHINE_FILE ...
"""
import os
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator  # noqa: E402

STANOKD, MACHINES = sys.argv[1], sys.argv[2:]
STARTS = 3


def operator_at_once(process, path):
    while process.poll() is None:
        try:
            return Operator(path)
        except OSError:
            time.sleep(0.001)
    raise RuntimeError("the daemon did not start")


class FirstAnswer(unittest.TestCase):
    def check(self, operator):
        for channel in operator.ask("machine.status")["channels"]:
            number = channel["id"]
            told = operator.ask("channel.position", channel=number, why=1)
            self.assertGreater(told["situation"], 0)
            for axis in told["axes"]:
                terms = [term["term"] for term in axis["terms"]]
                self.assertNotIn("rest", terms, f"channel {number}, {axis['word']}")
                self.assertEqual(axis["terms"][-1]["value"], axis["shown"])

    def test_tells_how_the_channels_stand(self):
        for machine in MACHINES * STARTS:
            with self.subTest(machine=machine), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "op.sock")
                process = subprocess.Popen([STANOKD, "--machine", machine, "--drives", "embedded", "--lcm", "off", "--state",
                                            os.path.join(folder, "state"), "--socket", path], stderr=subprocess.DEVNULL)
                try:
                    operator = operator_at_once(process, path)
                    self.check(operator)
                    operator.socket.close()
                finally:
                    process.terminate()
                    process.wait(60)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
