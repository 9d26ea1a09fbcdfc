#!/usr/bin/env python3
"""Results of a running daemon against the schemas of its own rpc.discover.

usage: result_schemas_test.py STANOKD STANOK MACHINE_FILE. Every method that only looks is called, and those that
change something and are safe to repeat: while the machine is off, while a program runs, with an alarm. 77: no
python3-jsonschema.
"""
import json
import os
import socket
import subprocess
import sys
import tempfile
import time

try:
    import jsonschema
except ImportError:
    print("SKIPPED: python3-jsonschema is not here")
    sys.exit(77)

PROGRAM = "S1000 M3\nfor (num turn = 0; turn < 1000; turn++) {\nG1 X5 F600\nX0\n}\nM30\n"


class Daemon:
    """One daemon with embedded drives, and a connection to it."""

    def __init__(self, stanokd, machine_file, folder):
        with open(os.path.join(folder, "part.nc"), "w", encoding="utf-8") as program:
            program.write(PROGRAM)
        path = os.path.join(folder, "op.sock")
        self.process = subprocess.Popen(
            [stanokd, "--machine", machine_file, "--drives", "embedded", "--lcm", "off", "--state",
             os.path.join(folder, "state"), "--socket", path, "--program-root", folder],
            stderr=subprocess.DEVNULL)
        self.socket = socket.socket(socket.AF_UNIX)
        for _ in range(600):
            try:
                self.socket.connect(path)
                break
            except OSError:
                if self.process.poll() is not None:
                    sys.exit("FAILED: the daemon did not start")
                time.sleep(0.05)
        self.lines = self.socket.makefile("r", encoding="utf-8")
        self.last_id = 0

    def call(self, method, **parameters):
        self.last_id += 1
        request = {"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": parameters}
        self.socket.sendall((json.dumps(request) + "\n").encode())
        while True:
            message = json.loads(self.lines.readline())
            if message.get("id") == self.last_id:
                return message

    def result(self, method, **parameters):
        message = self.call(method, **parameters)
        if "error" in message:
            sys.exit(f"FAILED: {method}: {message['error']}")
        return message["result"]


def main():
    stanokd, _, machine_file = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as folder:
        daemon = Daemon(stanokd, machine_file, folder)
        try:
            check(daemon)
        finally:
            daemon.process.kill()
            daemon.process.wait()


def check(daemon):
    schemas = {method["name"]: method["result"]["schema"]
               for method in daemon.result("rpc.discover")["methods"]}
    for name, schema in schemas.items():
        jsonschema.Draft7Validator.check_schema(schema)
        if not schema:
            sys.exit(f"FAILED: {name} has no schema of its result")
    seen = set()

    def ask(method, **parameters):
        jsonschema.validate(daemon.result(method, **parameters), schemas[method])
        seen.add(method)

    looking = ["machine.status", "channel.list", "channel.status", "program.list", "program.history",
               "kinematics.list", "kinematics.status", "drive.list", "drive.status", "alarm.list",
               "alarm.history", "tool.list", "tool.save", "offset.list", "process.status",
               "workpiece.status", "log.status", "system.info", "rpc.discover"]

    def look():
        for method in looking:
            ask(method)

    look()
    ask("tool.load", tables="[[tool]]\nnumber = 1\nlength = 5\n[offset.G55]\nX = 1\n")
    ask("tool.get", number=1)
    ask("tool.set", number=1, key="length", value=10)
    ask("offset.set", offset="G54", axis="X", value=0)
    ask("override.feed", percent=90)
    ask("log.start")
    ask("log.stop")
    ask("machine.on")
    ask("home")
    ask("program.load", program="part.nc", wait="done")
    ask("program.search", target="3")
    ask("program.reset")
    ask("mdi", text="G90", wait="done")
    ask("workpiece.allow", on=1)
    ask("channel.control", on=1)
    ask("channel.control", on=0)
    ask("program.run", program="part.nc")
    while not daemon.result("channel.status")["to_go"]:
        time.sleep(0.05)
    look()
    ask("program.hold")
    ask("program.stop")
    ask("alarm.ack")
    ask("machine.off")
    daemon.call("program.run", program="missing.nc")
    look()
    ask("session.role", role="observer")
    print(f"{len(seen)} of {len(schemas)} methods: their results are as their schemas say")


main()
