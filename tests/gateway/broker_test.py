#!/usr/bin/env python3
"""stanok-gateway between real daemons with simulated drives and a real mosquitto: what a subscriber sees.

usage: broker_test.py GATEWAY STANOKD MACHINE_FILE DEATHS [unittest arguments]
DEATHS: how often the broker is killed and brought back under events.
"""
import contextlib
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_broker import PATIENCE_S, Broker, ForgetfulBroker, Subscriber  # noqa: E402
from running_daemon import Operator, Refused, running_daemon  # noqa: E402
from running_gateway import running_gateway  # noqa: E402

GATEWAY, STANOKD, MACHINE, DEATHS = (sys.argv.pop(1) for _ in range(4))
PROGRAM = "T1 M6\nG1 X1 F3000\nX0\nM30\n"
WRONG = "G1 X1 F3000\nG1 X100000\nM30\n"  # beyond the travel of X


class Machine:
    """A machine that is on, and the runs that were begun by it."""

    def __init__(self, stack, options=()):
        self.daemon = stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM, options=options))
        self.socket = self.daemon.socket_path
        with open(os.path.join(os.path.dirname(self.socket), "wrong.nc"), "w", encoding="utf-8") as file:
            file.write(WRONG)
        self.operator = Operator(self.socket)
        stack.callback(self.operator.socket.close)
        stack.callback(self.operator.lines.close)
        self.insist("machine.on")

    def insist(self, method, **parameters):
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                return self.operator.ask(method, **parameters)
            except Refused:
                if time.monotonic() > end:
                    raise
                time.sleep(0.05)

    def run(self):
        """To its end. A computer that is loaded may starve the drives inside the daemon, which is told as a drive that
        does not answer; an operator switches on again."""
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                return self.operator.ask("program.run", program="part.nc", wait="done")
            except Refused:
                if time.monotonic() > end:
                    raise
            self.switch_on_again()

    def switch_on_again(self):
        for method in ("program.reset", "machine.on"):
            self.operator.answer(method)
        time.sleep(0.05)

    def ended(self):
        """Numbers of the runs that have ended, also of those that are not kept any more."""
        runs = self.insist("program.history")["runs"]
        return set(range(1, runs[0]["number"])) | {run["number"] for run in runs if run["ended"]} if runs else set()

    def fail(self):
        """A run that an alarm ends."""
        end = time.monotonic() + PATIENCE_S
        while True:
            error = self.operator.answer("program.run", program="wrong.nc", wait="done")["error"]["data"]
            if error["code"] == "E5101":
                break
            if time.monotonic() > end:
                raise RuntimeError(error)
            self.switch_on_again()
        self.insist("program.reset")
        return error


class TheCell(unittest.TestCase):
    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.addCleanup(self.stack.close)
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory())

    def broker(self, settings=""):
        broker = Broker(self.folder, settings)
        self.stack.callback(broker.end)
        return broker

    def gateway(self, machines, broker, options=()):
        daemons = {name: machine.socket for name, machine in machines.items()}
        return self.stack.enter_context(running_gateway(GATEWAY, self.folder, daemons, broker.port, options))

    def receive_until(self, subscriber, condition, what):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            topic, text, retained = subscriber.receive()
            content = json.loads(text)
            if condition(topic, content):
                return content, retained
        return self.fail(f"never {what}")

    def test_a_subscriber_sees_state_alarm_and_run(self):
        broker, machine = self.broker(), Machine(self.stack)
        self.gateway({"mill": machine}, broker)
        with Subscriber(broker.port, "cell/#") as subscriber:
            state, _ = self.receive_until(
                subscriber, lambda topic, content: topic == "cell/mill/state" and content.get("on"), "on")
            self.assertTrue(state["connected"])
            self.assertEqual(state["channels"]["1"]["state"], "Reset")
            self.assertRegex(state["time"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
            before = time.time()
            machine.run()
            begun, _ = self.receive_until(
                subscriber, lambda topic, _: topic == "cell/mill/event/run_begun", "a run")
            ended, retained = self.receive_until(
                subscriber, lambda topic, _: topic == "cell/mill/event/run_ended", "its end")
            self.assertFalse(retained)
            self.assertEqual((ended["program"], ended["ok"], ended["parts"]), ("part.nc", True, 1))
            self.assertEqual(ended["seq"], begun["seq"] + 1)
            self.assertEqual(len(begun["version"]), len(ended["version"]))
            self.assertTrue(ended["version"])
            # The way of the program, there and back, and cycles that were timed by the clock.
            self.assertAlmostEqual(ended["path_mm"], 2.0, delta=1e-6)
            self.assertLess(abs(ended["ended_s"] - ended["begun_s"] - ended["time_s"]), 0.01)
            self.assertLess(before - 1, ended["begun_s"])
            self.assertLess(ended["ended_s"], time.time() + 1)
            wanted = machine.fail()
            alarm, _ = self.receive_until(
                subscriber, lambda topic, _: topic == "cell/mill/event/alarm", "the alarm")
            self.assertEqual((alarm["code"], alarm["file"], alarm["line"]),
                             (wanted["code"], wanted["file"], wanted["line"]))
        with Subscriber(broker.port, "cell/mill/positions") as late:
            positions, retained = self.receive_until(late, lambda *_: True, "positions")
            self.assertTrue(retained)
            self.assertEqual(set(positions["channels"]["1"]["position"]), {"X", "Y", "Z"})

    def test_the_will_tells_of_a_gateway_that_died(self):
        broker, machine = self.broker(), Machine(self.stack)
        daemons = {"mill": machine.socket}
        with Subscriber(broker.port, "cell/gateway") as subscriber:
            with self.assertRaises(RuntimeError):
                with running_gateway(GATEWAY, self.folder, daemons, broker.port) as process:
                    self.receive_until(subscriber, lambda _, content: content["online"], "online")
                    process.send_signal(signal.SIGKILL)
            self.receive_until(subscriber, lambda _, content: not content["online"], "offline")
            with running_gateway(GATEWAY, self.folder, daemons, broker.port):
                self.receive_until(subscriber, lambda _, content: content["online"], "online again")
            self.receive_until(subscriber, lambda _, content: not content["online"], "offline in order")

    def test_tls_and_a_password_from_a_file(self):
        certificate, key = (os.path.join(self.folder, name) for name in ("broker.pem", "broker.key"))
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj",
                        "/CN=localhost", "-addext", "subjectAltName=DNS:localhost", "-keyout", key, "-out",
                        certificate], check=True, stderr=subprocess.DEVNULL)
        users, password = (os.path.join(self.folder, name) for name in ("users", "password"))
        subprocess.run(["mosquitto_passwd", "-b", "-c", users, "hall", "a long one"], check=True,
                       stderr=subprocess.DEVNULL)
        with open(password, "w", encoding="utf-8") as file:
            file.write("a long one\n")
        broker = self.broker(f"certfile {certificate}\nkeyfile {key}\nallow_anonymous false\npassword_file {users}\n")
        machine = Machine(self.stack)
        with self.assertRaises(PermissionError):
            Subscriber(broker.port, "cell/#", "hall", "another one", certificate)
        options = ("--broker", f"localhost:{broker.port}", "--user", "hall", "--password-file", password, "--tls-ca",
                   certificate)
        with running_gateway(GATEWAY, self.folder, {"mill": machine.socket}, None, options) as process, \
                Subscriber(broker.port, "cell/#", "hall", "a long one", certificate) as subscriber:
            self.receive_until(subscriber, lambda _, content: content.get("on"), "on")
            with open(f"/proc/{process.pid}/cmdline", "rb") as arguments:
                self.assertNotIn(b"a long one", arguments.read())

    def test_a_daemon_that_goes_and_comes_back(self):
        broker = self.broker()
        with contextlib.ExitStack() as first:
            machine = Machine(first)
            self.gateway({"mill": machine}, broker)
            subscriber = self.stack.enter_context(Subscriber(broker.port, "cell/mill/state"))
            self.receive_until(subscriber, lambda _, content: content["connected"], "connected")
        self.receive_until(subscriber, lambda _, content: not content["connected"], "disconnected")

    def test_a_host_of_sparkplug_sees_births_data_and_deaths(self):
        broker = self.broker()
        with contextlib.ExitStack() as inner, Subscriber(broker.port, "spBv1.0/works/#") as host:
            machine = Machine(inner)
            gateway = contextlib.ExitStack()
            gateway.enter_context(running_gateway(GATEWAY, self.folder, {"mill": machine.socket}, broker.port,
                                                  ("--sparkplug", "works")))
            watched = SparkplugHost(host)
            self.wait_for(lambda: watched.next() and "NBIRTH" in watched.seen, "the birth of the node")
            self.assertEqual(watched.metrics[""]["Node Control/Rebirth"], False)
            self.wait_for(lambda: watched.next() and watched.value("mill", "state/connected") is True,
                          "the birth of the machine")
            machine.run()
            self.wait_for(lambda: watched.next() and watched.value("mill", "parts/programs/part.nc") == 1.0, "the part")
            watched.seen.clear()
            machine.run()
            self.wait_for(lambda: watched.next() and watched.value("mill", "parts/programs/part.nc") == 2.0, "the next")
            self.assertIn("DDATA", watched.seen)
            self.wait_for(lambda: watched.value("mill", "state/channels/1/state") == "Reset" or
                          (watched.next() and False), "the rest behind it")
            # A host that came late asks for births.
            watched.seen.clear()
            host.publish(f"spBv1.0/works/NCMD/{watched.node}", rebirth_command())
            self.wait_for(lambda: watched.next() and {"NBIRTH", "DBIRTH"} <= watched.seen, "births again")
            inner.close()
            self.wait_for(lambda: watched.next() and "DDEATH" in watched.seen, "the death of the machine")
            gateway.close()
            self.wait_for(lambda: watched.next() and "NDEATH" in watched.seen, "the death of the node")
            self.assertEqual(watched.died_with, watched.metrics[""]["bdSeq"])

    def test_what_a_broker_acknowledged_and_forgot_is_sent_again(self):
        broker, machine = ForgetfulBroker(), Machine(self.stack)
        self.stack.callback(broker.end)
        self.gateway({"mill": machine}, broker)
        machine.run()
        self.wait_for(lambda: broker.events and len(broker.events[-1]) >= 2, "the run")
        first = list(broker.events[-1])
        count = len(broker.events)
        broker.die()
        self.wait_for(lambda: len(broker.events) > count and len(broker.events[-1]) >= len(first), "the run again")
        self.assertEqual([json.loads(text) for text in broker.events[-1][:len(first)]],
                         [json.loads(text) for text in first])

    def test_a_broker_that_is_trusted_at_once_gets_nothing_twice(self):
        broker, machine = ForgetfulBroker(), Machine(self.stack)
        self.stack.callback(broker.end)
        self.gateway({"mill": machine}, broker, ("--resend", "0"))
        machine.run()
        self.wait_for(lambda: broker.events and len(broker.events[-1]) >= 2, "the run")
        machine.run()
        self.wait_for(lambda: len(broker.events[-1]) >= 4, "the next run")
        broker.die()
        machine.run()
        self.wait_for(lambda: len(broker.events) > 1 and len(broker.events[-1]) >= 2, "a run on the next connection")
        self.assertGreater(json.loads(broker.events[-1][0])["seq"], 2)

    def test_a_broker_that_dies_under_events_loses_none(self):
        """Runs of two machines go on while the broker is killed and brought back, and once the gateway is."""
        broker = self.broker()
        machines = {"mill": Machine(self.stack), "lathe": Machine(self.stack)}
        ended = threading.Event()
        worked = {name: 0 for name in machines}  # runs
        workers = [threading.Thread(target=self.work, args=(machines, name, worked, ended)) for name in machines]
        got = Received(broker.port)
        self.addCleanup(got.end)
        self.addCleanup(ended.set)
        with contextlib.ExitStack() as first:
            daemons = {name: machine.socket for name, machine in machines.items()}
            process = first.enter_context(running_gateway(GATEWAY, self.folder, daemons, broker.port))
            for thread in [*workers, got.thread]:
                thread.start()
            for death in range(int(DEATHS)):
                count = len(got.numbers)
                self.wait_for(lambda: len(got.numbers) > count + 3, "events")
                broker.kill()
                done = dict(worked)
                self.wait_for(lambda: all(worked[name] > done[name] for name in worked), "runs without a broker")
                if death == 1:
                    process.send_signal(signal.SIGKILL)
                    process.wait()
                    process.returncode = 0
                    process = first.enter_context(running_gateway(GATEWAY, self.folder, daemons, broker.port))
                broker.start()
            ended.set()
            for thread in workers:
                thread.join()
            for name, machine in machines.items():
                ends = machine.ended()
                self.assertGreaterEqual(len(ends), worked[name])
                self.wait_for(lambda: got.ends[name] == ends, lambda: self.missing_of(name, ends, got))
        got.end()
        # No number is missing, and each is known once.
        self.assertEqual(got.numbers, set(range(1, len(got.numbers) + 1)), got.late)
        print(f"{DEATHS} deaths: {len(got.numbers)} events, {got.repeated} repeated, {len(got.late)} out of order")

    @staticmethod
    def missing_of(name, ends, got):
        """What tells a loss on the way from one that the gateway never told."""
        numbers = sorted(set(range(1, max(got.numbers, default=0) + 1)) - got.numbers)
        return f"the ends of runs {sorted(ends - got.ends[name])} of {name}; events never seen: {numbers}"

    @staticmethod
    def work(machines, name, worked, ended):
        while not ended.is_set():
            machines[name].run()
            worked[name] += 1

    def wait_for(self, condition, what):
        end = time.monotonic() + 2 * PATIENCE_S
        while not condition():
            if time.monotonic() > end:
                self.fail(f"never {what() if callable(what) else what}")
            time.sleep(0.02)


class SparkplugHost:
    """What a host of Sparkplug B makes of the messages, with a decoder of protocol buffers of its own.

    Sources: Eclipse Sparkplug 3.0.0, chapters 4 and 6; Protocol Buffers, Encoding."""

    def __init__(self, subscriber):
        self.subscriber, self.seen, self.metrics, self.types, self.numbers = subscriber, set(), {}, {}, []
        self.node, self.died_with = None, None

    def value(self, machine, name):
        return self.metrics.get(machine, {}).get(name)

    def next(self):
        topic, payload, retained = self.subscriber.receive_bytes()
        _, _, kind, self.node, *device = topic.split("/")
        if kind == "NCMD":
            return self.next()
        assert not retained
        fields, machine = decoded(payload), device[0] if device else ""
        told = dict(self.metric(machine, kind, bytes_) for bytes_ in fields.get(2, []))
        self.seen.add(kind)
        if kind == "NDEATH":
            self.died_with = told["bdSeq"]
            return True
        # Numbers count up from the birth of the node on: 0 to 255 and again.
        number = fields[3][0]
        assert number == (0 if kind == "NBIRTH" else (self.numbers[-1] + 1) % 256), (kind, number)
        self.numbers.append(number)
        if kind.endswith("BIRTH"):
            self.metrics[machine] = {}
        assert kind.endswith("BIRTH") or set(told) <= set(self.metrics[machine]), "data that no birth has named"
        self.metrics[machine].update(told)
        return True

    def metric(self, machine, kind, payload):
        fields = decoded(payload)
        name, type_ = fields[1][0].decode(), fields[4][0]
        if kind.endswith("BIRTH"):
            self.types[machine, name] = type_
        assert self.types.get((machine, name), type_) == type_, "a type that the birth did not tell"
        if fields.get(7):
            return name, None
        return name, {8: lambda: fields[11][0], 10: lambda: struct.unpack("<d", fields[13][0])[0],
                      11: lambda: bool(fields[14][0]), 12: lambda: fields[15][0].decode()}[type_]()


def decoded(payload):
    """Fields by number: integers, or bytes of whatever has a length or eight bytes."""
    fields, place = {}, 0

    def integer():
        nonlocal place
        value = shift = 0
        while True:
            byte = payload[place]
            place += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    while place < len(payload):
        key = integer()
        if key & 7 == 0:
            value = integer()
        else:
            size = {1: lambda: 8, 2: integer, 5: lambda: 4}[key & 7]()
            value = payload[place:place + size]
            place += size
        fields.setdefault(key >> 3, []).append(value)
    return fields


def rebirth_command():
    name = b"Node Control/Rebirth"
    metric = b"\x0a" + bytes([len(name)]) + name + b"\x20\x0b" + b"\x70\x01"
    return b"\x12" + bytes([len(metric)]) + metric


class Received:
    """What a subscriber makes of events, with a session that outlives its connections and the broker."""

    def __init__(self, port):
        self.port, self.numbers, self.repeated, self.ended = port, set(), 0, False
        self.late = []  # behind a higher number
        self.ends = {"mill": set(), "lathe": set()}
        self.thread = threading.Thread(target=self.follow)

    def end(self):
        self.ended = True
        if self.thread.is_alive():
            self.thread.join()

    def follow(self):
        while not self.ended:
            try:
                with Subscriber(self.port, "cell/+/event/#", clean=False, name="history") as subscriber:
                    subscriber.socket.settimeout(1)
                    while not self.ended:
                        self.take(*subscriber.receive()[:2])
            except OSError:
                time.sleep(0.05)

    def take(self, topic, text):
        content = json.loads(text)
        if content["seq"] in self.numbers:
            self.repeated += 1
            return
        if content["seq"] < max(self.numbers, default=0):
            self.late.append(content["seq"])
        self.numbers.add(content["seq"])
        _, machine, _, kind = topic.split("/")
        if kind == "run_ended":
            self.ends[machine].add(content["number"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
