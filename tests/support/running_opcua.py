"""stanok-opcua on a free port of loopback, and a client of it.

    packages(folder)                                    # of npm, once; Missing when they cannot be had
    with running_opcua(folder, state, {"mill": socket}) as server, Client(folder, server.address, pki) as client:
        client.ask(tree="ns=8;s=mill")
"""
import contextlib
import filecmp
import json
import os
import re
import shutil
import subprocess


class Missing(Exception):
    """What is missing to run the server here."""


def _no_newer_than_debian():
    """Node 18 of Debian 12 cannot `require` a module of ECMAScript and has no global Web Crypto API; a newer Node is told
    to be without them, too, for all that follows."""
    options = []
    for option in ("--no-experimental-require-module", "--no-experimental-global-webcrypto"):
        if subprocess.run(["node", option, "--eval", "0"], capture_output=True).returncode == 0:
            options.append(option)
    os.environ["NODE_OPTIONS"] = " ".join(options)


def packages(folder):
    """Those of the lock file, unless they are there."""
    node = shutil.which("node")
    if not node or not shutil.which("npm"):
        raise Missing("node or npm is not here (packages nodejs, npm)")
    version = int(re.match(r"v(\d+)", subprocess.run([node, "--version"], capture_output=True, text=True).stdout)[1])
    if version < 18:
        raise Missing(f"node {version} is older than 18")
    _no_newer_than_debian()
    lock, installed = (os.path.join(folder, name) for name in ("package-lock.json", "node_modules/.lock"))
    if os.path.exists(installed) and filecmp.cmp(lock, installed, shallow=False):
        return
    result = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder,
                            capture_output=True, text=True)
    if result.returncode != 0:
        away = "ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ENETUNREACH|ETIMEDOUT|ENOTCACHED"
        if re.search(away, result.stdout + result.stderr):
            raise Missing("npm does not reach its registry")
        raise RuntimeError(result.stdout + result.stderr)
    shutil.copy(lock, installed)


class Server:
    def __init__(self, process, address):
        self.process, self.address = process, address


@contextlib.contextmanager
def running_opcua(folder, state, daemons, options=(), log=None):
    named = [word for name, path in daemons.items() for word in ("--daemon", f"{name}={path}")]
    process = subprocess.Popen(["node", os.path.join(folder, "stanok-opcua.js"), *named, "--port", "0", "--rate", "10",
                                "--state", state, *options],
                               stdout=subprocess.PIPE, stderr=log or subprocess.DEVNULL, text=True)
    try:
        address = process.stdout.readline().strip()
        if not address:
            raise RuntimeError(f"stanok-opcua ended with {process.wait()}")
        yield Server(process, address)
    finally:
        process.terminate()
        try:
            if process.wait(20) != 0:
                raise RuntimeError(f"stanok-opcua ended with {process.returncode}")
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            raise
        finally:
            process.stdout.close()


class Refused(Exception):
    """The server does not want this client."""


class Client:
    def __init__(self, folder, address, pki, mode="None", user=()):
        self.process = subprocess.Popen(
            ["node", os.path.join(folder, "tests", "client.js"), address, pki, mode, *user],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        answer = self._answer()
        if "error" in answer:
            self.__exit__()
            raise Refused(answer["error"])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()

    def _answer(self):
        while True:
            line = self.process.stdout.readline()
            if not line:
                return {"error": "the client ended"}
            if line.startswith(("{", "[", '"')):  # the library writes there, too
                return json.loads(line)

    def ask(self, **command):
        self.process.stdin.write(json.dumps(command) + "\n")
        self.process.stdin.flush()
        answer = self._answer()
        if isinstance(answer, dict) and "error" in answer:
            raise Refused(answer["error"])
        return answer
