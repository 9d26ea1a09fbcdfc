#!/usr/bin/env python3
"""What a thousand clients do to the cycle of a daemon that runs a program.

Starts stanokd with embedded drives, lets a program run for SECONDS without clients and for SECONDS with
1,000 of them: 40 ask for the state of the channel again and again, 10 have subscribed to it and never
read, 10 send a request a byte at a time, 940 find no place and knock again and again. Prints percentiles of the computing time of a cycle and of its
wake-up latency, overruns, and the largest resident memory of the daemon.

usage: many_clients_figures.py STANOKD MACHINE_FILE [SECONDS]      (default 60)
"""
import os
import selectors
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "support"))
from running_daemon import Operator, allow_many_descriptors, connect, request, running_daemon  # noqa: E402

CLIENTS = {"asking": 40, "silent": 10, "slow": 10, "knocking": 940}
PROGRAM = "G21 G90 G17 G54\nG64 P0.01\n%sM30\n" % ("G1 X40 F3000\nG3 X0 Y0 I-20\n" * 2000)


class Crowd:
    """The clients, driven from one loop. The daemon has places for 64; whoever finds none knocks again."""

    def __init__(self, path):
        self.path, self.selector = path, selectors.DefaultSelector()
        self.answers, self.refusals, self.byte = 0, 0, 0
        self.status = request(1, "channel.status", channel=1)
        self.drip = request(2, "system.info")
        self.slow = [connect(path) for _ in range(CLIENTS["slow"])]
        self.silent = [connect(path) for _ in range(CLIENTS["silent"])]
        for one in self.silent:
            one.sendall(request(1, "subscribe", topics=["machine", "channels"], rate_hz=50))
        for _ in range(CLIENTS["asking"]):
            self.add("asking").send(self.status)
        for _ in range(CLIENTS["knocking"]):
            self.add("knocking")

    def add(self, kind):
        one = connect(self.path)
        one.setblocking(False)
        self.selector.register(one, selectors.EVENT_READ, kind)
        return one

    def serve(self, one, kind):
        try:
            text = one.recv(65536)
        except ConnectionError:
            text = b""
        if text and kind == "asking":
            self.answers += text.count(b"\n")
            one.send(self.status)
        elif not text:
            if kind == "asking":
                sys.exit("a client that asks was dropped")
            self.refusals += 1
            self.selector.unregister(one)
            one.close()
            self.add(kind)

    def drip_on(self):
        for k, one in enumerate(self.slow):
            try:
                one.send(self.drip[self.byte % len(self.drip):][:1])
            except OSError:  # the daemon ends a frame that takes too long
                one.close()
                self.slow[k] = connect(self.path)
        self.byte += 1

    def run(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for key, _ in self.selector.select(0.05):
                self.serve(key.fileobj, key.data)
            self.drip_on()


def resident_mb(pid):
    with open(f"/proc/{pid}/status") as status:
        kb = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
    return kb / 1024


def show(title, status, pid):
    rt = status["rt"]
    row = [f"{title:18}"]
    for key in ("cycle_us", "latency_us"):
        row += [f"{rt[key][p]:9.1f}" for p in ("p50", "p99", "p999", "max")]
    row.append(f"{rt['overruns']:9d} {resident_mb(pid):9.0f}")
    print(" ".join(row), flush=True)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    stanokd, machine = sys.argv[1:3]
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 60.0
    allow_many_descriptors()
    print(f"{'':18} {'cycle us: p50':>9} {'p99':>9} {'p99.9':>9} {'max':>9} {'late us: p50':>9}"
          f" {'p99':>9} {'p99.9':>9} {'max':>9} {'overruns':>9} {'MB':>9}")
    for title, crowded in (("no clients", False), ("1,000 clients", True)):
        with running_daemon(stanokd, machine, PROGRAM) as daemon:
            time.sleep(0.5)
            operator = Operator(daemon.socket_path)
            operator.ask("machine.on")
            time.sleep(1.0)
            operator.ask("program.run", program="part.nc", channel=1)
            if crowded:
                crowd = Crowd(daemon.socket_path)
                crowd.run(seconds)
                title += f", {crowd.answers / seconds:.0f} answers/s, {crowd.refusals / seconds:.0f} refusals/s"
            else:
                time.sleep(seconds)
            show(title, operator.ask("machine.status"), daemon.process.pid)
            operator.ask("system.shutdown")
            daemon.process.wait(20)


main()
