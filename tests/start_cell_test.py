#!/usr/bin/env python3
"""./start --cell: three machines work, are told to the broker and written into the history, and have one page; at
Ctrl-C all of it ends.

usage: start_cell_test.py SOURCE_FOLDER       exit code 77: mosquitto is not installed
"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import urllib.request

SOURCE = sys.argv[1]
CELL = os.path.join(SOURCE, "build", "cell")
BIN = os.path.join(SOURCE, "build", "release", "bin")
MACHINES = {"mill", "lathe", "trunnion"}
PATIENCE_S = 240

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "support"))
from running_broker import Subscriber  # noqa: E402


def processes_of_cell():
    """Whose arguments name the folder of the cell: [(process, command)]."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/cmdline", "rb") as file:
                command = file.read().replace(b"\0", b" ").decode()
            same_place = os.path.samefile(f"/proc/{name}/cwd", SOURCE)
        except OSError:
            continue
        if "build/cell" in command and same_place and int(name) != os.getpid():
            found.append((name, command))
    return found


def until(condition, what):
    end = time.monotonic() + PATIENCE_S
    while not (answer := condition()):
        assert time.monotonic() < end, f"never {what}"
        time.sleep(0.5)
    return answer


class Page:
    """What a browser gets behind the link that was printed, with the cookie and the key of the session."""

    def __init__(self, link):
        self.server = link[1]
        self.opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        self.fields = {"Content-Type": "application/json", "Origin": self.server}
        self.fields["X-Stanok-Key"] = json.loads(self.post("/api/session", {"token": link[2]}))["key"]

    def get(self, path):
        return self.ask(path, None)

    def post(self, path, content):
        return self.ask(path, json.dumps(content).encode())

    def ask(self, path, body):
        request = urllib.request.Request(self.server + path, body, self.fields)
        with self.opener.open(request) as answer:
            return answer.read()


def main():
    start = subprocess.Popen([os.path.join(SOURCE, "start"), "--cell", "--no-install"], stdout=subprocess.PIPE, text=True)
    said = ""
    while "work until Ctrl-C" not in said:
        line = start.stdout.readline()
        assert line, said
        said += line
    try:
        page = Page(re.search(r"(http://127\.0\.0\.1:\d+)/#(\S+)", said))
        assert b"<html" in page.get("/")
        machines = json.loads(page.get("/api/machines"))["machines"]
        assert {one["id"] for one in machines if one["answers"]} == MACHINES, machines
        port = int(re.search(r"mosquitto_sub -p (\d+)", said)[1])
        running = set()
        with Subscriber(port, "cell/+/state") as subscriber:
            while running != MACHINES:
                topic, text, _ = subscriber.receive()
                channels = json.loads(text).get("channels", {})
                if any(channel["program_status"] == "Running" for channel in channels.values()):
                    running.add(topic.split("/")[1])

        def good_run():
            answer = subprocess.run([os.path.join(BIN, "stanok"), "history", "runs", "--since", "1h", "--json",
                                     "--database", os.path.join(CELL, "gateway", "history.sqlite")],
                                    capture_output=True, text=True)
            return answer.returncode == 0 and '"ok":true' in re.sub(r"\s", "", answer.stdout)

        until(good_run, "a run in the history")
        runs = json.loads(page.post("/api/history", {"query": "runs", "since": "1h"}))
        assert runs["rows"], runs
    finally:
        start.send_signal(signal.SIGINT)
        said, _ = start.communicate(timeout=60)
    assert start.returncode == 0, f"./start ended with {start.returncode}: {said}"
    assert "Everything has ended" in said, said
    assert not processes_of_cell(), processes_of_cell()
    print("passed")


if __name__ == "__main__":
    if not (shutil.which("mosquitto") or os.path.exists("/usr/sbin/mosquitto")):
        print("left out: mosquitto is not installed")
        sys.exit(77)
    main()
