#!/usr/bin/env python3
"""At a stop of each kind OPC UA and MQTT show what the status of the same situation says, on a lathe: a real daemon,
stanok-opcua and stanok-gateway with a broker.

usage: stops_test.py STANOKD MACHINE_FILE FOLDER_OF_OPCUA GATEWAY [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import contextlib
import json
import os
import socket
import sys
import threading
import time

GATEWAY = sys.argv.pop(4)
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_broker import Broker, Subscriber  # noqa: E402
from running_gateway import running_gateway  # noqa: E402
from served_machine import PATIENCE_S, ServedMachine, main  # noqa: E402

LINES = [
    "G21 G90 G18 G7 G40 G54",  # 1
    "T0101",                   # 2
    "G97 S400 M3",             # 3
    "M8",                      # 4
    "G0 X300 Z300",            # 5
    "M0",                      # 6
    "M9",                      # 7
    "G55 G20",                 # 8
    "M1",                      # 9
    "G21",                     # 10
    "G0 X290 M5",              # 11
    "G94 G91 G1 Z-20 F600",    # 12
    "M30",                     # 13
]
PROGRAM_MEMBERS = ("program", "file", "line", "block", "situation", "g_codes", "m_codes", "work_offset", "coolant", "tool")
POSITION_MEMBERS = ("position", "to_go", "situation", "units", "diameter")


class Newest:
    """The newest content of each topic of the machine."""

    def __init__(self, port):
        self.content = {}
        self.subscriber = Subscriber(port, "cell/mill/#")
        self.thread = threading.Thread(target=self.receive)
        self.thread.start()

    def receive(self):
        with self.subscriber, contextlib.suppress(OSError):
            while True:
                topic, text, _ = self.subscriber.receive()
                self.content[topic] = json.loads(text)

    def end(self):
        self.subscriber.socket.shutdown(socket.SHUT_RDWR)
        self.thread.join()

    def of_channel(self, topic):
        return self.content.get(f"cell/mill/{topic}", {}).get("channels", {}).get("1", {})


class Stops(ServedMachine):
    def setUp(self):
        super().setUp()
        with open(os.path.join(self.folder, "stops.nc"), "w", encoding="utf-8") as file:
            file.write("\n".join(LINES) + "\n")
        broker = Broker(self.folder)
        self.stack.callback(broker.end)
        self.newest = Newest(broker.port)
        self.stack.callback(self.newest.end)
        self.stack.enter_context(running_gateway(GATEWAY, self.folder, {"mill": self.machine.socket}, broker.port))
        self.opcua = self.client(self.server())

    def stand(self, line, held_by):
        """The status once the channel stands there."""
        return self.machine.until(
            lambda status: status["state"] != "Active" and status["line"] == line and status["held_by"] == held_by
            and status["speed_mm_s"] == 0.0)

    def of_opcua(self, status):
        """What the nodes of the channel must be."""
        nodes = {
            "Situation": status["situation"], "Units": status["units"], "Diameters": status["diameter"],
            "File": status["file"], "Line": status["line"], "ActiveCodes": status["g_codes"] + status["m_codes"],
            "WorkOffset": status["work_offset"], "Coolant": status["coolant"], "Tool": status["tool"]["number"],
            "ToolEdge": status["tool"]["edge"],
        }
        for word, value in status["position"].items():
            nodes[f"Position{word}"] = value
            nodes[f"ToGo{word}"] = status["to_go"] and status["to_go"][word]
        nodes = {f"Monitoring/Channel1/{name}": value for name, value in nodes.items()}
        nodes["Monitoring/Spindle1/CommandedSpeed"] = status["spindles"][0]["commanded_rev_min"]
        return nodes

    def shown_by_opcua(self, wanted):
        nodes = self.opcua.ask(tree="ns=8;s=mill")
        found = {}
        for path in wanted:
            node = nodes.get(path, {})
            found[path] = None if node.get("status") == "BadNoData" else node.get("value")
        return found

    def assert_shown_alike(self, what, read_status):
        """Status, OPC UA and MQTT, as soon as they tell of the same situation: nothing moves."""
        end = time.monotonic() + PATIENCE_S
        while True:
            status = read_status()
            wanted = self.of_opcua(status)
            found = self.shown_by_opcua(wanted)
            program = {name: status[name] for name in PROGRAM_MEMBERS}
            program["spindles"] = [{name: one[name] for name in ("id", "direction", "commanded_rev_min")}
                                   for one in status["spindles"]]
            positions = {name: status[name] for name in POSITION_MEMBERS}
            told = [{name: self.newest.of_channel(topic).get(name) for name in members}
                    for topic, members in (("program", program), ("positions", positions))]
            if (found, told) == (wanted, [program, positions]):
                return status
            if time.monotonic() > end:
                self.assertEqual(found, wanted, what)
                self.assertEqual(told, [program, positions], what)
            time.sleep(0.05)

    def test_each_kind_of_stop_is_shown_alike(self):
        machine = self.machine
        machine.insist("machine.on")
        machine.insist("program.optional_stop", on=1)
        machine.insist("program.run", program="stops.nc")
        self.stand(6, "program stop")
        status = self.assert_shown_alike("M0", lambda: self.stand(6, "program stop"))
        self.assertEqual((status["coolant"], status["diameter"], status["tool"]["number"]), (["flood"], ["X"], 1))
        self.assertEqual(status["position"]["X"], 2 * status["point_W"]["X"])
        machine.ask("program.start", situation=status["situation"])
        status = self.assert_shown_alike("M1", lambda: self.stand(9, "program stop"))
        self.assertEqual((status["coolant"], status["work_offset"], status["units"]), ([], "G55", "inch"))
        machine.ask("program.start", situation=status["situation"])
        machine.until(lambda now: now["line"] == 12 and now["to_go"]["Z"] > -18.0)
        machine.ask("program.hold")
        status = self.assert_shown_alike("hold", lambda: self.stand(12, "feed hold by an operator"))
        self.assertLess(status["to_go"]["Z"], 0.0)
        machine.ask("program.step", on=1)
        machine.ask("program.resume")
        self.assert_shown_alike("single block", lambda: self.stand(12, "single block"))
        machine.ask("program.step", on=0)
        machine.ask("program.start")
        self.assert_shown_alike("end", lambda: machine.until(lambda now: now["state"] == "Reset"))
        machine.insist("program.run", program="stops.nc")
        self.stand(6, "program stop")
        machine.ask("program.stop")
        status = self.assert_shown_alike("stop", lambda: machine.until(lambda now: now["state"] == "Reset"))
        self.assertEqual((status["line"], status["file"], status["work_offset"]), (0, None, "G54"))


if __name__ == "__main__":
    main()
