"""A daemon with simulated drives, stanok-opcua before it and a client of node-opcua, for the tests of the server: what
the nodes of the machine must be, by the specifications and by the protocol.

usage of the tests: TEST STANOKD MACHINE_FILE FOLDER_OF_OPCUA [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import contextlib
import functools
import os
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from companion_types import CompanionTypes  # noqa: E402
from running_daemon import Operator, Refused as DaemonRefused, patient_machine, wait_for_socket  # noqa: E402
from running_opcua import Client, Missing, packages, running_opcua  # noqa: E402

STANOKD, MACHINE, OPCUA = (sys.argv.pop(1) for _ in range(3))
PATIENCE_S = 30
MACHINE_TOOL = "http://opcfoundation.org/UA/MachineTool/"
ROOT = "ns=8;s=mill"
PROGRAM = "M3 S500\nG1 X5 F600\n" + "X0\nX5\n" * 40 + "M30\n"
SHORT = "G1 X1 F6000\nX0\nM30\n"
WRONG = "G1 X1 F3000\nG1 X100000\nM30\n"  # beyond the travel of X
# Numbers of OPC 40501-1, tables of ChannelState, ChannelMode and MachineOperationMode.
CHANNEL_STATES = {"Active": 0, "Interrupted": 1, "Reset": 2}
MANDATORY_MIN = 50  # of a machine with one channel, three axes and a spindle
AUTOMATIC, OPERATION_AUTOMATIC = 0, 1


class Machine:
    """A daemon that can be ended and brought back."""

    def __init__(self, folder):
        self.folder, self.socket = folder, os.path.join(folder, "op.sock")
        self.machine_file = patient_machine(MACHINE, folder)
        for name, text in (("long.nc", PROGRAM), ("short.nc", SHORT), ("wrong.nc", WRONG)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        self.start()

    def start(self):
        self.process = subprocess.Popen(
            [STANOKD, "--machine", self.machine_file, "--drives", "embedded", "--lcm", "off", "--state",
             os.path.join(self.folder, "state"), "--socket", self.socket, "--program-root", self.folder],
            stderr=subprocess.DEVNULL)
        wait_for_socket(self.process, self.socket)
        self.operator = Operator(self.socket)

    def end(self):
        self.operator.lines.close()
        self.operator.socket.close()
        self.process.terminate()
        self.process.wait(30)

    def ask(self, method, **parameters):
        return self.operator.ask(method, **parameters)

    def insist(self, method, **parameters):
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                return self.ask(method, **parameters)
            except DaemonRefused:
                if time.monotonic() > end:
                    raise
                time.sleep(0.05)

    def until(self, condition):
        end = time.monotonic() + PATIENCE_S
        while not condition(status := self.ask("channel.status", channel=1)):
            if time.monotonic() > end:
                raise TimeoutError(status)
            time.sleep(0.02)
        return status


@functools.cache
def companion_types():
    """Once, and where a test wants them: it takes a second to read them."""
    return CompanionTypes(os.path.join(OPCUA, "node_modules", "node-opcua-nodesets", "nodesets"))


class ServedMachine(unittest.TestCase):
    """Each test has a daemon of its own, and a server when it asks for one."""

    @property
    def types(self):
        return companion_types()

    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.addCleanup(self.stack.close)
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory())
        self.machine = Machine(self.folder)
        self.stack.callback(lambda: self.machine.end())
        self.log = self.stack.enter_context(open(os.path.join(self.folder, "opcua.log"), "w+", encoding="utf-8"))

    def server(self, options=()):
        state = os.path.join(self.folder, "opcua")
        return self.stack.enter_context(
            running_opcua(OPCUA, state, {"mill": self.machine.socket}, options, self.log))

    def client(self, server, mode="None", user=()):
        return self.stack.enter_context(
            Client(OPCUA, server.address, os.path.join(self.folder, "client"), mode, user))

    def until(self, client, condition, what):
        end = time.monotonic() + PATIENCE_S
        while not condition(nodes := client.ask(tree=ROOT)):
            if time.monotonic() > end:
                self.log.seek(0)
                self.fail(f"never {what}: {self.log.read()[-3000:]}\n{nodes}")
            time.sleep(0.05)
        return nodes

    def assert_mandatory_nodes(self, nodes):
        """Of the machine and of everything beneath it, in the words of the specifications. Returns how many."""
        nodes = dict(nodes)
        root_type = self.types.type_id(MACHINE_TOOL, "MachineToolType")
        of = {"": (root_type, "")} | {path: ((node["type"]["uri"], node["type"]["id"]), path + "/")
                                      for path, node in nodes.items() if node["class"] != "Method"}
        count = 0
        for path, (type_id, way) in of.items():
            for uri, name, kind, wanted_type, data_type in self.types.mandatory(type_id):
                found = nodes.get(way + name)
                self.assertIsNotNone(found, f"{path or 'the machine'} lacks {name}")
                self.assertEqual((found["uri"], found["class"]), (uri, kind), way + name)
                if kind != "Method":
                    found_type = (found["type"]["uri"], found["type"]["id"])
                    self.assertTrue(self.types.is_a(found_type, wanted_type), way + name)
                if kind == "Variable":
                    declared = (found["data_type"]["uri"], found["data_type"]["id"])
                    self.assertTrue(self.types.is_a(declared, data_type), f"{way}{name}: {declared}")
                    self.assertEqual(found["status"], "Good", way + name)
                    self.assertIsNotNone(found["value"], way + name)
                count += 1
        return count

    def assert_values(self, nodes, status, machine, runs):
        """Those of the protocol."""
        value = {path: node.get("value") for path, node in nodes.items()}
        info = self.machine.ask("system.info")
        channel = "Monitoring/Channel1"
        program = status["program"] or ""
        wanted = {
            "Identification/Model": machine["name"],
            "Identification/ComponentName": "mill",
            "Identification/SoftwareRevision": info["version"],
            "Identification/SoftwareIdentification/Control/Identifier": info["server"],
            "Monitoring/MachineTool/OperationMode": OPERATION_AUTOMATIC,
            f"{channel}/Name": status["name"],
            f"{channel}/ChannelState": CHANNEL_STATES[status["state"]],
            f"{channel}/ChannelMode": AUTOMATIC,
            f"{channel}/FeedOverride": status["override"]["feed"],
            f"{channel}/RapidOverride": status["override"]["rapid"],
            f"{channel}/ChannelModifiers/OptionalStop": status["optional_stop"],
            f"{channel}/ChannelModifiers/SingleStep": status["single_block"],
            f"{channel}/ChannelModifiers/BlockSkip": bool(status["block_skip"]),
            "Monitoring/Spindle1/Override": status["override"]["spindle"],
            "Monitoring/Spindle1/CommandedSpeed": status["spindles"][0]["commanded_rev_min"],
            "Monitoring/Spindle1/IsRotating": status["spindles"][0]["commanded_rev_min"] != 0,
            "Production/ActiveProgram/Name": program,
            "Production/ProductionPlan/Channel1/ProductionPrograms/Program1/Name": program,
            "Production/ProductionPlan/Channel1/RunsCompleted":
                sum(run["ok"] for run in runs if run["ended"] and run["program"] == program),
        }
        for name, axis in status["axes"].items():
            wanted[f"Monitoring/Axis{name}/Position"] = axis["position"]
            wanted[f"Monitoring/Axis{name}/IsEnabled"] = axis["enabled"]
            wanted[f"Monitoring/Axis{name}/IsReferenced"] = axis["verified"]
        self.assertEqual({path: value.get(path) for path in wanted}, wanted)

    def assert_equal_to_protocol(self, client, what, condition):
        """Once the newest state has come: whatever does not move is the same to the bit."""
        end = time.monotonic() + PATIENCE_S
        while True:
            status, machine = self.machine.ask("channel.status", channel=1), self.machine.ask("machine.status")
            runs = self.machine.ask("program.history")["runs"]
            nodes = self.until(client, condition, what)
            try:
                self.assert_values(nodes, status, machine, runs)
                return nodes
            except AssertionError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.1)


def main():
    try:
        packages(OPCUA)
    except Missing as missing:
        print(f"left out: {missing}")
        sys.exit(77)
    unittest.main(verbosity=2)
