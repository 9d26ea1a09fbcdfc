#!/usr/bin/env python3
"""How long a stop takes to reach the axes of a daemon that others keep busy.

Starts stanokd with embedded drives. N times: a program runs, a new client connects and sends program.hold, and the
time from its first system call to the answer is taken, which comes behind the cycle that took the stop; the fourth row
adds a load of the tool table of TABLE_KB that the operator server works on for seconds. Rows: nobody else; 1,000 rude clients (64 hold
all places and ask without pause, the others knock again and again or dangle); the same with standard error that
nobody reads, a full pipe; the same with the table; nobody else on the socket, but on every processor another program
that computes with real-time priority FIFO_OF_HOGS (needs the right to it; the measuring client takes one more).

usage: stop_latency_figures.py STANOKD MACHINE_FILE [STOPS]      (default 200 a row)
"""
import contextlib
import multiprocessing
import os
import selectors
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "support"))
from running_daemon import Operator, allow_many_descriptors, connect, request, running_daemon  # noqa: E402

ASKING, KNOCKING = 64, 936
TABLE_KB = 900
FIFO_OF_HOGS = 50
PROGRAM = "G21 G90 G17 G54\nG64 P0.01\n%sM30\n" % ("G1 X40 F3000\nG3 X0 Y0 I-20\n" * 20000)


def crowd(path, ready):
    """64 that ask without pause, from the places they hold; 936 that find none: half of them knock again when they are
    let go, half are silent until then."""
    allow_many_descriptors()
    selector = selectors.DefaultSelector()
    question = request(1, "machine.status")
    for k in range(ASKING + KNOCKING):
        one = connect(path)
        one.setblocking(False)
        selector.register(one, selectors.EVENT_READ, k)
        one.send(question)
    ready.set()
    while True:
        for key, _ in selector.select(0.05):
            one = key.fileobj
            try:
                text = one.recv(65536)
                if text and key.data < ASKING:
                    one.send(question)
            except BlockingIOError:
                continue
            except ConnectionError:
                text = b""
            if not text:
                selector.unregister(one)
                one.close()
                again = connect(path)
                again.setblocking(False)
                selector.register(again, selectors.EVENT_READ, key.data)
                if key.data % 2 == 0:
                    again.send(question)


def table():
    rows, number = ["[tool.1.1]\nlength = 1.5\n"], 1
    while sum(map(len, rows)) < TABLE_KB * 1000:
        number += 1
        rows += [f"[tool.{number + k}.1]\nlength = {k}.25\nradius = 2.5\nwear_length = 0.125\n" for k in range(100)]
        number += 99
    return "".join(rows)[: TABLE_KB * 1000].rsplit("[", 1)[0]


def hog(processor):
    """Computes on one processor before everything of lower priority."""
    os.sched_setaffinity(0, {processor})
    os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(FIFO_OF_HOGS))
    while True:
        pass


def measure_hogged(stanokd, machine, stops):
    hogs = [multiprocessing.Process(target=hog, args=(k,), daemon=True) for k in sorted(os.sched_getaffinity(0))]
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(FIFO_OF_HOGS + 1))
    except PermissionError:
        return print("real-time hogs on every processor: no right to FIFO scheduling")
    try:
        measure("real-time hogs on every processor", stanokd, machine, stops, False, False, False, hogs)
    finally:
        for one in hogs:
            one.terminate()
            one.join()
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


def stop_once(path):
    """Seconds from nothing to the answer of a hold."""
    begin = time.monotonic()
    Operator(path).answer("program.hold", channel=1)
    return time.monotonic() - begin


@contextlib.contextmanager
def pipe_that_nobody_reads():
    """The end to write to of a pipe that is full."""
    read_end, write_end = os.pipe()
    os.set_blocking(write_end, False)
    try:
        while True:
            os.write(write_end, b"x" * 4096)
    except BlockingIOError:
        os.set_blocking(write_end, True)
    try:
        yield write_end
    finally:
        os.close(read_end)
        os.close(write_end)


@contextlib.contextmanager
def rude_clients(path):
    ready = multiprocessing.Event()
    rude = multiprocessing.Process(target=crowd, args=(path, ready), daemon=True)
    rude.start()
    ready.wait()
    try:
        yield
    finally:
        rude.terminate()
        rude.join()


def seconds_of_stops(path, stops, load_table):
    seconds = []
    for k in range(stops):
        if k % 20 == 0 and load_table():
            time.sleep(0.1)
        seconds.append(stop_once(path))
        time.sleep(0.02)
    return sorted(seconds)


def measure(title, stanokd, machine, stops, crowded, unread, loading, hogs=()):
    with contextlib.ExitStack() as stack:
        error = stack.enter_context(pipe_that_nobody_reads()) if unread else subprocess.DEVNULL
        path = stack.enter_context(running_daemon(stanokd, machine, PROGRAM, error)).socket_path
        time.sleep(0.5)
        operator = Operator(path)
        operator.ask("machine.on")
        time.sleep(1.0)
        operator.ask("program.run", program="part.nc", channel=1)
        if crowded:
            stack.enter_context(rude_clients(path))
        load = request(99, "tool.load", tables=table(), file="rude")
        for one in hogs:
            one.start()
        seconds = seconds_of_stops(path, stops, lambda: loading and not operator.socket.sendall(load))
        last = len(seconds) - 1
        row = [seconds[int(last * part)] * 1e3 for part in (0.5, 0.99, 1.0)]
        print(f"{title:45} {row[0]:8.2f} {row[1]:8.2f} {row[2]:8.2f}", flush=True)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    stanokd, machine = sys.argv[1:3]
    stops = int(sys.argv[3]) if len(sys.argv) > 3 else 200
    print(f"{'from connecting to the answer of a hold, ms':45} {'p50':>8} {'p99':>8} {'max':>8}")
    measure("nobody else", stanokd, machine, stops, False, False, False)
    measure("1,000 rude clients", stanokd, machine, stops, True, False, False)
    measure("the same, and a log that nobody reads", stanokd, machine, stops, True, True, False)
    measure("the same, and a tool table of 900 kB", stanokd, machine, stops, True, True, True)
    measure_hogged(stanokd, machine, stops)


main()
