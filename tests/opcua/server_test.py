#!/usr/bin/env python3
"""stanok-opcua before real daemons with simulated drives, as a client of OPC UA sees it: every mandatory node of
OPC 40501-1 with its type, and the values of the protocol.

usage: server_test.py STANOKD MACHINE_FILE FOLDER_OF_OPCUA [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import contextlib
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from companion_types import CompanionTypes  # noqa: E402
from running_daemon import Operator, Refused as DaemonRefused, patient_machine, wait_for_socket  # noqa: E402
from running_opcua import Client, Missing, Refused, packages, running_opcua  # noqa: E402

STANOKD, MACHINE, OPCUA = (sys.argv.pop(1) for _ in range(3))
PATIENCE_S = 30
MACHINE_TOOL = "http://opcfoundation.org/UA/MachineTool/"
ROOT = "ns=8;s=mill"
PROGRAM = "M3 S500\nG1 X5 F600\n" + "X0\nX5\n" * 40 + "M30\n"
SHORT = "G1 X1 F6000\nX0\nM30\n"
WRONG = "G1 X1 F3000\nG1 X100000\nM30\n"  # beyond the travel of X
TOOLS = "[[tool]]\nnumber = 4\nlength = 80.0\nradius = 4.0\n"
IDENTITY = {"Manufacturer": "Example Works", "SerialNumber": "0815", "YearOfConstruction": 2024}
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


class TheServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.types = CompanionTypes(os.path.join(OPCUA, "node_modules", "node-opcua-nodesets", "nodesets"))

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

    def test_every_mandatory_node_is_typed_and_equal_to_the_protocol(self):
        identity = os.path.join(self.folder, "identity.json")
        with open(identity, "w", encoding="utf-8") as file:
            json.dump({"mill": IDENTITY}, file)
        machine, client = self.machine, self.client(self.server(("--identity", identity)))
        machine.insist("machine.on")
        machine.ask("override.feed", percent=80)
        machine.ask("program.run", program="long.nc")
        machine.until(lambda status: status["position"]["X"] > 0.5)

        def state_is(word):
            return lambda nodes: nodes["Production/ActiveProgram/State/CurrentState"]["value"] == word

        running = self.until(client, state_is("Running"), "running")
        self.assertEqual({name: running[f"Identification/{name}"]["value"] for name in IDENTITY}, IDENTITY)
        self.assertGreater(self.assert_mandatory_nodes(running), MANDATORY_MIN)
        blocks = "MachineryBuildingBlocks"
        self.assertEqual(running[f"{blocks}/MachineryItemState/CurrentState"]["value"], "Executing")
        self.assertEqual(running[f"{blocks}/MachineryOperationMode/CurrentState"]["value"], "Processing")
        self.assertEqual(running["Monitoring/Channel1/ChannelState"]["value"], CHANNEL_STATES["Active"])
        # While the axis moves, its position is one of the way.
        self.assertTrue(0.0 <= running["Monitoring/AxisX/Position"]["value"] <= 5.0)
        self.assertNotEqual(running["Monitoring/AxisX/Position"]["value"], 0.0)

        machine.ask("program.hold")
        machine.until(lambda status: status["state"] == "Interrupted" and status["speed_mm_s"] == 0.0)
        self.assert_equal_to_protocol(client, "interrupted", state_is("Interrupted"))
        machine.ask("program.reset")
        machine.until(lambda status: status["state"] == "Reset")
        aborted = self.assert_equal_to_protocol(client, "aborted", state_is("Aborted"))
        self.assertGreater(self.assert_mandatory_nodes(aborted), MANDATORY_MIN)
        for _ in range(2):
            machine.insist("program.run", program="short.nc", wait="done")
        ended = self.assert_equal_to_protocol(client, "ended", lambda nodes: state_is("Ended")(nodes) and nodes[
            f"{blocks}/MachineryItemState/CurrentState"]["value"] == "NotExecuting")
        self.assertEqual(ended["Production/ProductionPlan/Channel1/RunsCompleted"]["value"], 2)

    def test_nothing_can_be_written_or_called(self):
        client = self.client(self.server())
        nodes = self.until(client, lambda found: "Monitoring/Channel1" in found, "a channel")
        self.assertEqual([path for path, node in nodes.items() if node["class"] == "Method"], [])
        override = nodes["Monitoring/Channel1/FeedOverride"]
        self.assertEqual(override["access"], 1)  # CurrentRead
        self.assertIn(client.ask(write=override["node"]), ("BadNotWritable", "BadUserAccessDenied"))
        for path, node in nodes.items():
            if node["class"] == "Variable":
                self.assertEqual(node["access"] & 2, 0, path)

    def test_tools_come_with_their_table(self):
        client = self.client(self.server())
        self.until(client, lambda found: "Monitoring/Channel1" in found, "a channel")
        self.machine.ask("tool.load", tables=TOOLS)
        wanted = self.machine.ask("tool.get", number=4)
        nodes = self.until(client, lambda found: "Equipment/Tools/Tool4Edge1" in found, "the tool")
        tool = {name: nodes[f"Equipment/Tools/Tool4Edge1/{name}"]["value"]
                for name in ("ControlIdentifier1", "ControlIdentifier2", "Name", "Locked")}
        self.assertEqual(tool, {"ControlIdentifier1": wanted["number"], "ControlIdentifier2": wanted["edge"],
                                "Name": wanted["name"], "Locked": False})
        self.assertEqual(nodes["Equipment/Tools/NodeVersion"]["value"], "2")
        self.assert_mandatory_nodes(nodes)

    def next_event(self, client, condition, what):
        end = time.monotonic() + PATIENCE_S
        seen = []
        while time.monotonic() < end:
            for event in client.ask(events=0):
                seen.append(event)
                if condition(event):
                    return event
            time.sleep(0.05)
        return self.fail(f"never {what}: {seen}")

    def test_an_alarm_is_a_condition(self):
        server = self.server()
        machine, client = self.machine, self.client(server)
        self.until(client, lambda found: "Monitoring/Channel1" in found, "a channel")
        self.assertEqual(client.ask(listen=f"{ROOT}-Notification"), "Good")
        machine.insist("machine.on")
        end = time.monotonic() + PATIENCE_S
        while True:
            error = machine.operator.answer("program.run", program="wrong.nc", wait="done")["error"]["data"]
            if error["code"] == "E5101" or time.monotonic() > end:
                break
        event = self.next_event(client, lambda one: one["ErrorCode"] == "E5101", "E5101")
        row = machine.ask("alarm.list")["alarms"][-1]
        self.assertEqual((event["Message"], event["ErrorCode"], event["ActiveState.Id"], event["Retain"]),
                         (row["text"], row["code"], True, True))
        path = "Notification/Messages/Channel1E5101"
        nodes = self.until(client, lambda found: path in found, "the condition")
        self.assertEqual(nodes[f"{path}/ErrorCode"]["value"], "E5101")
        self.assertTrue(nodes[f"{path}/ActiveState/Id"]["value"])
        self.assert_mandatory_nodes(nodes)
        self.assertEqual(nodes["Production/ActiveProgram/State/CurrentState"]["value"], "Aborted")
        # Who comes later asks for what is active.
        later = self.client(server)
        self.assertEqual(later.ask(listen=f"{ROOT}-Notification"), "Good")
        self.assertEqual(later.ask(refresh=0), "Good")
        self.next_event(later, lambda one: one["ErrorCode"] == "E5101", "E5101 after a refresh")
        # Nobody acknowledges from here.
        condition = nodes[path]["node"]
        arguments = [{"dataType": "ByteString", "value": ""}, {"dataType": "LocalizedText", "value": {"text": ""}}]
        for method in (nodes[f"{path}/Acknowledge"]["node"], "i=9111"):  # of the instance and of the type
            self.assertEqual(client.ask(call=[condition, method, arguments]), "BadUserAccessDenied")
        machine.insist("program.reset")
        event = self.next_event(client, lambda one: one["ErrorCode"] == "E5101" and not one["ActiveState.Id"],
                                "the end of E5101")
        self.assertFalse(event["Retain"])

    def test_values_are_bad_while_the_daemon_is_away(self):
        machine, client = self.machine, self.client(self.server())

        def statuses(word):
            # The last node of a tree is read last: the others are as new.
            ends = ("Monitoring/AxisX/Position", "Equipment/Tools", "Identification/Manufacturer")
            return lambda nodes: all(nodes.get(path, {}).get("status", word) == word for path in ends) and ends[0] in nodes

        self.until(client, statuses("Good"), "there")
        machine.end()
        away = self.until(client, statuses("BadNoCommunication"), "away")
        for path, node in away.items():
            if node["class"] == "Variable" and not path.endswith("NodeVersion"):
                self.assertTrue(node["status"].startswith("Bad"), f"{path}: {node}")
        machine.start()
        back = self.until(client, statuses("Good"), "back")
        self.assertGreater(self.assert_mandatory_nodes(back), MANDATORY_MIN)

    def test_two_computers_have_two_applications(self):
        client = self.client(self.server())
        name = f"urn:{socket.gethostname()}:stanok:opcua"
        self.assertEqual(client.ask(tree="i=2253")["ServerArray"]["value"], [name])
        own = os.path.join(self.folder, "opcua", "pki", "own", "certs")
        files = [name for name in os.listdir(own) if name.endswith(".pem")]
        self.assertTrue(files)
        for file in files:
            text = subprocess.run(["openssl", "x509", "-in", os.path.join(own, file), "-noout", "-ext", "subjectAltName"],
                                  capture_output=True, text=True, check=True).stdout
            self.assertIn(f"URI:{name},", text.replace("\n", ",").replace(" ", ""))

    def test_users_and_certificates(self):
        users = os.path.join(self.folder, "users")
        line = subprocess.run(["node", os.path.join(OPCUA, "stanok-opcua.js"), "--add-user", "cell"],
                              input="a long password\n", capture_output=True, text=True, check=True).stdout
        self.assertNotIn("a long password", line)
        with open(users, "w", encoding="utf-8") as file:
            file.write(line)
        server = self.server(("--users", users, "--sessions", "2"))
        with self.assertRaises(Refused):
            self.client(server)
        with self.assertRaises(Refused):
            self.client(server, user=("cell", "another password"))
        with self.assertRaises(Refused):
            self.client(server, user=("nobody", "a long password"))
        self.client(server, user=("cell", "a long password"))
        with self.assertRaises(Refused):  # nobody has trusted this client
            self.client(server, "SignAndEncrypt", ("cell", "a long password"))
        pki = os.path.join(self.folder, "opcua", "pki")
        for name in os.listdir(os.path.join(pki, "rejected")):
            os.rename(os.path.join(pki, "rejected", name), os.path.join(pki, "trusted", "certs", name))
        secure = self.client(server, "SignAndEncrypt", ("cell", "a long password"))
        self.assertIn("Monitoring/MachineTool", secure.ask(tree=ROOT))
        with self.assertRaises(Refused):  # the third session
            self.client(server, user=("cell", "a long password"))

    def test_wrong_usage(self):
        program = ["node", os.path.join(OPCUA, "stanok-opcua.js")]
        for words, wanted in (([], "no machine"), (["--daemon", "a=x", "--daemon", "a=y"], "two machines"),
                              (["--daemon", "a=x", "--host", "0.0.0.0"], "--users"),
                              (["--daemon", "a=x", "--port", "70000"], "--port"), (["--nothing"], "--nothing")):
            result = subprocess.run([*program, *words], capture_output=True, text=True)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(wanted, result.stderr)


if __name__ == "__main__":
    try:
        packages(OPCUA)
    except Missing as missing:
        print(f"left out: {missing}")
        sys.exit(77)
    unittest.main(verbosity=2)
