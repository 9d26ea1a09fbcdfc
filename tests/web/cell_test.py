#!/usr/bin/env python3
"""stanok-web before two daemons and the history of a gateway: one page for all machines of a cell.

usage: cell_test.py STANOK_WEB STANOK_GATEWAY STANOKD MACHINE_FILE [unittest arguments]
"""
import contextlib
import os
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from running_daemon import Operator, Refused as DaemonRefused, running_daemon  # noqa: E402
from running_gateway import running_gateway  # noqa: E402
from web_browser import PATIENCE_S, Browser, Refused, running_web  # noqa: E402

STANOK_WEB, GATEWAY, STANOKD, MACHINE = (sys.argv.pop(1) for _ in range(4))
PROGRAM = "G1 X1 F6000\nX0\nM30\n"


def until(condition, what):
    end = time.monotonic() + PATIENCE_S
    while not (answer := condition()):
        assert time.monotonic() < end, f"never {what}"
        time.sleep(0.05)
    return answer


class Cell(unittest.TestCase):
    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.addCleanup(self.stack.close)
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory(dir="/tmp"))
        self.database = os.path.join(self.folder, "gateway", "history.sqlite")

    def machine(self, name):
        """A daemon whose socket is called so, and a client of it."""
        daemon = self.stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM))
        os.symlink(daemon.socket_path, os.path.join(self.folder, name + ".sock"))
        operator = Operator(daemon.socket_path)
        self.stack.callback(operator.socket.close)
        self.stack.callback(operator.lines.close)
        return daemon, operator

    def browser(self, *options):
        others = ("--socket", os.path.join(self.folder, "second.sock"), *options)
        web = self.stack.enter_context(
            running_web(STANOK_WEB, self.folder, os.path.join(self.folder, "first.sock"), "--page", self.folder,
                        "--link-socket", os.path.join(self.folder, "links.panel"), "--listen", "127.0.0.1:0",
                        "--socket", os.path.join(self.folder, "first.sock"), *others, error=subprocess.DEVNULL))
        return Browser(web)

    @staticmethod
    def run_program(operator):
        """A computer that is loaded may starve the drives inside the daemon; one asks again."""
        def is_done():
            try:
                operator.ask("machine.on")
                return operator.ask("program.run", program="part.nc", wait="done")
            except DaemonRefused:
                return None
        until(is_done, "a run")

    def test_every_machine_has_its_tile_and_its_socket(self):
        daemon, first = self.machine("first")
        _, second = self.machine("second")
        browser = self.browser()
        self.assertEqual(browser.request("GET", "/api/machines").status, 401)
        browser.enter_by_link()
        answer = browser.request("GET", "/api/machines").json()
        self.assertFalse(answer["history"])
        self.assertEqual([one["id"] for one in answer["machines"]], ["first", "second"])
        for one in answer["machines"]:
            self.assertTrue(one["answers"])
            self.assertEqual([channel["id"] for channel in one["channels"]], [1])
            self.assertEqual(one["channels"][0]["override"]["feed"], 100)
            self.assertEqual(one["channels"][0]["speed_mm_s"], 0)
            for member in ("g_codes", "words", "cycle", "position"):
                self.assertTrue(one["channels"][0][member], member)
        # Each WebSocket is one of the machine that its path names, the first one as a rule.
        first.ask("offset.set", offset="G54", axis="X", value=1)
        second.ask("offset.set", offset="G54", axis="X", value=2)
        for path, wanted in (("/ws", 1), ("/ws/first", 1), ("/ws/second", 2)):
            window = browser.open_window(path=path)
            self.assertEqual(window.ask("offset.list")["offsets"]["G54"]["X"], wanted, path)
            window.close()
        for path in ("/ws/third", "/ws/", "/ws/first/", "/wsx"):
            with self.assertRaises(Refused) as refused:
                browser.open_window(path=path)
            self.assertEqual(refused.exception.status, 404, path)
        # A machine that has gone is shown as one, and the other one goes on.
        daemon.process.send_signal(signal.SIGKILL)

        def tiles():
            return browser.request("GET", "/api/machines").json()["machines"]
        until(lambda: not tiles()[0]["answers"], "the first machine is missed")
        self.assertEqual((tiles()[0]["channels"], tiles()[0]["on"], tiles()[1]["answers"]), ([], None, True))

    def silent_machine(self, name):
        """A socket that takes connections in and says nothing."""
        listener = socket.socket(socket.AF_UNIX)
        self.stack.callback(listener.close)
        listener.bind(os.path.join(self.folder, name + ".sock"))
        listener.listen()
        return listener

    def asked_and_given_up(self, listeners):
        """("asked" | "given up", number) in their order, until the page has given up each of them."""
        order, selector = [], selectors.DefaultSelector()
        self.stack.callback(selector.close)
        for number, listener in enumerate(listeners):
            selector.register(listener, selectors.EVENT_READ, ("asked", number))
        end = time.monotonic() + PATIENCE_S
        while sum(what == "given up" for what, _ in order) < len(listeners):
            self.assertLess(time.monotonic(), end, f"not all are asked and given up: {order}")
            # Those that wait to be let in first: they have knocked before anything that is seen now.
            for key, _ in sorted(selector.select(1), key=lambda ready: ready[0].data):
                if key.data[0] == "asked":
                    connection, _ = key.fileobj.accept()
                    self.stack.callback(connection.close)
                    selector.register(connection, selectors.EVENT_READ, ("given up", key.data[1]))
                else:
                    self.assertEqual(key.fileobj.recv(1), b"")
                    selector.unregister(key.fileobj)
                order.append(key.data)
        return order

    def test_machines_that_say_nothing_are_all_asked_at_once(self):
        silent = [self.silent_machine(f"silent{number}") for number in range(6)]
        self.machine("first")
        self.machine("second")
        sockets = [word for number in range(len(silent))
                   for word in ("--socket", os.path.join(self.folder, f"silent{number}.sock"))]
        browser = self.browser(*sockets)
        browser.enter_by_link()
        answers = []
        asking = threading.Thread(target=lambda: answers.append(browser.request("GET", "/api/machines").json()))
        asking.start()
        order = self.asked_and_given_up(silent)
        asking.join(PATIENCE_S)
        self.assertEqual([what for what, _ in order], ["asked"] * len(silent) + ["given up"] * len(silent))
        machines = answers[0]["machines"]
        self.assertEqual([(one["id"], one["answers"]) for one in machines],
                         [("first", True), ("second", True)] + [(f"silent{k}", False) for k in range(len(silent))])

    def test_the_page_reads_the_history_of_the_gateway(self):
        daemon, operator = self.machine("first")
        self.machine("second")
        browser = self.browser("--history", self.database)
        self.assertEqual(browser.request("POST", "/api/history", {"query": "runs"}).status, 401)
        browser.enter_by_link()
        self.assertTrue(browser.request("GET", "/api/machines").json()["history"])
        # Before there is one.
        answer = browser.request("POST", "/api/history", {"query": "runs"})
        self.assertEqual(answer.status, 502)
        self.assertIn("there is no history", answer.json()["error"])
        with running_gateway(GATEWAY, self.folder, {"mill": daemon.socket_path}, None):
            self.run_program(operator)

            def runs(**changed):
                answer = browser.request("POST", "/api/history", {"query": "runs", **changed})
                return answer.status == 200 and answer.json()
            answer = until(lambda: (got := runs()) and got["rows"] and got, "a run in the history")
            self.assertEqual(runs(machine="another")["rows"], [])
        names = [column["name"] for column in answer["columns"]]
        kinds = dict((column["name"], column["kind"]) for column in answer["columns"])
        self.assertEqual((kinds["ended"], kinds["ok"], kinds["program"]), ("time", "yes_no", "text"))
        run = dict(zip(names, answer["rows"][0]))
        told = operator.ask("program.history")["runs"][-1]
        self.assertEqual((run["machine"], run["program"], run["ok"]), ("mill", "part.nc", True))
        self.assertEqual((run["time_s"], run["path_mm"]), (told["time_s"], told["path_mm"]))

    def test_wrong_questions_are_refused_with_the_reason(self):
        self.machine("first")
        self.machine("second")
        browser = self.browser("--history", self.database)
        browser.enter_by_link()
        for question, status, reason in (({"query": "salaries"}, 400, "unknown query"),
                                         ({"query": "runs", "since": "yesterday"}, 400, "30d, 12h or 45min"),
                                         ({"query": "runs", "since": "-1d"}, 400, "30d, 12h or 45min"),
                                         ({}, 400, "unknown query"), ([], 400, "unknown query")):
            answer = browser.request("POST", "/api/history", question)
            self.assertEqual(answer.status, status, question)
            self.assertIn(reason, answer.json()["error"])
        self.assertEqual(browser.request("GET", "/api/history").status, 405)
        self.assertEqual(browser.request("POST", "/api/history", {"query": "runs"}, Content_Type="text/plain").status, 415)

    def test_machines_that_cannot_be_told_apart_are_refused_at_the_start(self):
        for sockets, reason in ((("a/op.sock", "b/op.sock"), "two sockets have the name op"),
                                (("op.sock", "m 1.sock"), "letters, digits")):
            words = [word for socket in sockets for word in ("--socket", socket)]
            ended = subprocess.run([STANOK_WEB, "--listen", "127.0.0.1:0", *words], capture_output=True, text=True)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(reason, ended.stderr)


if __name__ == "__main__":
    unittest.main()
