#!/usr/bin/env python3
"""Random requests of HTTP and random WebSocket frames, made of right ones: stanok-web lives on, serves others, and
takes no more memory.

usage: random_client_test.py STANOK_WEB SECONDS [SEED]
"""
import contextlib
import json
import os
import random
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from web_browser import Browser, Closed, FakeDaemon, Refused, Silence, connect, running_web  # noqa: E402

STANOK_WEB, SECONDS = sys.argv[1], float(sys.argv[2])
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else random.SystemRandom().randrange(1 << 32)
with open(STANOK_WEB, "rb") as program:
    IS_SANITIZED = b"__asan_init" in program.read()
GROWTH_MAX = (400 if IS_SANITIZED else 48) << 20  # 256 connections with all that they may hold

PIECES = (
    b"GET", b"POST", b"DELETE", b"HEAD", b"PUT", b" ", b"/", b"/ws", b"/api/session", b"/health", b"/assets/", b"..",
    b"%2e", b"%00", b"\\", b"?", b"#", b" HTTP/1.1", b" HTTP/1.0", b" HTTP/2.0", b"\r\n", b"\n", b"\r\n\r\n", b"\0", b"\xff",
    b"Host: 127.0.0.1", b"Host: ", b"Origin: http://127.0.0.1", b"Content-Length: ", b"Content-Length: 5", b"-1",
    b"18446744073709551616", b"Transfer-Encoding: chunked", b"\r\n5\r\nhello\r\n0\r\n\r\n", b"ffffffffffffffff\r\n",
    b"Connection: Upgrade", b"Upgrade: websocket", b"Sec-WebSocket-Version: 13", b"Sec-WebSocket-Key: dGhlIHNhbXBsZQ==",
    b"Expect: 100-continue", b"Cookie: ", b"=", b";", b"Content-Type: application/json", b"Accept-Encoding: gzip",
    b'{"token": "', b'{"name": "a", "password": "b"}', b"[" * 200, b"{" * 200)
MESSAGES = (
    b'{"jsonrpc":"2.0","id":1,"method":"machine.status"}', b"[" * 500, b"null", b"\xff\xfe", b"\n\n", b"",
    b'{"jsonrpc":"2.0","id":0,"method":"session.role","params":{"role":"integrator"}}', b'{"geometry":{',
    b'"result":{"geometry":{"base64":"AAAA","count":4294967295}}')


def requests_of(choice, browser):
    """Right requests, to be spoilt."""
    head = f"Host: {browser.web.host}\r\nOrigin: {browser.web.origin}\r\nCookie: {browser.cookie}\r\n".encode()
    body = b'{"token": "x"}'
    return choice((
        b"GET / HTTP/1.1\r\n" + head + b"\r\n",
        b"GET /api/session HTTP/1.1\r\n" + head + b"\r\n",
        b"POST /api/session HTTP/1.1\r\n" + head + b"Content-Type: application/json\r\nContent-Length: %d\r\n\r\n%s" %
        (len(body), body),
        b"GET /ws HTTP/1.1\r\n" + head + b"Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
        b"DELETE /api/nothing HTTP/1.1\r\n" + head + b"\r\n"))


def spoilt(chance, text):
    """Some bytes changed, pieces put in, parts left out or doubled."""
    text = bytearray(text)
    for _ in range(chance.randrange(1, 6)):
        at = chance.randrange(len(text) + 1)
        behind = min(len(text), at + chance.randrange(40))
        match chance.randrange(5):
            case 0:
                text[at:at] = chance.choice(PIECES)
            case 1:
                del text[at:behind]
            case 2:
                text[at:at] = text[at:behind]
            case 3 if at < len(text):
                text[at] = chance.randrange(256)
            case _:
                text[at:at] = bytes(chance.randrange(256) for _ in range(chance.randrange(20)))
    return bytes(text)


def ask_nonsense(chance, browser):
    with contextlib.suppress(OSError), connect(browser.web) as one:
        one.settimeout(1)
        text = spoilt(chance, requests_of(chance.choice, browser))
        for _ in range(chance.randrange(3)):
            text += spoilt(chance, requests_of(chance.choice, browser))
        cut = chance.randrange(len(text) + 1)
        one.sendall(text[:cut])
        one.sendall(text[cut:])
        if chance.random() < 0.5:
            one.shutdown(socket.SHUT_WR)
        answer = one.recv(65536)
        assert not answer or answer.startswith((b"HTTP/1.", b"\x81", b"\x88")), answer[:80]


def random_frame(chance):
    """A frame whose head may contradict its content."""
    payload = spoilt(chance, chance.choice(MESSAGES))
    if chance.random() < 0.1:
        payload *= chance.randrange(1, 400)
    right = len(payload)
    size = chance.choice((right, right, right, chance.randrange(1 << 16), chance.randrange(1 << 62)))
    first = chance.choice((0x81, 0x81, 0x01, 0x80, 0x82, 0x88, 0x89, 0x8A, chance.randrange(256)))
    mask = chance.choice((0x80, 0x80, 0x80, 0))
    if size < 126:
        head = struct.pack("!BB", first, mask | size)
    elif size < 1 << 16:
        head = struct.pack("!BBH", first, mask | 126, size)
    else:
        head = struct.pack("!BBQ", first, mask | 127, size)
    return head + (b"\0\0\0\0" if mask else b"") + payload


def talk_nonsense(chance, browser):
    with contextlib.suppress(OSError, Closed, Silence, Refused):
        window = browser.open_window()
        try:
            window.socket.settimeout(1)
            for _ in range(chance.randrange(1, 12)):
                window.socket.sendall(random_frame(chance))
            if chance.random() < 0.3:
                window.receive_frame()
        finally:
            window.close()


def another_link(folder):
    with socket.socket(socket.AF_UNIX) as desk:
        desk.connect(os.path.join(folder, "links.panel"))
        return json.loads(desk.makefile().read())["link"].split("#")[1]


def main():
    print(f"seed {SEED}")
    chance = random.Random(SEED)
    # The daemon of this test answers what is right only; what is not ends its connection.
    threading.excepthook = lambda _: None
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        os.makedirs(os.path.join(folder, "page", "assets"))
        with open(os.path.join(folder, "page", "index.html"), "w", encoding="ascii") as index:
            index.write("<p>the page")
        path = os.path.join(folder, "op.sock")
        stack.enter_context(FakeDaemon(path))
        web = stack.enter_context(running_web(STANOK_WEB, folder, path, error=subprocess.DEVNULL))
        browser, rude = Browser(web), Browser(web)
        browser.enter_by_link()
        end, rounds, before = time.monotonic() + SECONDS, 0, None
        while time.monotonic() < end:
            if rounds % 10 == 0 and rude.request("GET", "/api/session").status != 200:
                web.token = another_link(folder)  # it has ended its own session
                rude.enter_by_link()
            for act in (ask_nonsense, talk_nonsense):
                act(chance, rude)
            rounds += 1
            if rounds % 50 == 0:
                assert web.process.poll() is None, f"stanok-web ended with {web.process.returncode}"
                assert browser.request("GET", "/health").json()["status"] == "ok"
                assert browser.request("GET", "/api/session").status == 200, "the session of somebody else is gone"
                before = before or web.resident_bytes()
        assert browser.request("GET", "/").content == b"<p>the page"
        window = browser.open_window()
        assert window.receive()["method"] == "hello"
        window.close()
        grown = web.resident_bytes() - (before or web.resident_bytes())
        print(f"{rounds} requests and as many windows; {grown >> 10} KiB more than at the beginning")
        assert grown < GROWTH_MAX


main()
