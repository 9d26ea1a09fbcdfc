#!/usr/bin/env python3
"""The client of the operator protocol: against a running daemon, over its socket and over TCP.

usage: client_test.py STANOKD MACHINE_FILE
"""
import json
import os
import socket
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import stanok
from stanok import _native
from surroundings import ROOT

sys.path.insert(0, str(ROOT / "tests" / "support"))
sys.path.insert(0, str(ROOT / "tools"))
from generate_python_methods import FILE, generated  # noqa: E402
from running_daemon import Operator, running_daemon  # noqa: E402

PROGRAM = "G1 X5 F3000\n(MSG, half way)\nX0\nM30\n"
STANOKD, MACHINE = sys.argv[1:3]


class Relay:
    """Passes one TCP connection on loopback on to a socket of the daemon, as ssh -L does."""

    def __init__(self, path):
        self.path = path
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        there, _ = self.listener.accept()
        here = socket.socket(socket.AF_UNIX)
        here.connect(self.path)
        for pair in ((there, here), (here, there)):
            threading.Thread(target=self.copy, args=pair, daemon=True).start()

    @staticmethod
    def copy(source, sink):
        while received := source.recv(1 << 16):
            sink.sendall(received)
        sink.close()


class Stops(unittest.TestCase):
    """Each with a daemon of its own: a stop leaves alarms."""

    def setUp(self):
        running = running_daemon(STANOKD, MACHINE, PROGRAM, impatient=True)
        self.daemon = running.__enter__()
        self.addCleanup(running.__exit__, None, None, None)
        self.client = stanok.connect(self.daemon.socket_path)
        self.addCleanup(self.client.close)

    def test_a_stop_waits_for_no_other_call(self):
        self.daemon_runs_for_ever()
        waiting = threading.Thread(target=self.runs_to_its_end, daemon=True)
        waiting.start()
        self.wait_for(lambda: self.state()["speed_mm_s"] > 1.0)
        self.client.program.reset()
        waiting.join(60)
        self.assertFalse(waiting.is_alive())
        self.assertIsInstance(self.outcome, stanok.RequestError)

    def test_a_stop_needs_no_place(self):
        self.client.machine.on()
        idle = [socket.socket(socket.AF_UNIX) for _ in range(70)]
        for one in idle:
            self.addCleanup(one.close)
            one.connect(self.daemon.socket_path)
        with self.assertRaises(stanok.ConnectionLost):
            stanok.connect(self.daemon.socket_path)
        self.assertEqual(stanok.stop(self.daemon.socket_path), {"accepted": True})
        self.wait_for(lambda: not self.client.machine.status()["on"])
        with self.assertRaises(ValueError):
            stanok.stop(self.daemon.socket_path, "machine.on")

    def test_what_begins_motion_tells_what_was_seen(self):
        self.wait_for(lambda: self.client.machine.status()["cycle"] > 600)
        with self.assertRaises(stanok.RequestError) as refused:
            self.client.machine.on(seen_cycle=0)
        self.assertEqual(refused.exception.faults[0].code, "E6073")

    def daemon_runs_for_ever(self):
        self.client.machine.on()
        Path(self.client.system.info()["program_root"], "endless.nc").write_text(
            "G21 G90 F600\nwhile (true) {\nG1 X10\nX0\n}\n", encoding="utf-8")

    def runs_to_its_end(self):
        try:
            self.client.program.run("endless.nc", wait="done")
        except stanok.StanokError as error:
            self.outcome = error

    def state(self):
        return Operator(self.daemon.socket_path).ask("channel.status")

    def wait_for(self, condition):
        end = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), end, "it does not come about")
            time.sleep(0.02)


class WithDaemon(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.running = running_daemon(STANOKD, MACHINE, PROGRAM)
        cls.daemon = cls.running.__enter__()
        cls.addClassCleanup(cls.running.__exit__, None, None, None)

    def setUp(self):
        self.client = stanok.connect(self.daemon.socket_path)
        self.addCleanup(self.client.close)

    def test_results_are_those_of_the_protocol(self):
        other = Operator(self.daemon.socket_path)
        self.assertEqual(self.client.hello["machine"], "mill3")
        self.assertEqual(self.client.channel.list(), other.ask("channel.list"))
        self.assertEqual(self.client.tool.list(), other.ask("tool.list"))
        self.assertEqual(self.client.kinematics.list(channel=1), other.ask("kinematics.list", channel=1))
        self.assertEqual(self.client.call("program.list"), other.ask("program.list"))
        self.assertEqual(self.client.rpc.discover(), json.loads(_native.discovery()))

    def test_a_program_is_run_and_its_messages_come(self):
        with stanok.connect(self.daemon.socket_path) as watcher:
            heard = []
            listening = threading.Event()

            def listen():
                events = watcher.events(timeout_s=20)
                watcher.call("subscribe", {"topics": ["events"]})
                listening.set()
                for event in events:
                    heard.append(event)
                    if "half way" in event["text"]:
                        return

            thread = threading.Thread(target=listen)
            thread.start()
            listening.wait(20)
            self.client.machine.on()
            self.client.home()
            result = self.client.program.run("part.nc", wait="done")
            thread.join()
        self.assertTrue(result["ok"])
        self.assertEqual(result["program"], "part.nc")
        self.assertIn("half way", " ".join(event["text"] for event in heard))

    def test_states_are_whole_after_every_change(self):
        states = self.client.states(("channels",), rate_hz=50, timeout_s=20)
        first = next(states)
        self.assertIn("1", first["channels"])
        with stanok.connect(self.daemon.socket_path) as other:
            other.override.feed(77.0)
        for state in states:
            self.assertEqual(state["channels"]["1"].keys(), first["channels"]["1"].keys())
            if state["channels"]["1"]["override"]["feed"] == 77.0:
                break
        self.client.override.feed(100.0)

    def test_a_refusal_has_code_place_and_remedy(self):
        self.client.program.write("wrong.nc", "G1 X1 F100\nG1 Qx\nM30\n", version="any")
        self.client.machine.on()
        with self.assertRaises(stanok.RequestError) as caught:
            self.client.program.load("wrong.nc", wait="done")
        error = caught.exception
        self.assertEqual((error.number, error.file, error.line), (-32004, "wrong.nc", 2))
        self.assertTrue(error.code and error.remedy)
        with self.assertRaises(stanok.RequestError) as caught:
            self.client.override.feed(1e6)
        self.assertEqual(caught.exception.number, -32602)
        with self.assertRaises(stanok.RequestError) as caught:
            self.client.call("no.method")
        self.assertEqual(caught.exception.number, -32601)
        self.client.session.role("observer")
        with self.assertRaises(stanok.RequestError) as caught:
            self.client.program.start()
        self.assertEqual(caught.exception.number, -32002)

    def test_tcp(self):
        for address in (lambda port: ("127.0.0.1", port), lambda port: f"tcp://127.0.0.1:{port}"):
            relay = Relay(self.daemon.socket_path)
            with stanok.connect(address(relay.port)) as client:
                self.assertEqual(client.machine.status()["name"], "mill3")
            relay.listener.close()

    def test_threads_share_a_client(self):
        results = []
        threads = [threading.Thread(target=lambda: results.extend(self.client.machine.status()["name"]
                                                                  for _ in range(20))) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, ["mill3"] * 80)

    def test_a_thread_may_ask_while_another_waits_for_events(self):
        heard = []
        thread = threading.Thread(target=lambda: heard.extend(self.client.events(timeout_s=2.0)))
        thread.start()
        for _ in range(20):
            self.assertEqual(self.client.machine.status()["name"], "mill3")
        thread.join()

    def test_the_socket_is_found_as_stanok_finds_it(self):
        before = os.environ.get("STANOK_SOCKET")
        os.environ["STANOK_SOCKET"] = self.daemon.socket_path
        self.addCleanup(lambda: os.environ.pop("STANOK_SOCKET") if before is None else
                        os.environ.update(STANOK_SOCKET=before))
        with stanok.connect() as client:
            self.assertEqual(client.hello["machine"], "mill3")

    def test_patches_are_those_of_rfc_7396(self):
        # Examples of its appendix A.
        for target, patch, result in (({"a": "b"}, {"a": "c"}, {"a": "c"}), ({"a": "b"}, {"a": None}, {}),
                                      ({"a": "b", "b": "c"}, {"a": None}, {"b": "c"}),
                                      ({"a": {"b": "c"}}, {"a": {"b": "d", "c": None}}, {"a": {"b": "d"}}),
                                      ({"a": "foo"}, "bar", "bar"), ({"e": None}, {"a": 1}, {"e": None, "a": 1}),
                                      ([1, 2], {"a": "b", "c": None}, {"a": "b"}),
                                      ({}, {"a": {"bb": {"ccc": None}}}, {"a": {"bb": {}}})):
            self.assertEqual(stanok.rpc.merged(target, patch), result)


class WithoutDaemon(unittest.TestCase):
    def serve(self, *lines):
        """A socket that says these lines to who connects, and closes."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = str(Path(folder.name) / "one.sock")
        listener = socket.socket(socket.AF_UNIX)
        listener.bind(path)
        listener.listen()
        self.addCleanup(listener.close)

        def talk():
            there, _ = listener.accept()
            there.sendall(b"".join(lines))
            there.close()

        threading.Thread(target=talk, daemon=True).start()
        return path

    def test_a_daemon_that_takes_nothing_is_a_lost_connection(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = str(Path(folder.name) / "one.sock")
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(path)
            listener.listen()
            knocking = []
            thread = threading.Thread(target=lambda: knocking.append(stanok.connect(path, timeout_s=0.5)))
            thread.start()
            there, _ = listener.accept()
            self.addCleanup(there.close)
            there.sendall(b'{"jsonrpc":"2.0","method":"hello","params":{"machine":"m"}}\n')
            thread.join()
        client = knocking[0]
        self.addCleanup(client.close)
        # More than a socket holds; what has gone of it is no line, so that nothing may be sent behind it.
        with self.assertRaisesRegex(stanok.ConnectionLost, "takes nothing"):
            client.program.write("part.nc", "G1 X1\n" * 4_000_000)
        with self.assertRaises(stanok.ConnectionLost):
            client.machine.status()

    def test_what_nobody_takes_is_bounded(self):
        def line(**message):
            return json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n"

        def status(number, full):
            state = {"channels": {"1": {"line": number, **({"tool": {"number": 7}} if full else {})}}}
            return line(method="status", params={"seq": number, "full": full, "state": state})

        def event(number):
            return line(method="event", params={"seq": number, "text": f"event {number}"})

        told = 25_000
        lines = [line(method="hello", params={"machine": "m"}), status(0, full=True)]
        lines += [part for number in range(1, told + 1) for part in (status(number, full=False), event(number))]
        lines.append(line(id=1, result={"name": "m"}))
        client = stanok.connect(self.serve(*lines), timeout_s=240)  # for 50,000 messages on a loaded computer
        self.addCleanup(client.close)
        self.assertEqual(client.call("machine.status"), {"name": "m"})
        kept = list(client._notifications)
        self.assertLessEqual(len(kept), 10_001)
        self.assertEqual([one.params["seq"] for one in kept if one.method == "event"][-1], told)
        statuses = [one.params for one in kept if one.method == "status"]
        self.assertEqual(statuses, [{"seq": told, "full": True,
                                     "state": {"channels": {"1": {"line": told, "tool": {"number": 7}}}}}])

    def test_no_daemon_is_a_lost_connection(self):
        for address in ("/nowhere/one.sock", ("127.0.0.1", 1), "tcp://127.0.0.1:1"):
            with self.assertRaises(stanok.ConnectionLost):
                stanok.connect(address)
        for address in ("tcp://", "tcp://host", "tcp://host:port"):
            with self.assertRaises(ValueError):
                stanok.connect(address)

    def test_what_is_no_daemon_is_told(self):
        hello = b'{"jsonrpc":"2.0","method":"hello","params":{"machine":"m"}}\n'
        for lines in ((), (b"SSH-2.0\r\n",), (b"{}\n",), (b"\xff\xfe\n",), (b"[" * 100_000 + b"\n",)):
            with self.assertRaises((stanok.ConnectionLost, RecursionError)):
                stanok.connect(self.serve(*lines))
        full = b'{"jsonrpc":"2.0","method":"dropped","params":{"code":"E9008","text":"no place is left"}}\n'
        with self.assertRaises(stanok.ConnectionLost) as caught:
            stanok.connect(self.serve(full))
        self.assertEqual(caught.exception.code, "E9008")
        client = stanok.connect(self.serve(hello))
        with self.assertRaises(stanok.ConnectionLost):
            client.machine.status()


class Table(unittest.TestCase):
    def test_methods_are_those_of_the_table(self):
        self.assertEqual(FILE.read_text(encoding="utf-8"), generated(),
                         "write it anew: PYTHONPATH=build/release/python tools/generate_python_methods.py")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
