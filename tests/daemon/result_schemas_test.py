#!/usr/bin/env python3
"""Results of a running daemon against the schemas of its own rpc.discover.

usage: result_schemas_test.py STANOKD STANOK MACHINE_FILE. Every method that only looks is called, and those that
change something and are safe to repeat: while the machine is off, while a program runs, with an alarm. 77: no
python3-jsonschema.
"""
import os
import sys
import tempfile
import time

try:
    import jsonschema
except ImportError:
    print("SKIPPED: python3-jsonschema is not here")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402

PROGRAM = "S1000 M3\nfor (num turn = 0; turn < 1000; turn++) {\nG1 X5 F600\nX0\n}\nM30\n"


def main():
    stanokd, _, machine_file = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as logs, \
            running_daemon(stanokd, machine_file, PROGRAM, options=("--log", logs)) as daemon:
        check(Operator(daemon.socket_path))


def only_looks(method):
    """Whether every observer may call the method as it is, and again and again."""
    needs = any(parameter["required"] for parameter in method["params"])
    return method["x-role"] == "observer" and not needs and method["name"] != "channel.watch"


def check(operator):
    methods = operator.ask("rpc.discover")["methods"]
    schemas = {method["name"]: method["result"]["schema"] for method in methods}
    for name, schema in schemas.items():
        jsonschema.Draft7Validator.check_schema(schema)
        if not schema:
            sys.exit(f"FAILED: {name} has no schema of its result")
    seen = set()

    def ask(method, /, **parameters):
        result = operator.ask(method, **parameters)
        jsonschema.validate(result, schemas[method])
        seen.add(method)
        return result

    looking = [method["name"] for method in methods if only_looks(method)]

    def look():
        for method in looking:
            ask(method)

    look()
    ask("program.read", program="part.nc")
    written = operator.ask("program.write", program="new.nc", text="G0 X1\nM30\n")
    ask("program.write", program="new.nc", text="G0 X2\nM30\n", version=written["version"])
    ask("program.check", program="new.nc")
    ask("program.check", program="new.nc", text="G1 X1\nthis is none\nM30\n")
    ask("program.estimate", program="new.nc")
    ask("program.remove", program="new.nc", version="any")
    ask("tool.load", tables="[[tool]]\nnumber = 1\nlength = 5\n[offset.G55]\nX = 1\n")
    ask("tool.get", number=1)
    ask("tool.set", number=1, key="length", value=10)
    ask("offset.set", offset="G54", axis="X", value=0)
    ask("override.feed", percent=90)
    ask("log.stop")
    log = ask("history.logs")["logs"][0]["file"]
    ask("history.verify", file=log)
    ask("history.path", file=log)
    ask("log.start")
    ask("log.stop")
    entry = ask("queue.add", program="new.nc")["queues"][0]["programs"][0]["id"]
    ask("queue.move", id=entry, place=1)
    ask("queue.remove", id=entry)
    ask("machine.on")
    ask("home")
    ask("program.load", program="part.nc", wait="done")
    ask("program.search", target="3")
    ask("program.reset")
    ask("mdi", text="G90", wait="done")
    ask("workpiece.allow", on=1)
    ask("scope.start", signals="X.position cycle.time", trigger="alarm")
    ask("scope.stop")
    ask("scope.read")
    ask("channel.control", on=1)
    ask("channel.control", on=0)
    ask("program.run", program="part.nc")
    while not operator.ask("channel.status")["to_go"]:
        time.sleep(0.05)
    look()
    ask("program.hold")
    ask("program.stop")
    ask("alarm.ack")
    ask("machine.off")
    operator.answer("program.run", program="missing.nc")
    look()
    ask("session.role", role="observer")
    print(f"{len(seen)} of {len(schemas)} methods: their results are as their schemas say")


main()
