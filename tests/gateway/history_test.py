#!/usr/bin/env python3
"""The history of a gateway in SQLite and in PostgreSQL: nothing is lost by a database that is away, both engines
answer alike, and a month of ten machines is asked in time.

usage: history_test.py GATEWAY STANOK STANOKD MACHINE_FILE AWAY_S [unittest arguments]
AWAY_S: how long the server of the database is away under runs.
"""
import contextlib
import json
import os
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, Refused, running_daemon  # noqa: E402
from running_gateway import running_gateway  # noqa: E402
from running_postgres import Postgres, wait_until  # noqa: E402

GATEWAY, STANOK, STANOKD, MACHINE, AWAY_S = (sys.argv.pop(1) for _ in range(5))
PROGRAM = "T1 M6\nG1 X1 F3000\nX0\nM30\n"
DAY_S = 86400
MACHINES, DAYS, RUNS_OF_A_DAY = 10, 30, 288
ANSWER_MAX_S = 0.2


def history(*words):
    """What `stanok history` answers, and how long it took."""
    begun = time.monotonic()
    done = subprocess.run([STANOK, "history", *words, "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return json.loads(done.stdout), time.monotonic() - begun


def rounded(value):
    """Sums of the engines differ in their last digits: each adds in an order of its own."""
    if isinstance(value, dict):
        return {name: rounded(one) for name, one in value.items()}
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return float(f"{value:.9g}") if isinstance(value, float) else value


class History(unittest.TestCase):
    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.addCleanup(self.stack.close)
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory(dir="/tmp"))

    def postgres(self):
        server = Postgres(self.folder)
        self.stack.callback(server.end)
        return server

    def machine(self):
        daemon = self.stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM))
        operator = Operator(daemon.socket_path)
        self.stack.callback(operator.socket.close)
        self.stack.callback(operator.lines.close)
        self.insist(operator, "machine.on")
        return daemon, operator

    @staticmethod
    def insist(operator, method, **parameters):
        end = time.monotonic() + 30
        while True:
            try:
                return operator.ask(method, **parameters)
            except Refused:
                if time.monotonic() > end:
                    raise
                time.sleep(0.05)

    def test_runs_of_a_machine_are_in_sqlite(self):
        daemon, operator = self.machine()
        file = os.path.join(self.folder, "gateway", "history.sqlite")
        with running_gateway(GATEWAY, self.folder, {"mill": daemon.socket_path}, None):
            for _ in range(3):
                self.insist(operator, "program.run", program="part.nc", wait="done")
            self.insist(operator, "program.run", program="part.nc", wait="done")
            wait_until(lambda: os.path.exists(file) and len(self.runs(file)) == 4, "four runs")
        told = operator.ask("program.history")["runs"]
        for run, wanted in zip(reversed(self.runs(file)), told):
            self.assertEqual((run["machine"], run["program"], run["ok"]), ("mill", "part.nc", True))
            self.assertEqual((run["time_s"], run["path_mm"], run["blocks"]),
                             (wanted["time_s"], wanted["path_mm"], wanted["blocks"]))
        oee, _ = history("oee", "--database", file, "--since", "1h")
        self.assertEqual((oee["oee"][0]["runs"], oee["oee"][0]["quality"]), (4, 1))

    @staticmethod
    def runs(database):
        try:
            return history("runs", "--database", database)[0]["runs"]
        except RuntimeError:
            return []

    def test_a_server_that_is_away_loses_nothing(self):
        server = self.postgres()
        daemon, operator = self.machine()
        made, ended = [0], threading.Event()

        def work():
            while not ended.is_set():
                self.insist(operator, "program.run", program="part.nc", wait="done")
                made[0] += 1
        worker = threading.Thread(target=work)
        with running_gateway(GATEWAY, self.folder, {"mill": daemon.socket_path}, None,
                             ("--history", server.address)):
            worker.start()
            wait_until(lambda: self.runs(server.address), "a run in the history")
            server.kill()
            time.sleep(float(AWAY_S))
            server.start()
            ended.set()
            worker.join()
            wait_until(lambda: len(self.runs(server.address)) >= min(made[0], 1000), f"all {made[0]} runs")
        told = operator.ask("program.history")
        self.assertEqual(made[0], len(told["runs"]) + told.get("forgotten", 0))
        self.assertEqual(len(self.runs(server.address)), made[0])
        print(f"{made[0]} runs, the database away for {AWAY_S} s: all of them in it, each once")

    def test_a_month_of_ten_machines_is_asked_in_time(self):
        """Both engines say the same, and what a formula over the same entries says; within 200 ms."""
        file, server = os.path.join(self.folder, "month.sqlite"), self.postgres()
        self.make_month(file)
        counts, copied_s = history_copy(file, server.address)
        self.assertEqual(counts["runs"], MACHINES * DAYS * RUNS_OF_A_DAY)
        lines = [f"copied in {copied_s:.1f} s"]
        for query in ("runs", "alarms", "oee", "tools", "drift"):
            for scope in ((), ("--machine", "m3")):
                answers = []
                for database in (file, server.address):
                    best = min((history(query, "--database", database, "--since", "40d", *scope)
                                for _ in range(3)), key=lambda one: one[1])
                    answers.append(best)
                if query != "oee":
                    self.assertEqual(*(rounded(answer) for answer, _ in answers))
                lines.append(f"{query} {' '.join(scope)}: SQLite {1e3 * answers[0][1]:.0f} ms, "
                             f"PostgreSQL {1e3 * answers[1][1]:.0f} ms")
                self.assertLess(max(seconds for _, seconds in answers), ANSWER_MAX_S * PATIENCE, lines[-1])
        drift = history("drift", "--database", file, "--since", "40d", "--machine", "m3")[0]["drift"][0]
        # A run of day d takes 100 s + d / 3 s; the first quarter of them are days 0 to 6 and half of day 7, the last
        # one half of day 22 and days 23 to 29. One run in fifty, which did not end well, does not count.
        first_s = 100 + (sum(range(7)) + 7 / 2) / 7.5 / 3
        last_s = 100 + (22 / 2 + sum(range(23, 30))) / 7.5 / 3
        self.assertAlmostEqual(drift["first_s"], first_s, delta=0.02)
        self.assertAlmostEqual(drift["drift"], last_s / first_s - 1, delta=0.0004)
        tools = history("tools", "--database", server.address, "--since", "40d", "--machine", "m3")[0]["tools"]
        self.assertAlmostEqual(sum(tool["use_s"] for tool in tools), 60 * DAYS * RUNS_OF_A_DAY)
        back = os.path.join(self.folder, "back.sqlite")
        history_copy(server.address, back)
        history_copy(server.address, back)
        self.assertEqual(contents(file), contents(back))
        print("\n".join(lines))

    def make_month(self, file):
        """An empty history from the gateway itself, filled with what can be computed."""
        daemon = self.stack.enter_context(running_daemon(STANOKD, MACHINE, PROGRAM))
        with running_gateway(GATEWAY, self.folder, {"m": daemon.socket_path}, None, ("--history", file)):
            wait_until(lambda: os.path.exists(file) and history_is_there(file), "a history")
        begin = time.time() - DAYS * DAY_S
        runs, alarms, tools, number = [], [], [], 0
        for i in range(MACHINES):
            machine = f"m{i}"
            for k in range(DAYS * RUNS_OF_A_DAY):
                end = begin + (k + 1) * DAY_S / RUNS_OF_A_DAY - i
                took = 100 + 10 * int(k / RUNS_OF_A_DAY) / DAYS
                number += 1
                runs.append(("s", number, machine, 1, f"part{k % 5}.nc", "v1", end - took, end, took, 0.1 + k, 1000,
                             int(k % 50 != 0)))
                number += 1
                tools.append(("s", number, machine, end, k % 20 + 1, 60.0))
                if k % 14 == 0:
                    number += 1
                    alarms.append(("s", number, machine, end, 1, "A3001", "Störung", None, None))
        with contextlib.closing(sqlite3.connect(file)) as database:
            for table, rows in (("runs", runs), ("alarms", alarms), ("tool_use", tools)):
                places = ",".join("?" * len(rows[0]))
                database.executemany(f"INSERT INTO {table} VALUES ({places})", rows)
            database.commit()

    def test_what_is_older_than_wanted_is_removed(self):
        file = os.path.join(self.folder, "history.sqlite")
        with running_gateway(GATEWAY, self.folder, {"m": "/none.sock"}, None, ("--history", file)):
            wait_until(lambda: os.path.exists(file) and history_is_there(file), "a history")
        now = time.time()
        runs = [("s", days, "m", 1, "a.nc", "v", end - 9, end, 9.0, 1.0, 5, 1)
                for days in (1, 2, 3, 4) for end in [now - days * DAY_S + 60]]
        with contextlib.closing(sqlite3.connect(file)) as database:
            database.executemany(f"INSERT INTO runs VALUES ({','.join('?' * 12)})", runs)
            database.commit()
        with running_gateway(GATEWAY, self.folder, {"m": "/none.sock"}, None, ("--history", file, "--keep", "2d")):
            wait_until(lambda: len(self.runs(file)) == 2, "only two runs")

    def test_what_is_asked_wrongly_is_said(self):
        for words, wanted in ((("runs", "--database", "/none.sqlite"), "--database"),
                              (("runs", "--since", "yesterday"), "30d"),
                              (("copy", "postgresql://cell:secret@localhost/x", "/tmp/x"), "PGPASSFILE")):
            done = subprocess.run([STANOK, "history", *words], capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(wanted, done.stderr)


# A computer that runs other tests besides is slower; the figure itself is printed.
PATIENCE = 10


def history_is_there(file):
    try:
        history("runs", "--database", file)
        return True
    except RuntimeError:
        return False


def history_copy(source, target):
    begun = time.monotonic()
    done = subprocess.run([STANOK, "history", "copy", source, target, "--json"], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return json.loads(done.stdout), time.monotonic() - begun


def contents(file):
    with contextlib.closing(sqlite3.connect(file)) as database:
        return [database.execute(f"SELECT * FROM {table} ORDER BY source, number").fetchall()
                for table in ("runs", "alarms", "tool_use", "measurements")]


if __name__ == "__main__":
    unittest.main(verbosity=2)
