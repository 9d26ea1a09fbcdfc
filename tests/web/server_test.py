#!/usr/bin/env python3
"""stanok-web as browsers see it, with a daemon that only speaks as one does.

usage: server_test.py STANOK_WEB [unittest arguments]
"""
import contextlib
import gzip
import os
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from served_page import STANOK_WEB, WithServer, WithUsers  # noqa: E402
from web_browser import PATIENCE_S, Browser, Closed, Refused, connect, running_web  # noqa: E402

with open(STANOK_WEB, "rb") as program:
    IS_SANITIZED = b"__asan_init" in program.read()


class Files(WithServer):
    def test_the_page_may_load_only_what_is_here_and_is_asked_for_anew(self):
        answer = self.browser.request("GET", "/")
        self.assertEqual((answer.status, answer.content), (200, b"<p>the page"))
        self.assertTrue(answer.fields["content-security-policy"].startswith("default-src 'self'; "))
        self.assertIn("frame-ancestors 'none'", answer.fields["content-security-policy"])
        self.assertNotIn("unsafe", answer.fields["content-security-policy"])
        self.assertEqual(answer.fields["cache-control"], "no-cache")
        self.assertEqual(answer.fields["x-content-type-options"], "nosniff")

    def test_what_has_its_hash_in_its_name_is_kept_for_ever(self):
        plain = self.browser.request("GET", "/assets/index-1a2b3c4d.js")
        self.assertEqual(plain.content, b"let x;")
        self.assertIn("immutable", plain.fields["cache-control"])
        small = self.browser.request("GET", "/assets/index-1a2b3c4d.js", Accept_Encoding="br, gzip")
        self.assertEqual(small.fields["content-encoding"], "gzip")
        self.assertEqual(small.fields["content-type"], "text/javascript; charset=utf-8")
        self.assertEqual(gzip.decompress(small.content), b"let x;")

    def test_what_is_text_is_compressed_for_those_who_take_it(self):
        text = "let x = 'всё то же';\n" * 1000
        for name in ("page/assets/long-1a2b.js", "page/index.html", "docs/README.md"):
            self.write(name, text)
            os.utime(os.path.join(self.folder, name), (1, 1))
        for path in ("/", "/assets/long-1a2b.js", "/manual/"):
            with self.subTest(path):
                plain = self.browser.request("GET", path)
                small = self.browser.request("GET", path, Accept_Encoding="deflate;q=0.5, gzip;q=1.0, *;q=0")
                self.assertEqual((plain.content, gzip.decompress(small.content)), (text.encode(), text.encode()))
                self.assertLess(10 * len(small.content), len(plain.content))
                self.assertEqual((plain.fields["vary"], small.fields["vary"]), ("Accept-Encoding", "Accept-Encoding"))
                self.assertNotEqual(plain.fields["etag"], small.fields["etag"])
                for fields in ("gzip;q=0, br", "gzip; q=0.000", "identity", "", "xgzip", "br"):
                    other = self.browser.request("GET", path, Accept_Encoding=fields)
                    self.assertNotIn("content-encoding", other.fields, fields)

    def test_what_the_browser_has_is_not_sent_again(self):
        first = self.browser.request("GET", "/")
        for tags in (first.fields["etag"], f'"x", W/{first.fields["etag"]}', "*"):
            again = self.browser.request("GET", "/", If_None_Match=tags)
            self.assertEqual((again.status, again.content), (304, b""), tags)
            self.assertEqual(again.fields["etag"], first.fields["etag"])
            self.assertEqual(again.fields["cache-control"], "no-cache")
        self.write("page/index.html", "<p>newer page")
        os.utime(os.path.join(self.folder, "page/index.html"), (1, 1))
        newer = self.browser.request("GET", "/", If_None_Match=first.fields["etag"])
        self.assertEqual((newer.status, newer.content), (200, b"<p>newer page"))

    def test_documents_are_sent_as_text_and_nothing_beside_them(self):
        answer = self.browser.request("GET", "/manual/operator/panel.md")
        self.assertEqual((answer.status, answer.content), (200, b"# The page"))
        self.assertEqual(answer.fields["content-type"], "text/plain; charset=utf-8")
        self.assertEqual(self.browser.request("GET", "/manual/").content, b"# Documents")
        for path in ("/manual/linked.md", "/manual/../secret.txt", "/manual/%2e%2e/secret.txt", "/manual//etc/passwd",
                     "/manual/operator", "/manual", "/operator/panel.md"):
            self.assertEqual(self.browser.request("GET", path).status, 404, path)

    def test_a_head_has_no_content(self):
        answer = self.browser.request("HEAD", "/")
        self.assertEqual((answer.status, answer.fields["content-length"]), (200, "11"))

    def test_a_page_that_was_built_anew_is_there_on_reload(self):
        self.write("page/index.html", "<p>newer")
        os.utime(os.path.join(self.folder, "page/index.html"), (1, 1))
        self.assertEqual(self.browser.request("GET", "/").content, b"<p>newer")

    def test_nothing_outside_of_the_folder_has_a_name(self):
        for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt", "//secret.txt",
                     "/linked.txt", "/..%2fsecret.txt", "/assets", "/index.html/", "/\\..\\secret.txt"):
            with self.subTest(path):
                self.assertEqual(self.browser.request("GET", path).status, 404)

    def test_other_methods_are_refused(self):
        for method in ("PUT", "DELETE", "POST", "OPTIONS", "PATCH"):
            with self.subTest(method):
                self.assertEqual(self.browser.request(method, "/").status, 405)


class Documents(WithServer):
    def test_health_and_method_table_are_for_everybody(self):
        self.assertEqual(self.browser.request("GET", "/health").json(), {"status": "ok", "daemon": True})
        document = self.browser.request("GET", "/api/openrpc.json").json()
        self.assertIn("program.start", [method["name"] for method in document["methods"]])

    def test_health_tells_that_no_daemon_answers(self):
        self.daemon.listener.close()
        os.unlink(os.path.join(self.folder, "op.sock"))
        self.assertEqual(self.browser.request("GET", "/health").json(), {"status": "ok", "daemon": False})


class Windows(WithServer):
    def setUp(self):
        super().setUp()
        self.browser.enter_by_link()

    def test_messages_pass_as_they_are(self):
        window = self.browser.open_window()
        self.assertEqual(window.receive()["params"]["machine"], "fake mill")
        window.send('{"jsonrpc":"2.0",\n "id":7, "method":"x",\r\n "params":{"text":"\\nж"}}')
        self.assertEqual(window.receive(), {"jsonrpc": "2.0", "id": 7, "result": {"text": "\nж"}})
        self.assertEqual(self.daemon.lines[-1].decode(),
                         '{"jsonrpc":"2.0",  "id":7, "method":"x",   "params":{"text":"\\nж"}}\n')
        window.close()

    def moves(self):
        document = self.browser.request("GET", "/api/openrpc.json").json()
        return [method for method in document["methods"] if method["x-effect"] == "begins_motion"]

    @staticmethod
    def required(method):
        """Parameters that a method cannot do without."""
        examples = {"integer": 1, "number": 1.0, "string": "X"}
        return {one["name"]: one["schema"].get("enum", [examples[one["schema"]["type"]]])[0]
                for one in method["params"] if one.get("required")}

    def test_motion_of_a_page_that_hides_what_it_saw_does_not_begin(self):
        window = self.browser.open_window()
        window.receive()
        passed = len(self.daemon.lines)
        self.assertGreater(len(self.moves()), 8)
        for method in self.moves():
            parameters = self.required(method)
            for hidden in (parameters, list(parameters.values())):
                with self.subTest(method["name"], hidden=hidden):
                    answer = window.answer_as_is(method["name"], hidden)
                    self.assertEqual(answer["error"]["data"]["code"], "E6073")
            window.send({"jsonrpc": "2.0", "method": method["name"], "params": parameters})
        self.assertEqual(window.ask("machine.status"), {})
        self.assertEqual(len(self.daemon.lines), passed + 1, "only the last one")
        window.close()

    def test_motion_of_a_page_that_says_what_it_saw_is_passed_on(self):
        window = self.browser.open_window()
        window.receive()
        for method in self.moves():
            parameters = {**self.required(method), "seen_cycle": 7}
            self.assertEqual(window.answer_as_is(method["name"], parameters)["result"], parameters)
        for method, parameters in (("override.feed", {"percent": 50}), ("jog", {"axis": 1}), ("tool.set", {"number": 1})):
            self.assertEqual(window.answer_as_is(method, parameters)["result"], parameters, "it is the daemon's to judge")
        window.close()

    def test_a_stop_that_nobody_answers_is_said_to_be_that(self):
        def answer_to(request, answer=self.daemon.answer_to):
            return b"" if request["method"] == "program.hold" else answer(request)
        self.daemon.answer_to = answer_to
        window = self.browser.open_window()
        window.receive()
        error = window.answer("program.hold", channel=1)["error"]
        self.assertEqual(error["data"]["code"], "E9016")
        self.assertIn("sent but not answered", error["message"])
        self.assertEqual(window.ask("machine.status"), {}, "the window goes on")
        self.daemon.wait_until(lambda daemon: daemon.open == 1)
        window.close()

    def test_the_connection_to_the_daemon_ends_with_the_browser(self):
        window = self.browser.open_window()
        window.receive()
        self.daemon.wait_until(lambda daemon: daemon.open == 1)
        window.socket.close()
        window.stream.close()
        self.daemon.wait_until(lambda daemon: daemon.open == 0)

    def test_foreign_pages_and_names_get_none(self):
        for changed in ({"Origin": "http://evil.example"}, {"Origin": None}, {"Origin": "null"},
                        {"Origin": f"https://{self.web.host}"}, {"Origin": "http://127.0.0.1:1"},
                        {"Host": "evil.example"}, {"Host": None},
                        {"Host": "evil.example", "Origin": "http://evil.example"},
                        {"Host": "127.0.0.1.evil.example"}, {"Host": "127.0.0.1:80:80"}, {"Host": ""}):
            with self.subTest(changed), self.assertRaises(Refused) as refused:
                self.browser.open_window(**changed)
            self.assertIn(refused.exception.status, (400, 403))

    def test_without_a_session_there_is_none(self):
        for cookie in (None, "stanok-session=x", self.browser.cookie + "x", self.browser.cookie.replace("=", "=x")):
            with self.subTest(cookie), self.assertRaises(Refused) as refused:
                self.browser.open_window(Cookie=cookie)
            self.assertEqual(refused.exception.status, 401)

    def test_behind_a_tunnel_the_port_differs(self):
        window = self.browser.open_window(Host="localhost:9999", Origin="http://localhost:9999")
        self.assertEqual(window.receive()["method"], "hello")
        window.close()

    def test_binary_and_too_long_messages_end_the_window(self):
        for opcode, payload in ((2, b"x"), (1, b" " * ((1 << 20) + 1)), (1, b"\xff\xfe")):
            window = self.browser.open_window()
            window.receive()
            with contextlib.suppress(OSError):
                window.send_frame(opcode, payload)
            with self.assertRaises((Closed, OSError)):
                window.receive()
            window.close()
        self.daemon.wait_until(lambda daemon: daemon.open == 0)

    def test_without_a_daemon_the_page_is_told_so(self):
        self.daemon.listener.close()
        os.unlink(os.path.join(self.folder, "op.sock"))
        window = self.browser.open_window()
        self.assertEqual(window.receive()["method"], "dropped")
        with self.assertRaises(Closed):
            window.receive()
        window.close()

    def test_a_daemon_that_goes_while_a_message_goes_wrong_leaves_no_place_taken(self):
        def answer_or_go(request, answer=self.daemon.answer_to):
            if request["method"] == "go":
                raise OSError
            return answer(request)

        self.daemon.answer_to = answer_or_go
        for round_of_test in range(200):
            window = self.browser.open_window()
            window.receive()
            with contextlib.suppress(OSError):
                window.send({"jsonrpc": "2.0", "id": 1, "method": "go", "params": {}})
                window.socket.sendall(b"\x81\x8a\0\0\0\0ab")  # 2 of 10 bytes of a text
                time.sleep(round_of_test % 20 * 2e-4)
                window.socket.sendall(b"\xff" * 8)  # which are no text
                window.socket.shutdown(socket.SHUT_WR)
            window.close()
        self.daemon.wait_until(lambda daemon: daemon.open == 0)
        places = []
        end = time.monotonic() + PATIENCE_S
        while len(places) < 60 and time.monotonic() < end:
            with contextlib.suppress(Refused):
                places.append(self.browser.open_window())
        self.assertEqual(len(places), 60)
        for window in places:
            window.close()

    def test_there_are_sixty_places(self):
        windows = [self.browser.open_window() for _ in range(60)]
        with self.assertRaises(Refused) as refused:
            self.browser.open_window()
        self.assertEqual(refused.exception.status, 503)
        for window in windows:
            window.close()


def certificate(folder):
    """Certificate and key for TLS, new."""
    files = os.path.join(folder, "cert.pem"), os.path.join(folder, "key.pem")
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                    "-subj", "/CN=localhost", "-out", files[0], "-keyout", files[1]], check=True, capture_output=True)
    return files


class Tls(WithUsers):
    """Users behind TLS, and what only that admits."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.certificate, self.key = certificate(folder.name)
        super().setUp()

    def start_options(self):
        return *self.options, "--tls-cert", self.certificate, "--tls-key", self.key

    def test_cookies_go_through_tls_only(self):
        self.assertEqual(self.web.scheme, "https")
        answer = self.browser.enter("anna", self.PASSWORD)
        self.assertIn("Secure", answer.fields["set-cookie"].split("; "))
        self.assertIn("max-age", answer.fields["strict-transport-security"])

    def test_plain_requests_get_nothing(self):
        with socket.create_connection(("127.0.0.1", self.web.port), PATIENCE_S) as one:
            one.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
            with contextlib.suppress(ConnectionResetError):
                self.assertNotIn(b"200", one.recv(1000))
        self.assertEqual(self.browser.request("GET", "/").status, 200)

    def test_with_tls_and_users_it_listens_everywhere(self):
        socket_path = os.path.join(self.folder, "op.sock")
        with running_web(STANOK_WEB, self.folder, socket_path, *self.start_options(), "--listen", "0.0.0.0:0",
                         "--link-socket", os.path.join(self.folder, "other.panel"), error=subprocess.DEVNULL) as web:
            browser = Browser(web)
            self.assertEqual(browser.enter("anna", self.PASSWORD).status, 200)
            browser.open_window().close()
            self.assertEqual(browser.request("GET", "/", Host="evil.example").status, 403)

    def test_behind_a_socket_for_both_kinds_addresses_of_ipv4_are_many(self):
        socket_path = os.path.join(self.folder, "op.sock")
        with running_web(STANOK_WEB, self.folder, socket_path, *self.start_options(), "--listen", "[::]:0",
                         "--link-socket", os.path.join(self.folder, "other.panel"), error=subprocess.DEVNULL) as web:
            self.assertEqual(Browser(web, "127.0.0.2").enter("anna", "wrong password").status, 401)
            guesser = threading.Thread(target=Browser(web, "127.0.0.2").enter, args=("anna", "wrong password"))
            guesser.start()
            time.sleep(0.5)  # it waits for its answer
            self.assertEqual(Browser(web, "127.0.0.1").enter("anna", self.PASSWORD).status, 200)
            guesser.join()

    def test_but_not_without_a_user(self):
        self.user("remove", "anna")
        done = subprocess.run([STANOK_WEB, "--listen", "0.0.0.0:0", "--socket", "/x", *self.start_options()],
                              capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("no users yet", done.stderr)

    def test_clients_that_only_begin_tls_keep_nobody_out(self):
        half = [socket.create_connection(("127.0.0.1", self.web.port), PATIENCE_S) for _ in range(300)]
        self.assertEqual(self.browser.request("GET", "/health").status, 200)
        for one in half:
            one.close()


class RudeClients(WithServer):
    def test_heads_and_contents_are_bounded(self):
        self.assertEqual(self.browser.request("GET", "/", X="x" * 20000).status, 431)
        self.assertEqual(self.browser.request("POST", "/api/session", b" " * 10000).status, 413)

    def test_what_is_no_http_gets_an_answer_or_the_end(self):
        for line in (b"\x00\x01\x02\x03\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01",
                     b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: -1\r\n\r\n",
                     b"GET / HTTP/1.1\r\nHost: a\r\nHost: 127.0.0.1\r\n\r\n"):
            with self.subTest(line), connect(self.web) as one:
                one.sendall(line)
                one.shutdown(socket.SHUT_WR)
                self.assertNotIn(b" 200 ", one.recv(100))
        self.assertEqual(self.browser.request("GET", "/").status, 200)

    def test_a_thousand_slow_clients_keep_nobody_out_and_memory_bounded(self):
        self.browser.enter_by_link()
        window = self.browser.open_window()
        window.receive()
        before = self.web.resident_bytes()
        rude = []
        for k in range(1000):
            one = connect(self.web)
            # Begins a head, or a content, or asks and reads nothing; and goes on for ever.
            one.sendall((b"GET / HTTP/1.1\r\nX: " + b"x" * 8000,
                         b"POST /api/session HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 8000\r\n\r\n[" + b" " * 7000,
                         b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" * 100)[k % 3])
            rude.append(one)
            if k % 100 == 0:  # a page that answers no pings is taken for gone
                self.assertEqual(window.ask("still", here=k), {"here": k})
        self.assertEqual(self.browser.request("GET", "/health").status, 200)
        self.assertEqual(window.ask("still", here=1), {"here": 1})
        grown = self.web.resident_bytes() - before
        # 256 connections, a head, a content and a coroutine each; sanitizers keep what was freed for a while.
        self.assertLess(grown, (400 if IS_SANITIZED else 40) << 20)
        for one in rude:
            one.close()
        window.close()

    def test_who_does_not_read_loses_the_connection(self):
        self.browser.enter_by_link()
        window = self.browser.open_window()
        window.receive()
        self.daemon.answer_to = lambda request: b'{"jsonrpc":"2.0","method":"x","params":"' + b"x" * 200000 + b'"}\n'
        with contextlib.suppress(OSError):
            for _ in range(100):
                window.send({"jsonrpc": "2.0", "id": 1, "method": "x", "params": {}})
        self.daemon.wait_until(lambda daemon: daemon.open == 0)
        window.close()

    def test_a_daemon_that_does_not_greet_keeps_no_place(self):
        self.daemon.answer_to = lambda request: b"{}\n"
        self.browser.enter_by_link()
        window = self.browser.open_window()
        with self.assertRaises((Closed, OSError)):
            window.receive()
        window.close()
        self.daemon.wait_until(lambda daemon: daemon.open == 0)

    def test_a_slow_head_ends(self):
        with connect(self.web) as one:
            one.settimeout(PATIENCE_S)
            with contextlib.suppress(OSError):
                for _ in range(PATIENCE_S * 4):
                    one.sendall(b"G")
                    one.settimeout(0.25)
                    try:
                        if one.recv(1) == b"":
                            return
                    except TimeoutError:
                        continue
                self.fail("the connection is still there")


class CommandLine(unittest.TestCase):
    def expect(self, code, text, *arguments):
        done = subprocess.run([STANOK_WEB, *arguments], capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn(text, done.stdout + done.stderr)

    def test_usage(self):
        self.expect(0, "--listen", "--help")
        self.expect(2, "--listen needs", "--listen", "8080")
        self.expect(2, "--listen needs", "--listen", "localhost:8080")
        self.expect(2, "belong together", "--socket", "/x", "--tls-cert", "/x")

    def test_other_addresses_than_loopback_want_tls_and_users(self):
        for address in ("0.0.0.0:0", "[::]:0", "192.0.2.1:0"):
            self.expect(2, "stanok-web user add", "--socket", "/x", "--listen", address)

    def test_what_cannot_be_opened_is_told(self):
        with socket.create_server(("127.0.0.1", 0)) as taken, tempfile.TemporaryDirectory() as folder:
            port = taken.getsockname()[1]
            self.expect(1, "Address already in use", "--socket", f"{folder}/x", "--listen", f"127.0.0.1:{port}")
            self.expect(1, "not a TLS certificate", "--socket", f"{folder}/x", "--listen", "127.0.0.1:0", "--tls-cert",
                        f"{folder}/none", "--tls-key", f"{folder}/none")


if __name__ == "__main__":
    unittest.main(verbosity=2)
