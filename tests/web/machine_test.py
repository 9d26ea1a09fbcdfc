#!/usr/bin/env python3
"""stanok-web before a real daemon with simulated drives: what a browser does to the machine, and what it cannot.

usage: machine_test.py STANOK_WEB STANOKD STANOK MACHINE_FILE [unittest arguments]
"""
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402
from web_browser import PATIENCE_S, Browser, Closed, running_web  # noqa: E402

STANOK_WEB, STANOKD, STANOK, MACHINE = (sys.argv.pop(1) for _ in range(4))
LONG_PROGRAM = "for (num turn = 0; turn < 100000; turn++) {\nG1 X5 F600\nX0\n}\nM30\n"


class AtTheMachine(unittest.TestCase):
    def setUp(self):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.folder = stack.enter_context(tempfile.TemporaryDirectory())
        self.machine = stack.enter_context(running_daemon(STANOKD, MACHINE, LONG_PROGRAM))
        self.operator = Operator(self.machine.socket_path)
        stack.callback(self.operator.socket.close)
        stack.callback(self.operator.lines.close)
        self.web = stack.enter_context(running_web(STANOK_WEB, self.folder, self.machine.socket_path,
                                                   error=subprocess.DEVNULL))
        self.browser = Browser(self.web)

    def until(self, condition, what):
        """The status of the channel, when it is so."""
        end = time.monotonic() + PATIENCE_S
        while not condition(status := self.operator.ask("channel.status")):
            self.assertLess(time.monotonic(), end, f"never {what}: {status}")
            time.sleep(0.02)
        return status

    def open_window(self):
        self.browser.enter_by_link()
        window = self.browser.open_window()
        self.assertEqual(window.receive()["method"], "hello")
        return window

    def insist(self, window, method, /, code, **parameters):
        """Asks again as long as the refusal is the one that is to be expected meanwhile."""
        end = time.monotonic() + PATIENCE_S
        while "result" not in (answer := window.answer(method, **parameters)):
            self.assertEqual(answer["error"]["data"]["code"], code)
            self.assertLess(time.monotonic(), end, answer)
            time.sleep(0.05)

    def switch_on(self, window):
        """A computer that is loaded may starve the drives inside the daemon; one switches on again."""
        self.insist(window, "machine.on", code="A3001")

    def test_a_job_outlives_the_page_and_its_server(self):
        window = self.open_window()
        self.switch_on(window)
        window.ask("program.run", program="part.nc")
        self.until(lambda status: status["line"] > 0, "a line was executed")
        self.web.process.send_signal(signal.SIGKILL)
        with self.assertRaises((Closed, OSError)):
            while True:
                window.receive()
        window.close()
        block = self.operator.ask("channel.status")["block"]
        status = self.until(lambda status: status["block"] > block + 3, "the job went on")
        self.assertEqual(status["state"], "Active")
        self.web.process.wait()
        self.web.process.returncode = 0  # as it was meant

    def test_a_jog_ends_with_the_browser(self):
        window = self.open_window()
        self.switch_on(window)
        # The drives hold the axes a moment after they were switched on.
        self.insist(window, "jog", code="E6008", axis="X", velocity=5)
        self.until(lambda status: status["speed_mm_s"] != 0 or status["position"]["X"] != 0, "the axis moved")
        window.socket.close()
        window.stream.close()
        last = [None]

        def rests(status):
            stood, last[0] = last[0] == status["position"]["X"], status["position"]["X"]
            return stood
        self.until(rests, "at rest")

    def test_status_comes_by_itself(self):
        window = self.open_window()
        window.ask("subscribe", topics=["channels", "machine"], rate_hz=20)
        while (message := window.receive()).get("method") != "status":
            pass
        self.assertIn("1", message["params"]["state"]["channels"])
        window.close()

    def test_fifty_pages_at_once(self):
        self.browser.enter_by_link()
        windows = [self.browser.open_window() for _ in range(50)]
        for window in windows:
            self.assertEqual(window.receive()["method"], "hello")
        for window in windows:
            self.assertIn("state", window.ask("channel.status"))
            window.close()
        self.until(lambda _: self.operator.ask("system.info")["clients"] == 1, "they had gone")

    def test_stanok_panel_prints_a_link_that_opens(self):
        desk = os.path.join(self.folder, "links.panel")
        surroundings = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        printed = subprocess.run([STANOK, "panel", "--link-socket", desk, "--json"], env=surroundings, check=True,
                                 capture_output=True, timeout=PATIENCE_S)
        link = json.loads(printed.stdout)
        self.assertFalse(link["opened"])
        self.web.token = link["link"].split("#")[1]
        self.browser.enter_by_link()
        session = self.browser.request("GET", "/api/session").json()
        self.assertEqual(session["role"], "integrator")

    def test_stanok_panel_says_that_there_is_no_server(self):
        done = subprocess.run([STANOK, "panel", "--socket", os.path.join(self.folder, "none.sock")], check=False,
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 3)
        self.assertIn("stanok-web --socket", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
