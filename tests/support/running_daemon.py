"""A stanokd with embedded drives in a folder of its own, and connections to it.

    with running_daemon(stanokd, machine_file, PROGRAM) as daemon:
        operator = Operator(daemon.socket_path)
        operator.ask("machine.on")

The folder has PROGRAM as part.nc; the daemon ends with the block.
"""
import contextlib
import json
import os
import resource
import shutil
import socket
import subprocess
import tempfile
import time


class Refused(Exception):
    """The daemon answered with an error."""


def request(number, method, /, **parameters):
    """A request as the bytes of its line."""
    return (json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": parameters}) + "\n").encode()


def connect(path):
    one = socket.socket(socket.AF_UNIX)
    try:
        one.connect(path)
    except OSError:
        one.close()
        raise
    return one


class Operator:
    """One connection that waits for its answers."""

    def __init__(self, path):
        self.socket = connect(path)
        self.lines = self.socket.makefile("rb")
        self.last_id = 0

    def close(self):
        self.lines.close()
        self.socket.close()

    def answer(self, method, /, **parameters):
        """The whole answer: with "result" or "error"."""
        self.last_id += 1
        self.socket.sendall(request(self.last_id, method, **parameters))
        while True:
            line = self.lines.readline()
            if not line:
                raise ConnectionError(method)
            message = json.loads(line)
            if message.get("id") == self.last_id:
                return message

    def ask(self, method, /, **parameters):
        """The result; raises Refused."""
        message = self.answer(method, **parameters)
        if "error" in message:
            raise Refused(f"{method}: {message['error']['message']}")
        return message["result"]


class Daemon:
    def __init__(self, process, socket_path):
        self.process, self.socket_path = process, socket_path


def wait_for_socket(process, path):
    while True:
        if process.poll() is not None:
            raise RuntimeError("the daemon did not start")
        try:
            return connect(path).close()
        except OSError:
            time.sleep(0.05)


def patient_machine(machine_file, folder, request_age_max_s=30):
    """A copy of the machine file, with what belongs to it, that waits 30 s for its drives and takes commands that
    are 30 s old: those inside a daemon wait longer than the drives of a machine where the computer runs other tests beside. As patient_machine.sh."""
    machine = os.path.join(folder, "machine")
    os.mkdir(machine)
    belongings = machine_file.removesuffix(".toml")
    if os.path.isdir(belongings):
        shutil.copytree(belongings, os.path.join(machine, os.path.basename(belongings)))
    with open(machine_file, encoding="utf-8") as file:
        lines = [line for line in file.read().splitlines() if not line.startswith("timeout_ms = ")]
    if "[drives]" not in lines:
        lines += ["[drives]", 'bus = "modbus-tcp"']
    lines.insert(lines.index("[drives]") + 1, "timeout_ms = 30000")
    lines.insert(lines.index("[machine]") + 1, f"request_age_max = {request_age_max_s}")
    copy = os.path.join(machine, os.path.basename(machine_file))
    with open(copy, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return copy


@contextlib.contextmanager
def running_daemon(stanokd, machine_file, program, error=subprocess.DEVNULL, options=(), descriptors=0,
                   impatient=False):
    """`error`: where the log of the daemon goes. `descriptors`: that it may have; 0: as this process. `impatient`: what
    begins motion is refused when it is half a second old."""

    def limit():
        if descriptors:
            resource.setrlimit(resource.RLIMIT_NOFILE, (descriptors, descriptors))

    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "op.sock")
        with open(os.path.join(folder, "part.nc"), "w", encoding="utf-8") as part:
            part.write(program)
        machine_file = patient_machine(machine_file, folder, 0.5 if impatient else 30)
        process = subprocess.Popen([stanokd, "--machine", machine_file, "--drives", "embedded", "--lcm", "off",
                                    "--state", os.path.join(folder, "state"), "--socket", path,
                                    "--program-root", folder, *options], stderr=error,
                                   preexec_fn=limit)
        try:
            wait_for_socket(process, path)
            yield Daemon(process, path)
        finally:
            process.terminate()
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def allow_many_descriptors():
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(4096, most), most))
