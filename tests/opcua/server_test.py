#!/usr/bin/env python3
"""stanok-opcua before real daemons with simulated drives, as a client of OPC UA sees it: every mandatory node of
OPC 40501-1 with its type, and the values of the protocol.

usage: server_test.py STANOKD MACHINE_FILE FOLDER_OF_OPCUA [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import json
import os
import socket
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_opcua import Refused  # noqa: E402
from served_machine import CHANNEL_STATES, MANDATORY_MIN, OPCUA, PATIENCE_S, ROOT, ServedMachine, main  # noqa: E402

TOOLS = "[[tool]]\nnumber = 4\nlength = 80.0\nradius = 4.0\n"
IDENTITY = {"Manufacturer": "Example Works", "SerialNumber": "0815", "YearOfConstruction": 2024}


class TheServer(ServedMachine):
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
        with open(os.path.join(self.folder, "opcua.log"), encoding="utf-8") as log:
            said = log.read()
        self.assertIn("a login as cell from 127.0.0.1 failed", said)
        self.assertIn("a login as nobody from 127.0.0.1 failed", said)
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
    main()
