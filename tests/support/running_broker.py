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
import threading
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


class ForgetfulBroker:
    """Acknowledges events, delivers none, and forgets them when it loses its connections: what a broker does that keeps
    in memory what it has acknowledged, and dies. Source: MQTT 3.1.1, OASIS 2014, chapter 3."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.connections, self.events = [], []  # of each connection, the payloads that it acknowledged
        self.threads = [threading.Thread(target=self.accept)]
        self.threads[0].start()

    def accept(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            events = []
            self.events.append(events)
            self.connections.append(connection)
            self.threads.append(threading.Thread(target=self.serve, args=(connection, events)))
            self.threads[-1].start()

    def serve(self, connection, events):
        with connection, contextlib.suppress(OSError):
            while True:
                kind, body = packet_from(connection)
                if kind >> 4 == 1:
                    connection.sendall(b"\x20\x02\0\0")
                elif kind >> 4 == 12:
                    connection.sendall(b"\xd0\0")
                elif kind >> 4 == 3 and kind >> 1 & 3:
                    size = struct.unpack_from(">H", body)[0]
                    events.append(body[4 + size:].decode())
                    connection.sendall(b"\x40\x02" + body[2 + size:4 + size])

    def die(self):
        for connection in self.connections:
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
        self.connections.clear()

    def end(self):
        self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        self.threads[0].join()
        self.die()
        for thread in self.threads[1:]:
            thread.join()


def exactly(connection, count):
    got = b""
    while len(got) < count:
        part = connection.recv(count - len(got))
        if not part:
            raise ConnectionError("the other side has gone")
        got += part
    return got


def packet_from(connection):
    """The first byte and the body of the next packet."""
    kind, length, shift = exactly(connection, 1)[0], 0, 0
    while True:
        digit = exactly(connection, 1)[0]
        length |= (digit & 127) << shift
        shift += 7
        if digit < 128:
            return kind, exactly(connection, length)


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

    def packet(self):
        return packet_from(self.socket)

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
