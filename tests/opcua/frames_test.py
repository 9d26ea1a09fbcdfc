#!/usr/bin/env python3
"""What stanok-opcua sends, read by tshark: in a network namespace of its own, where the server listens at an address
other than loopback, too.

usage: frames_test.py STANOKD MACHINE_FILE FOLDER_OF_OPCUA
exit code 77: node, the packages of npm, tshark or the right to make a namespace are not to be had
"""
import os
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from running_daemon import Operator, running_daemon  # noqa: E402
from running_opcua import Client, Missing, Refused, packages, running_opcua  # noqa: E402

ELSEWHERE = "10.81.0.1"
ROOT = "ns=8;s=mill"
PATIENCE_S = 30


def leave_out(why):
    print(f"left out: {why}")
    sys.exit(77)


def enter_namespace():
    """The test begins again in one of its own."""
    for tool in ("unshare", "ip", "tshark"):
        if not shutil.which(tool):
            leave_out(f"{tool} is not installed")
    try:
        packages(sys.argv[3])  # as long as there is a network
    except Missing as missing:
        leave_out(missing)
    for words in (["unshare", "--net"], ["unshare", "--map-root-user", "--net"]):
        if subprocess.run([*words, "true"], stderr=subprocess.DEVNULL).returncode == 0:
            os.environ["STANOK_IN_NAMESPACE"] = "yes"
            os.execvp(words[0], [*words, sys.executable, *sys.argv])
    leave_out("unshare is refused: no network namespace")


def fields(capture, port, wanted, *names):
    """Of the frames that the filter takes: a list of lists of texts."""
    words = [word for name in names for word in ("-e", name)]
    result = subprocess.run(["tshark", "-r", capture, "-d", f"tcp.port=={port},opcua", "-Y", wanted, "-T", "fields",
                             "-E", "occurrence=a", *words], capture_output=True, text=True, check=True)
    return [line.split("\t") for line in result.stdout.splitlines()]


def look_at_frames(folder, stanokd, machine_file, opcua):
    capture = os.path.join(folder, "frames.pcap")
    with running_daemon(stanokd, machine_file, "G1 X5\nM30\n") as daemon, \
            running_opcua(opcua, os.path.join(folder, "state"), {"mill": daemon.socket_path}) as server:
        port = server.address.rpartition(":")[2]
        operator = Operator(daemon.socket_path)
        operator.ask("override.feed", percent=73)
        watcher = subprocess.Popen(["tshark", "-i", "lo", "-f", f"tcp port {port}", "-w", capture],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while "Capturing" not in (line := watcher.stderr.readline()):
            assert line, "tshark did not begin"
        end = time.monotonic() + PATIENCE_S
        with Client(opcua, server.address, os.path.join(folder, "client")) as client:
            override = "Monitoring/Channel1/FeedOverride"
            while (nodes := client.ask(tree=ROOT)).get(override, {}).get("value") != 73:
                assert time.monotonic() < end, nodes
        # What was captured is on the disk when the file does not grow any more.
        size = -1
        while size != (size := os.path.getsize(capture)):
            time.sleep(1)
        watcher.terminate()
        watcher.wait()
        watcher.stderr.close()
        operator.lines.close()
        operator.socket.close()
    messages = fields(capture, port, "opcua", "opcua.transport.type")
    wrong = fields(capture, port, "opcua && (_ws.malformed || _ws.expert.severity >= 8388608)", "frame.number")
    doubles = {text for row in fields(capture, port, "opcua.variant.has_value", "opcua.Double") for text in row[0].split(",")}
    texts = {text for row in fields(capture, port, "opcua", "opcua.String") for text in row[0].split(",")}
    print(f"{len(messages)} frames of OPC UA")
    assert len(messages) > 50, messages
    assert not wrong, f"malformed: {wrong}"
    assert "73" in doubles, sorted(doubles)
    assert {"mill", "stanokd"} <= texts, sorted(texts)


def look_from_elsewhere(folder, stanokd, machine_file, opcua):
    """Nothing without security, and nobody without a name."""
    users = os.path.join(folder, "users")
    line = subprocess.run(["node", os.path.join(opcua, "stanok-opcua.js"), "--add-user", "cell"],
                          input="a long password\n", capture_output=True, text=True, check=True).stdout
    with open(users, "w", encoding="utf-8") as file:
        file.write(line)
    state, pki = os.path.join(folder, "state2"), os.path.join(folder, "client2")
    with running_daemon(stanokd, machine_file, "M30\n") as daemon, \
            running_opcua(opcua, state, {"mill": daemon.socket_path},
                          ("--host", ELSEWHERE, "--users", users)) as server:
        assert ELSEWHERE in server.address, server.address
        user = ("cell", "a long password")
        for mode, identity in (("None", user), ("Sign", ()), ("Sign", user)):
            try:
                Client(opcua, server.address, pki, mode, identity)
            except Refused:
                continue
            raise AssertionError(f"{mode} {identity} was let in")
        rejected = os.path.join(state, "pki", "rejected")
        for name in os.listdir(rejected):
            os.rename(os.path.join(rejected, name), os.path.join(state, "pki", "trusted", "certs", name))
        with Client(opcua, server.address, pki, "Sign", user) as client:
            assert {one["mode"] for one in client.ask(endpoints=0)} == {"Sign", "SignAndEncrypt"}
        try:
            Client(opcua, server.address, pki, "Sign")
        except Refused:
            return
        raise AssertionError("anonymous was let in")


if __name__ == "__main__":
    if "STANOK_IN_NAMESPACE" not in os.environ:
        enter_namespace()
    subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
    subprocess.run(["ip", "address", "add", f"{ELSEWHERE}/32", "dev", "lo"], check=True)
    with tempfile.TemporaryDirectory() as place:
        os.chmod(place, 0o777)  # dumpcap may give up the rights of root before it writes
        look_at_frames(place, *sys.argv[1:4])
        look_from_elsewhere(place, *sys.argv[1:4])
    print("passed")
