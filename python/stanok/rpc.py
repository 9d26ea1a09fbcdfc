"""A client of a running machine: the operator protocol of ``stanokd`` in pure Python.

``connect()`` returns a :class:`Client`, which has each method of the protocol
(docs/reference/protocol.md)::

    with stanok.connect() as machine:
        machine.machine.on()
        machine.program.run("part.nc", wait="done")
        for event in machine.events():
            print(event["code"], event["text"])
"""
from __future__ import annotations

import collections
import itertools
import json
import os
import socket
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Union

from .errors import ConnectionLost, Fault, RequestError
from .methods import MOVES, STOPS, Methods

__all__ = ["Address", "Client", "Notification", "connect", "merged", "stop"]

Address = Union[str, "os.PathLike[str]", tuple[str, int], None]

_bytes_max = 64 << 20  # of a line: the daemon's are shorter by far
_slice_s = 0.05  # of waiting for what the daemon tells unasked
_waiting_max = 10_000  # notifications that nobody takes
_stop_timeout_s = 1.0


class Notification(collections.namedtuple("Notification", "method params")):
    """A message that the daemon sends without a request: ``status``, ``event``, ``dropped``."""

    method: str
    params: dict[str, Any]


class _Connection:
    """Lines of JSON to and from a daemon."""

    def __init__(self, address: Address, timeout_s: float | None) -> None:
        self._timeout_s = timeout_s
        self._socket = _connected(address, timeout_s)
        self._buffer = bytearray()

    def send(self, number: int, method: str, params: Mapping[str, Any]) -> None:
        message = {"jsonrpc": "2.0", "id": number, "method": method, "params": params}
        try:
            self._socket.settimeout(self._timeout_s)
            self._socket.sendall(json.dumps(message).encode() + b"\n")
        except TimeoutError as error:
            self._socket.close()  # a part of the line is there: what is sent behind it would be its end
            raise ConnectionLost("the daemon takes nothing; the connection was closed") from error
        except OSError as error:
            raise ConnectionLost(f"the connection to the daemon was lost: {error}") from error

    def receive(self, deadline: float | None) -> dict[str, Any] | None:
        """The next message; ``None``: none until the deadline."""
        while b"\n" not in self._buffer:
            if len(self._buffer) > _bytes_max:
                raise ConnectionLost("the daemon sent a line without an end")
            left = None if deadline is None else deadline - time.monotonic()
            if left is not None and left <= 0.0:
                return None
            try:
                self._socket.settimeout(left)
                received = self._socket.recv(1 << 16)
            except TimeoutError:
                return None
            except OSError as error:
                raise ConnectionLost(f"the connection to the daemon was lost: {error}") from error
            if not received:
                raise ConnectionLost("the daemon closed the connection")
            self._buffer += received
        line, _, rest = bytes(self._buffer).partition(b"\n")
        self._buffer = bytearray(rest)
        try:
            message = json.loads(line)
        except ValueError as error:
            raise ConnectionLost("the program that answers at this address is not a daemon of stanok") from error
        return message if isinstance(message, dict) else {}

    def close(self) -> None:
        self._socket.close()


class Client(Methods):
    """A connection to a daemon. It has each method of the protocol, by noun and verb.

    ``client.machine.status()`` calls ``machine.status``. Parameters are keywords, in mm, deg and s as in the
    protocol; the result is the ``dict`` that the protocol describes. A refused request raises
    :class:`~stanok.RequestError` with code, place and remedy, and a lost connection raises
    :class:`~stanok.ConnectionLost`. Calls of several threads are made one after another, except those that stop the
    machine: each of these is sent immediately on its own connection, and is answered even if all connections of the
    daemon are in use. A call that begins motion is refused if it reaches the machine too late (E6073).

    Args:
        address: see :func:`connect`.
        timeout_s: time to wait for an answer; ``None``: no limit. After it, ``TimeoutError`` is raised, and the
            daemon continues with the request.
    """

    def __init__(self, address: Address = None, *, timeout_s: float | None = 30.0) -> None:
        self._address = address
        self._timeout_s = timeout_s
        self._connection = _Connection(address, timeout_s)
        self._numbers = itertools.count(1)
        self._notifications: collections.deque[Notification] = collections.deque()
        self._state: Any = {}  # from the status messages so far
        self._lock = threading.RLock()
        super().__init__(self.call)
        try:
            self._hello = self._greeting()
        except BaseException:
            self._connection.close()
            raise

    @property
    def hello(self) -> dict[str, Any]:
        """The first message of the daemon: server, version, machine, channels, session and role."""
        return dict(self._hello)

    def call(self, method: str, params: Mapping[str, Any] | None = None, *,
             timeout_s: float | None = None) -> dict[str, Any]:
        """Calls a method by its name; returns the members of the result.

        ``timeout_s`` replaces that of the client; without it, the answer to a stop is waited for 1 s.
        """
        if method in STOPS:
            return stop(self._address, method, params, timeout_s=timeout_s or _stop_timeout_s)
        given = dict(params or {})
        with self._lock:
            deadline = _deadline(self._timeout_s if timeout_s is None else timeout_s)
            if method in MOVES and "seen_cycle" not in given:
                given["seen_cycle"] = self._asked("machine.status", {}, deadline)["cycle"]
            return self._asked(method, given, deadline)

    def _asked(self, method: str, params: dict[str, Any], deadline: float | None) -> dict[str, Any]:
        number = next(self._numbers)
        self._connection.send(number, method, params)
        while True:
            message = self._receive(deadline)
            if message is None:
                raise TimeoutError(f"{method}: no answer in time; the daemon continues with the request")
            if message.get("id") == number and "method" not in message:
                return _result(message)
            self._keep(message)

    def notifications(self, timeout_s: float | None = None) -> Iterator[Notification]:
        """Messages that the daemon sends without a request, as they come; ends if none comes for ``timeout_s``.

        Other threads may make calls meanwhile. Of the messages that nobody has taken yet, one ``status`` with the
        whole state is kept, and the newest of all others, 10,000 together: ``seq`` of the events shows a gap.
        """
        while True:
            notification = self._next_notification(_deadline(timeout_s))
            if notification is None:
                return
            yield notification

    def events(self, timeout_s: float | None = None) -> Iterator[dict[str, Any]]:
        """Yield alarms, warnings and messages as they come, each once.

        Each is ``{"seq", "cycle", "channel", "code", "text", "line"}``. The subscription begins when the first one
        is requested. It ends if none comes for ``timeout_s``.
        """
        self.call("subscribe", {"topics": ["events"]})
        for notification in self.notifications(timeout_s):
            if notification.method == "event":
                yield notification.params

    def states(self, topics: Sequence[str] = ("machine", "channels", "drives"), *, rate_hz: float = 10.0,
               timeout_s: float | None = None) -> Iterator[dict[str, Any]]:
        """Yield the whole state of these topics after each change, at most ``rate_hz`` times a second."""
        self.call("subscribe", {"topics": list(topics), "rate_hz": rate_hz})
        state: Any = {}
        for notification in self.notifications(timeout_s):
            if notification.method != "status":
                continue
            change = notification.params["state"]
            state = change if notification.params.get("full") else merged(state, change)
            yield state

    def close(self) -> None:
        """Closes the connection; a running program continues."""
        self._connection.close()

    def __enter__(self) -> Client:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Client of {self._hello.get('machine')}: {self._hello.get('role')}>"

    def _greeting(self) -> dict[str, Any]:
        message = self._receive(_deadline(self._timeout_s))
        if message is None:
            raise ConnectionLost("no daemon of stanok answers at this address")
        if message.get("method") == "dropped":
            raise ConnectionLost([_fault(message.get("params") or {})])
        if message.get("method") != "hello":
            raise ConnectionLost("the program that answers at this address is not a daemon of stanok")
        params: dict[str, Any] = message["params"]
        return params

    def _next_notification(self, deadline: float | None) -> Notification | None:
        """Waits in slices, between which other threads can act; ``None``: none until the deadline."""
        while True:
            with self._lock:
                if self._notifications:
                    return self._notifications.popleft()
                message = self._receive(_earlier(deadline, time.monotonic() + _slice_s))
                if message is not None:
                    self._keep(message)
                    continue
            if deadline is not None and time.monotonic() >= deadline:
                return None
            time.sleep(0.001)

    def _keep(self, message: dict[str, Any]) -> None:
        if "method" not in message:
            return
        notification = Notification(message["method"], message.get("params") or {})
        if notification.method == "status":
            notification = self._instead_of_waiting_status(notification)
        elif len(self._notifications) >= _waiting_max:
            self._notifications.popleft()
        self._notifications.append(notification)

    def _instead_of_waiting_status(self, status: Notification) -> Notification:
        change = status.params.get("state")
        self._state = change if status.params.get("full") else merged(self._state, change)
        waiting = [one for one in self._notifications if one.method == "status"]
        if not waiting:
            return status
        self._notifications.remove(waiting[0])
        return Notification("status", {**status.params, "full": True, "state": self._state})

    def _receive(self, deadline: float | None) -> dict[str, Any] | None:
        try:
            return self._connection.receive(deadline)
        except ConnectionLost as error:
            raise ConnectionLost(self._why_it_went() or str(error)) from error

    def _why_it_went(self) -> str:
        for notification in self._notifications:
            if notification.method == "dropped":
                return f"the daemon closed the connection: {_fault(notification.params)}"
        return ""


def connect(address: Address = None, *, timeout_s: float | None = 30.0) -> Client:
    """Connects to a running daemon.

    Args:
        address: the socket of the daemon as a path; ``("host", port)`` or ``"tcp://host:port"`` if it is
            forwarded over TCP (``ssh -L 7001:/run/stanok/mill.sock host``); ``None``: as for ``stanok``, that of
            ``$STANOK_SOCKET``, otherwise the only one of this user.
        timeout_s: time to wait for answers; ``None``: no limit.

    Raises:
        ConnectionLost: no daemon answers.
    """
    return Client(address, timeout_s=timeout_s)


def stop(address: Address = None, method: str = "machine.estop", params: Mapping[str, Any] | None = None, *,
         timeout_s: float = _stop_timeout_s) -> dict[str, Any]:
    """Stops the machine on a separate connection, whatever else its daemon and this program do.

    Args:
        address: see :func:`connect`.
        method: ``machine.estop``, ``machine.off``, ``program.hold``, ``program.stop`` or ``program.reset``.
        params: ``{"channel": N}``, for the methods of ``program``.
        timeout_s: time to wait for the answer.

    Raises:
        ConnectionLost: nothing was sent, or the daemon has ended.
        TimeoutError: the stop was sent but not answered. Do not wait: use the emergency stop of the machine.
    """
    if method not in STOPS:
        raise ValueError(f"{method} does not stop anything; give one of {', '.join(sorted(STOPS))}")
    connection = _Connection(address, timeout_s)
    try:
        connection.send(1, method, dict(params or {}))
        deadline = _deadline(timeout_s)
        while (message := connection.receive(deadline)) is not None:
            if message.get("id") == 1 and "method" not in message:
                return _result(message)
    finally:
        connection.close()
    raise TimeoutError(f"{method}: sent but not answered; use the emergency stop of the machine")


def _result(message: dict[str, Any]) -> dict[str, Any]:
    if "error" in message:
        raise _refusal(message["error"])
    result = message.get("result")
    return result if isinstance(result, dict) else {"result": result}


def merged(state: Any, change: Any) -> Any:
    """``state`` with a merge patch (RFC 7396): members replace, ``None`` removes."""
    if not isinstance(change, dict):
        return change
    result = dict(state) if isinstance(state, dict) else {}
    for name, value in change.items():
        if value is None:
            result.pop(name, None)
        else:
            result[name] = merged(result.get(name), value)
    return result


def _deadline(timeout_s: float | None) -> float | None:
    return None if timeout_s is None else time.monotonic() + timeout_s


def _earlier(deadline: float | None, other: float) -> float:
    return other if deadline is None else min(deadline, other)


def _fault(data: Mapping[str, Any], message: str = "") -> Fault:
    return Fault.from_json({**data, "message": message or data.get("message") or data.get("text") or ""})


def _refusal(error: Mapping[str, Any]) -> RequestError:
    data = error.get("data") or {}
    return RequestError([_fault(data, str(error.get("message", "")))], int(error.get("code", 0)), dict(data))


def _connected(address: Address, timeout_s: float | None) -> socket.socket:
    try:
        if isinstance(address, tuple):
            return socket.create_connection((address[0], int(address[1])), timeout_s)
        if isinstance(address, str) and address.startswith("tcp://"):
            host, _, port = address.removeprefix("tcp://").rpartition(":")
            if not host or not port.isdigit():
                raise ValueError(f"{address!r} is not tcp://HOST:PORT")
            return socket.create_connection((host.strip("[]"), int(port)), timeout_s)
        path = _only_socket() if address is None else os.fspath(address)
        one = socket.socket(socket.AF_UNIX)
        try:
            one.settimeout(timeout_s)
            one.connect(path)
        except BaseException:
            one.close()
            raise
        return one
    except OSError as error:
        raise ConnectionLost(f"no daemon answers at {address or 'its socket'}: {error}") from error


def _only_socket() -> str:
    named = os.environ.get("STANOK_SOCKET")
    if named:
        return named
    folders = []
    if os.environ.get("XDG_RUNTIME_DIR"):
        folders.append(Path(os.environ["XDG_RUNTIME_DIR"]) / "stanok")
    state = _state_home()
    if state.is_dir():
        folders.extend(sorted(state.iterdir()))
    sockets = [path for folder in folders if folder.is_dir() for path in sorted(folder.glob("*.sock"))
               if path.is_socket()]
    if len(sockets) != 1:
        found = ", ".join(map(str, sockets)) or "none"
        raise ConnectionLost(f"give the socket of the daemon: {len(sockets)} were found ({found})")
    return str(sockets[0])


def _state_home() -> Path:
    if os.environ.get("XDG_STATE_HOME"):
        return Path(os.environ["XDG_STATE_HOME"]) / "stanok"
    if os.environ.get("HOME"):
        return Path(os.environ["HOME"]) / ".local" / "state" / "stanok"
    return Path(tempfile.gettempdir()) / f"stanok-{os.getuid()}"
