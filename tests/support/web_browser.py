"""A stanok-web on a free port, and a browser that can misbehave: HTTP and WebSocket from plain sockets.

    with running_web(stanok_web, folder, socket_path) as web:
        browser = Browser(web)
        browser.enter_by_link()
        window = browser.open_window()
        window.ask("machine.status")
"""
import base64
import contextlib
import hashlib
import json
import os
import socket
import ssl
import struct
import subprocess
import threading
from urllib.parse import urlsplit

# What begins motion says which cycle of the machine was seen.
MOVES = ("machine.on", "program.run", "program.start", "program.resume", "queue.start", "kinematics.select", "mdi", "jog",
         "home")
WEBSOCKET_GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"  # RFC 6455, section 1.3
PATIENCE_S = 60


class Closed(Exception):
    """The server has ended the connection."""


class Silence(Exception):
    """The server sends nothing but pings."""


def new_link(link_socket):
    """As `stanok panel` gets one."""
    with socket.socket(socket.AF_UNIX) as desk, desk.makefile() as stream:
        desk.connect(link_socket)
        return json.loads(stream.read())["link"]


class Web:
    """The server: where it is, and a link to it."""

    def __init__(self, process, link):
        self.process, self.link = process, link
        parts = urlsplit(link)
        self.scheme, self.port, self.token = parts.scheme, parts.port, parts.fragment
        self.host = f"127.0.0.1:{self.port}"
        self.origin = f"{self.scheme}://{self.host}"

    def resident_bytes(self):
        with open(f"/proc/{self.process.pid}/statm", encoding="ascii") as statm:
            return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@contextlib.contextmanager
def running_web(stanok_web, folder, socket_path, *options, error=None):
    usual = {"--listen": "127.0.0.1:0", "--socket": socket_path, "--page": os.path.join(folder, "page"),
             "--link-socket": os.path.join(folder, "links.panel")}
    words = [word for option in usual.items() if option[0] not in options for word in option]
    link_socket = options[options.index("--link-socket") + 1] if "--link-socket" in options else usual["--link-socket"]
    process = subprocess.Popen([stanok_web, *words, *options], stdout=subprocess.PIPE, stderr=error, text=True)
    try:
        address = process.stdout.readline().strip()
        assert address.startswith("http"), f"stanok-web printed {address!r}"
        yield Web(process, new_link(link_socket))
    finally:
        process.terminate()
        code = process.wait(PATIENCE_S)
        process.stdout.close()
        assert code == 0, f"stanok-web ended with {code}"


class Response:
    def __init__(self, status, fields, content):
        self.status, self.fields, self.content = status, fields, content

    def json(self):
        return json.loads(self.content)


def connect(web, source="127.0.0.1"):
    plain = socket.create_connection(("127.0.0.1", web.port), PATIENCE_S, (source, 0))
    if web.scheme == "http":
        return plain
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    return context.wrap_socket(plain)


def read_head(stream):
    status_line = stream.readline()
    if not status_line:
        raise Closed
    fields = {}
    while (line := stream.readline()) not in (b"\r\n", b""):
        name, _, value = line.decode("latin-1").partition(":")
        fields[name.strip().lower()] = value.strip()
    return int(status_line.split()[1]), fields


class Browser:
    """Keeps a cookie and the key of the session, as browsers do; every request has a connection of its own."""

    def __init__(self, web, source="127.0.0.1"):
        """`source`: the address that it comes from."""
        self.web, self.source, self.cookie, self.key = web, source, "", ""

    def request(self, method, path, content=None, **changed):
        """`changed` are fields by name with _ for -; None leaves one out."""
        fields = {"Host": self.web.host, "Connection": "close"}
        body = b""
        if content is not None:
            body = content if isinstance(content, bytes) else json.dumps(content).encode()
            fields.update({"Content-Type": "application/json", "Content-Length": str(len(body)),
                           "Origin": self.web.origin})
        if self.cookie:
            fields["Cookie"] = self.cookie
        if self.key:
            fields["X-Stanok-Key"] = self.key
        fields.update({name.replace("_", "-"): value for name, value in changed.items()})
        head = "".join(f"{name}: {value}\r\n" for name, value in fields.items() if value is not None)
        with connect(self.web, self.source) as one, one.makefile("rb") as stream:
            one.sendall(f"{method} {path} HTTP/1.1\r\n{head}\r\n".encode() + body)
            status, got = read_head(stream)
            content = b"" if method == "HEAD" else stream.read()
        if "set-cookie" in got:
            self.cookie = got["set-cookie"].split(";")[0]
            self.key = json.loads(content)["key"] if status == 200 else ""
        return Response(status, got, content)

    def enter_by_link(self):
        answer = self.request("POST", "/api/session", {"token": self.web.token})
        assert answer.status == 200, answer.content

    def enter(self, name, password):
        return self.request("POST", "/api/session", {"name": name, "password": password})

    def open_window(self, path="/ws", **changed):
        return Window(self, path, changed)


class Refused(Exception):
    """The server did not open the WebSocket; `status` says how."""

    def __init__(self, status, content=b""):
        super().__init__(f"status {status}: {content}")
        self.status = status


class Window:
    """A WebSocket to the machine."""

    def __init__(self, browser, path, changed):
        self.socket = connect(browser.web)
        self.stream = self.socket.makefile("rb")
        self.last_id = 0
        self.pings = 0  # since the last message
        self.binary = []  # frames that came between answers
        self.notifications = []
        key = base64.b64encode(os.urandom(16)).decode()
        fields = {"Host": browser.web.host, "Connection": "Upgrade", "Upgrade": "websocket",
                  "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": key, "Origin": browser.web.origin,
                  "Cookie": browser.cookie or None}
        fields.update({name.replace("_", "-"): value for name, value in changed.items()})
        head = "".join(f"{name}: {value}\r\n" for name, value in fields.items() if value is not None)
        self.socket.sendall(f"GET {path} HTTP/1.1\r\n{head}\r\n".encode())
        status, got = read_head(self.stream)
        if status != 101:
            content = self.stream.read()
            self.close()
            raise Refused(status, content)
        if browser.key:
            self.send({"jsonrpc": "2.0", "method": "session.key", "params": {"key": browser.key}})
        accepted = base64.b64encode(hashlib.sha1((key + WEBSOCKET_GUID).encode()).digest()).decode()
        assert got["sec-websocket-accept"] == accepted

    def close(self):
        self.stream.close()
        self.socket.close()

    def send_frame(self, opcode, payload, mask=b"\x01\x02\x03\x04"):
        size = len(payload)
        if size < 126:
            head = struct.pack("!BB", 0x80 | opcode, 0x80 | size)
        elif size < 1 << 16:
            head = struct.pack("!BBH", 0x80 | opcode, 0x80 | 126, size)
        else:
            head = struct.pack("!BBQ", 0x80 | opcode, 0x80 | 127, size)
        long_mask = mask * (size // 4 + 1)
        masked = (int.from_bytes(payload, "big") ^ int.from_bytes(long_mask[:size], "big")).to_bytes(size, "big")
        self.socket.sendall(head + mask + masked)

    def send(self, message):
        text = message if isinstance(message, str) else json.dumps(message)
        self.send_frame(1, text.encode())

    def receive_frame(self):
        """(opcode, payload) of the next frame; pings are answered."""
        while True:
            head = self.stream.read(2)
            if len(head) < 2:
                raise Closed
            size = head[1] & 0x7F
            if size == 126:
                size = struct.unpack("!H", self.stream.read(2))[0]
            elif size == 127:
                size = struct.unpack("!Q", self.stream.read(8))[0]
            payload = self.stream.read(size)
            opcode = head[0] & 0x0F
            if opcode == 8:
                raise Closed(payload)
            if opcode == 9:
                self.pings += 1
                if self.pings > 4:
                    raise Silence
                self.send_frame(10, payload)
            elif opcode in (1, 2):
                self.pings = 0
                return opcode, payload

    def receive(self):
        """The next text message; binary frames are kept."""
        while True:
            opcode, payload = self.receive_frame()
            if opcode == 1:
                return json.loads(payload)
            self.binary.append(payload)

    def answer(self, method, /, **parameters):
        if method in MOVES and "seen_cycle" not in parameters:
            parameters["seen_cycle"] = self.ask("machine.status").get("cycle", 0)
        return self.answer_as_is(method, parameters)

    def answer_as_is(self, method, parameters):
        self.last_id += 1
        self.send({"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": parameters})
        while (message := self.receive()).get("id") != self.last_id:
            self.notifications.append(message)
        return message

    def ask(self, method, /, **parameters):
        message = self.answer(method, **parameters)
        assert "result" in message, f"{method}: {message}"
        return message["result"]


class FakeDaemon:
    """Speaks as the daemon does, for tests that need to see what arrives there."""

    HELLO = {"jsonrpc": "2.0", "method": "hello",
             "params": {"server": "fake", "machine": "fake mill", "role": "integrator", "session": 1}}

    def __init__(self, path):
        self.listener = socket.socket(socket.AF_UNIX)
        self.listener.bind(path)
        self.listener.listen(128)
        self.lines = []  # of all connections, as they came
        self.open = 0  # connections
        self.changed = threading.Condition()
        threading.Thread(target=self._accept, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.listener.close()

    def _accept(self):
        while True:
            try:
                one = self.listener.accept()[0]
            except OSError:
                return
            threading.Thread(target=self._serve, args=(one,), daemon=True).start()

    def _note(self, connections, line=None):
        with self.changed:
            self.open += connections
            if line is not None:
                self.lines.append(line)
            self.changed.notify_all()

    def _serve(self, one):
        self._note(1)
        with contextlib.suppress(OSError), one, one.makefile("rb") as stream:
            one.sendall(json.dumps(self.HELLO).encode() + b"\n")
            for line in stream:
                self._note(0, line)
                one.sendall(self.answer_to(json.loads(line)))
        self._note(-1)

    def answer_to(self, request):
        """The lines that answer a request; for others to change."""
        result = {"role": request["params"]["role"]} if request["method"] == "session.role" else request["params"]
        return json.dumps({"jsonrpc": "2.0", "id": request["id"], "result": result}).encode() + b"\n"

    def wait_until(self, condition):
        with self.changed:
            assert self.changed.wait_for(lambda: condition(self), PATIENCE_S), "what was waited for never came"
