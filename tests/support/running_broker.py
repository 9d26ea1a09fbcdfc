"""A mosquitto on loopback that can be killed and brought back, and a subscriber of MQTT 3.1.1 that knows no library.

    broker = Broker(folder)                     # on a free port
    with Subscriber(broker.port, "cell/#") as subscriber:
        topic, payload, retained = subscriber.receive()
"""
import contextlib
import os
import socket
import ssl
import struct
import subprocess
import time

PATIENCE_S = 30


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Broker:
    def __init__(self, folder, settings=""):
        self.port = free_port()
        self.settings = os.path.join(folder, "mosquitto.conf")
        with open(self.settings, "w", encoding="utf-8") as file:
            # Sessions outlive the broker: what a subscriber has not had yet is kept on the disk. What was sent must
            # have left when the broker is killed: it was acknowledged to the sender.
            file.write(f"listener {self.port} 127.0.0.1\npersistence true\npersistence_location {folder}/\n"
                       "autosave_on_changes true\nautosave_interval 1\nmax_queued_messages 0\nset_tcp_nodelay true\n" +
                       (settings or "allow_anonymous true\n"))
            if os.geteuid() == 0:
                file.write("user root\n")
        self.process = None
        self.start()

    def start(self):
        path = "/usr/sbin/mosquitto" if os.path.exists("/usr/sbin/mosquitto") else "mosquitto"
        self.process = subprocess.Popen([path, "-c", self.settings], stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                socket.create_connection(("127.0.0.1", self.port)).close()
                return
            except OSError:
                if self.process.poll() is not None or time.monotonic() > end:
                    raise RuntimeError("mosquitto did not start") from None
                time.sleep(0.02)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def end(self):
        self.process.terminate()
        self.process.wait()


class Subscriber:
    """One session, QoS 1, that acknowledges what it got. Source: MQTT 3.1.1, OASIS 2014, chapter 3."""

    def __init__(self, port, filter_, user=None, password=None, ca=None, clean=True, name=""):
        self.socket = socket.create_connection(("127.0.0.1", port))
        if ca:
            self.socket = ssl.create_default_context(cafile=ca).wrap_socket(self.socket, server_hostname="localhost")
        self.socket.settimeout(PATIENCE_S)
        flags = (2 if clean else 0) | (0xC0 if user else 0)
        fields = [name] + ([user, password] if user else [])
        self.send(0x10, self.text("MQTT") + bytes([4, flags, 0, 0]) + b"".join(map(self.text, fields)))
        kind, body = self.packet()
        if kind != 0x20 or body[1] != 0:
            raise PermissionError(f"refused: {body}")
        self.send(0x82, struct.pack(">H", 1) + self.text(filter_) + b"\1")
        self.early, self.dealt_with = [], None
        while (packet := self.packet())[0] != 0x90:
            self.early.append(packet)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    @staticmethod
    def text(words):
        return struct.pack(">H", len(words.encode())) + words.encode()

    def send(self, kind, body):
        length, rest = b"", len(body)
        while True:
            rest, digit = rest >> 7, rest & 127
            length += bytes([digit | (128 if rest else 0)])
            if not rest:
                break
        self.socket.sendall(bytes([kind]) + length + body)

    def exactly(self, count):
        got = b""
        while len(got) < count:
            part = self.socket.recv(count - len(got))
            if not part:
                raise ConnectionError("the broker has gone")
            got += part
        return got

    def packet(self):
        kind, length, shift = self.exactly(1)[0], 0, 0
        while True:
            digit = self.exactly(1)[0]
            length |= (digit & 127) << shift
            shift += 7
            if digit < 128:
                return kind, self.exactly(length)

    def receive(self):
        """As receive_bytes, of a payload that is text."""
        topic, payload, retained = self.receive_bytes()
        return topic, payload.decode(), retained

    def publish(self, topic, payload):
        """QoS 0."""
        self.send(0x30, self.text(topic) + payload)

    def receive_bytes(self):
        """Topic, payload and whether it was retained, of the next message. It is acknowledged by the next call, when
        it has been dealt with. What a broker that died had sent before is read all the same: it told the sender
        that it has it, and wrote nothing to the disk yet."""
        if self.dealt_with:
            with contextlib.suppress(OSError):
                self.send(0x40, self.dealt_with)
            self.dealt_with = None
        while True:
            kind, body = self.early.pop(0) if self.early else self.packet()
            if kind >> 4 != 3:
                continue
            size = struct.unpack_from(">H", body)[0]
            topic, rest = body[2:2 + size].decode(), body[2 + size:]
            if kind >> 1 & 3:
                self.dealt_with, rest = rest[:2], rest[2:]
            return topic, rest, bool(kind & 1)
