#!/usr/bin/env python3
"""Requests that a network keeps, doubles and reorders, against a running daemon.

usage: late_requests_test.py STANOKD MACHINE_FILE [REQUESTS]

Increments of a jog, each with the cycle that was seen before it was sent, go over connections that keep them for up to
a second. What was kept longer than half a second moves nothing; what is taken moves the axis by one increment.
"""
import os
import random
import sys
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

INCREMENT = 0.002
AGE_MAX_S = 0.5
SEED = 20261129


class Network:
    """Connections that each keep what they are given for a time of their own."""

    def __init__(self, path, random_source):
        self.path, self.random = path, random_source
        self.lock = threading.Lock()
        self.answers = []  # how long it was kept, the code of the refusal or None

    def carry(self, seen):
        copies = 2 if self.random.random() < 0.1 else 1
        delays = [self.random.uniform(0.0, 2.0 * AGE_MAX_S) for _ in range(copies)]
        threads = [threading.Thread(target=self.keep, args=(seen, time.monotonic(), delay)) for delay in delays]
        for thread in threads:
            thread.start()
        return threads

    def keep(self, seen, sent, delay):
        with_its_own = Operator(self.path)
        time.sleep(max(0.0, sent + delay - time.monotonic()))
        kept = time.monotonic() - sent
        answer = with_its_own.answer("jog", axis="X", velocity=50.0, increment=INCREMENT, seen_cycle=seen)
        with_its_own.close()
        with self.lock:
            self.answers.append((kept, answer["error"]["data"]["code"] if "error" in answer else None))


def test(daemon, requests):
    operator = Operator(daemon.socket_path)
    operator.ask("machine.on")
    operator.ask("home")
    begin = operator.ask("channel.status")["axes"]["X"]["position"]
    network = Network(daemon.socket_path, random.Random(SEED))
    under_way = []
    for _ in range(requests):
        under_way += network.carry(operator.ask("machine.status")["cycle"])
        under_way = [thread for thread in under_way if thread.is_alive()]
        while len(under_way) > 40:
            time.sleep(0.01)
            under_way = [thread for thread in under_way if thread.is_alive()]
    for thread in under_way:
        thread.join()
    while not operator.ask("machine.status")["idle"]:
        time.sleep(0.02)
    moved = operator.ask("channel.status")["axes"]["X"]["position"] - begin
    old = [code for kept, code in network.answers if kept >= AGE_MAX_S]
    taken = sum(code is None for _, code in network.answers)
    print(f"{len(network.answers)} requests, {len(old)} older than {AGE_MAX_S} s, {taken} taken, moved {moved:.4f} mm")
    assert old and set(old) == {"E6073"}, f"taken although it was old: {set(old)}"
    assert taken > requests // 50, "nothing is taken at all"
    assert {code for _, code in network.answers} <= {None, "E6056", "E6073"}
    assert abs(moved - taken * INCREMENT) < 0.5 * INCREMENT, "moved by something else"


def main():
    stanokd, machine_file = sys.argv[1:3]
    requests = int(sys.argv[3]) if len(sys.argv) > 3 else 400
    with running_daemon(stanokd, machine_file, "M30\n", impatient=True) as daemon:
        test(daemon, requests)


if __name__ == "__main__":
    main()
