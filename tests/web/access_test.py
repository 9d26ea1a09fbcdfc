#!/usr/bin/env python3
"""Who gets into stanok-web, and who does not: links, passwords, sessions, stolen cookies.

usage: access_test.py STANOK_WEB [unittest arguments]
"""
import contextlib
import json
import os
import pty
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from served_page import STANOK_WEB, WithServer, WithUsers  # noqa: E402
from web_browser import PATIENCE_S, Browser, Closed, FakeDaemon, Refused, new_link, running_web  # noqa: E402


class Links(WithServer):
    def test_a_link_opens_once(self):
        self.assertEqual(self.browser.request("GET", "/api/session").status, 401)
        self.browser.enter_by_link()
        session = self.browser.request("GET", "/api/session").json()
        self.assertEqual((session["role"], session["machine"]), ("integrator", "fake mill"))
        again = Browser(self.web).request("POST", "/api/session", {"token": self.web.token})
        self.assertEqual(again.status, 401)

    def test_the_cookie_is_for_this_server_only(self):
        answer = self.browser.request("POST", "/api/session", {"token": self.web.token})
        cookie = answer.fields["set-cookie"]
        for attribute in ("HttpOnly", "SameSite=Strict", "Path=/"):
            self.assertIn(attribute, cookie.split("; "))

    def test_the_owner_gets_another_link(self):
        self.web.token = self.another_link().split("#")[1]
        self.browser.enter_by_link()

    def test_a_wrong_link_opens_nothing(self):
        for content in ({"token": "wrong"}, {"token": ""}, {"token": 1}, {}, [], b"{", b"", b"[" * 5000):
            with self.subTest(content):
                self.assertIn(self.browser.request("POST", "/api/session", content).status, (400, 401))

    def test_a_form_of_a_foreign_page_is_no_request(self):
        content = {"token": self.web.token}
        form = self.browser.request("POST", "/api/session", content, Content_Type="text/plain")
        self.assertEqual(form.status, 415)
        foreign = self.browser.request("POST", "/api/session", content, Origin="http://evil.example")
        self.assertEqual(foreign.status, 403)
        self.browser.enter_by_link()

    def test_who_leaves_loses_his_windows(self):
        self.browser.enter_by_link()
        window = self.browser.open_window()
        window.receive()
        cookie, key = self.browser.cookie, self.browser.key
        self.assertEqual(self.browser.request("DELETE", "/api/session").status, 204)
        with self.assertRaises(Closed):
            window.receive()
        window.close()
        self.daemon.wait_until(lambda daemon: daemon.open == 0)
        self.browser.cookie, self.browser.key = cookie, key
        self.assertEqual(self.browser.request("GET", "/api/session").status, 401)
        with self.assertRaises(Refused) as refused:
            self.browser.open_window()
        self.assertEqual(refused.exception.status, 401)


class Restarts(unittest.TestCase):
    """A server that ends and comes back at the same port, with the same file of sessions."""
    PASSWORD = "correct horse battery"

    def setUp(self):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.folder = stack.enter_context(tempfile.TemporaryDirectory())
        self.sessions = os.path.join(self.folder, "state", "sessions")
        self.users = os.path.join(self.folder, "users")
        self.user("add", "anna", "--role", "operator")
        self.daemon = stack.enter_context(FakeDaemon(os.path.join(self.folder, "op.sock")))
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]

    def user(self, *arguments):
        subprocess.run([STANOK_WEB, "user", *arguments, "--users", self.users], input=self.PASSWORD + "\n", check=True,
                       capture_output=True, text=True, timeout=PATIENCE_S)

    def serving(self):
        return running_web(STANOK_WEB, self.folder, os.path.join(self.folder, "op.sock"), "--sessions", self.sessions,
                           "--listen", f"127.0.0.1:{self.port}", "--users", self.users, error=subprocess.DEVNULL)

    def kept(self):
        with open(self.sessions, encoding="utf-8") as file:
            return json.load(file)["sessions"]

    def status_of(self, browser, web):
        browser.web = web
        return browser.request("GET", "/api/session").status

    def enter_and_restart(self, change=lambda: None):
        """Two browsers, one by a link and one by a password, and their answers after the restart."""
        with self.serving() as web:
            browsers = Browser(web), Browser(web)
            browsers[0].enter_by_link()
            self.assertEqual(browsers[1].enter("anna", self.PASSWORD).status, 200)
        change()
        with self.serving() as web:
            return [self.status_of(browser, web) for browser in browsers]

    def test_sessions_survive_it(self):
        self.assertEqual(self.enter_and_restart(), [200, 200])

    def test_pages_open_again_and_have_their_roles(self):
        with self.serving() as web:
            browser = Browser(web)
            browser.enter("anna", self.PASSWORD)
        with self.serving() as web:
            browser.web = web
            window = browser.open_window()
            self.assertEqual(window.receive()["params"]["user"], "anna")
            self.assertEqual(json.loads(self.daemon.lines[-1])["params"], {"role": "operator", "name": "anna"})
            window.close()

    def test_they_survive_a_crash_and_so_does_their_end(self):
        with self.serving() as web:
            stays, leaves = Browser(web), Browser(web)
            stays.enter_by_link()
            leaves.enter("anna", self.PASSWORD)
            cookie, key = leaves.cookie, leaves.key
            self.assertEqual(leaves.request("DELETE", "/api/session").status, 204)
            web.process.kill()
            web.process.wait()
            web.process.returncode = 0  # as it was meant
        with self.serving() as web:
            leaves.cookie, leaves.key = cookie, key
            self.assertEqual((self.status_of(stays, web), self.status_of(leaves, web)), (200, 401))

    def test_the_file_is_for_its_owner_and_holds_no_secret(self):
        with self.serving() as web:
            browser = Browser(web)
            browser.enter_by_link()
            self.assertEqual(os.stat(self.sessions).st_mode & 0o777, 0o600)
            with open(self.sessions, encoding="utf-8") as file:
                text = file.read()
            self.assertNotIn(browser.cookie.split("=")[1], text)
            self.assertNotIn(browser.key, text)
            self.assertNotIn(web.token, text)

    def test_they_grow_old_while_it_is_away(self):
        for member, hours, status in (("begun_s", 7 * 24 + 1, 401), ("used_s", 13, 401), ("used_s", 11, 200)):
            def make_older():
                sessions = self.kept()
                for session in sessions:
                    session[member] -= hours * 3600
                with open(self.sessions, "w", encoding="utf-8") as file:
                    json.dump({"sessions": sessions}, file)
            with self.subTest(member=member, hours=hours):
                self.assertEqual(self.enter_and_restart(make_older), [status, status])

    def test_who_is_removed_or_changed_meanwhile_is_out(self):
        self.assertEqual(self.enter_and_restart(lambda: self.user("add", "anna", "--role", "observer")), [200, 401])
        self.user("add", "boris", "--role", "operator")
        self.assertEqual(self.enter_and_restart(lambda: self.user("remove", "anna")), [200, 401])

    def test_a_file_that_cannot_be_believed_lets_nobody_in(self):
        def damage():
            with open(self.sessions, "w", encoding="utf-8") as file:
                file.write('{"sessions": [{"secret": "00"')

        for change in (damage, lambda: os.chmod(self.sessions, 0o666)):
            with self.subTest(change):
                self.assertEqual(self.enter_and_restart(change), [401, 401])


class StolenCookies(WithServer):
    """A cookie goes to every port of the host; the key of its session stays in the storage of this origin."""

    def setUp(self):
        super().setUp()
        self.browser.enter_by_link()

    def thief(self, key=""):
        thief = Browser(self.web)
        thief.cookie, thief.key = self.browser.cookie, key
        return thief

    def test_a_cookie_alone_tells_nothing(self):
        for method, path in (("GET", "/api/session"), ("GET", "/api/machines"), ("DELETE", "/api/session")):
            with self.subTest(method=method, path=path):
                self.assertEqual(self.thief().request(method, path).status, 401)
        self.assertEqual(self.thief().request("POST", "/api/history", {"query": "runs"}).status, 401)
        self.assertEqual(self.browser.request("GET", "/api/session").status, 200)

    def test_a_wrong_key_ends_the_session_and_its_pages(self):
        window = self.browser.open_window()
        self.assertEqual(window.receive()["method"], "hello")
        self.assertEqual(self.thief("x" * 43).request("GET", "/api/session").status, 401)
        with self.assertRaises((Closed, OSError)):
            window.receive()
        window.close()
        self.assertEqual(self.browser.request("GET", "/api/session").status, 401)

    def test_a_window_without_the_key_sees_no_machine_and_ends_the_session(self):
        def machine_start(window):
            window.send({"jsonrpc": "2.0", "id": 1, "method": "program.start", "params": {"seen_cycle": 0}})

        def other_key(window):
            window.send({"jsonrpc": "2.0", "method": "session.key", "params": {"key": "x" * 43}})

        for first in (machine_start, other_key, lambda window: window.send("[]"), lambda window: window.send("nonsense")):
            with self.subTest(first):
                window = self.thief().open_window()
                first(window)
                with self.assertRaises((Closed, OSError)):
                    window.receive()
                window.close()
                self.assertEqual(self.browser.request("GET", "/api/session").status, 401)
                self.web.token = self.another_link().split("#")[1]
                self.browser.enter_by_link()
        self.assertEqual(self.daemon.lines, [])

    def test_a_window_that_says_nothing_ends_and_the_session_goes_on(self):
        window = self.thief().open_window()
        with self.assertRaises((Closed, OSError)):
            window.receive()
        window.close()
        self.assertEqual(self.browser.request("GET", "/api/session").status, 200)
        self.assertEqual(self.daemon.lines, [])

    def test_another_sign_in_of_the_browser_ends_the_session_before(self):
        window = self.browser.open_window()
        window.receive()
        before = self.thief(self.browser.key)
        self.web.token = self.another_link().split("#")[1]
        self.browser.enter_by_link()
        with self.assertRaises((Closed, OSError)):
            window.receive()
        window.close()
        self.assertEqual(before.request("GET", "/api/session").status, 401)
        self.assertEqual(self.browser.request("GET", "/api/session").status, 200)


class Users(WithUsers):
    def test_a_password_opens_in_the_role_of_the_user(self):
        self.assertEqual(self.browser.enter("anna", self.PASSWORD).status, 200)
        session = self.browser.request("GET", "/api/session").json()
        self.assertEqual((session["name"], session["role"]), ("anna", "operator"))
        window = self.browser.open_window()
        hello = window.receive()["params"]
        self.assertEqual((hello["role"], hello["user"]), ("operator", "anna"))
        self.assertIn(b'"session.role"', self.daemon.lines[0])
        self.assertIn(b'"operator"', self.daemon.lines[0])
        window.close()

    def test_a_role_is_lowered_before_anything_is_passed_on(self):
        self.user("add", "olga", "--role", "observer")
        self.wait_for_user("olga")
        window = self.browser.open_window()
        window.send({"jsonrpc": "2.0", "id": 1, "method": "program.start", "params": {"seen_cycle": 0}})
        self.daemon.wait_until(lambda daemon: len(daemon.lines) == 2)
        self.assertEqual(json.loads(self.daemon.lines[0])["params"], {"role": "observer", "name": "olga"})
        self.assertEqual(json.loads(self.daemon.lines[1])["method"], "program.start")
        window.close()

    def test_however_many_look_on_one_can_work(self):
        self.user("add", "olga", "--role", "observer")
        self.wait_for_user("olga")
        windows = [self.browser.open_window() for _ in range(50)]
        with self.assertRaises(Refused) as refused:
            self.browser.open_window()
        self.assertEqual(refused.exception.status, 503)
        anna = Browser(self.web)
        anna.enter("anna", self.PASSWORD)
        windows.append(anna.open_window())
        self.assertEqual(windows[-1].receive()["params"]["role"], "operator")
        for window in windows:
            window.close()

    def test_without_the_role_there_is_no_window(self):
        self.daemon.answer_to = lambda request: json.dumps(
            {"jsonrpc": "2.0", "id": request["id"], "error": {"code": -32601, "message": "no"}}).encode() + b"\n"
        self.browser.enter("anna", self.PASSWORD)
        window = self.browser.open_window()
        self.assertEqual(window.receive()["method"], "dropped")
        self.until_refused(window)

    def test_wrong_names_and_passwords_are_told_alike(self):
        wrong = self.browser.enter("anna", "wrong")
        nobody = Browser(self.web).enter("nobody", self.PASSWORD)
        self.assertEqual((wrong.status, nobody.status), (401, 401))
        self.assertEqual(wrong.content, nobody.content)
        for name, password in (("anna", ""), ("anna", "x" * 300), ("", ""), ("anna:", ""), ("an\0na", self.PASSWORD)):
            self.assertIn(self.browser.enter(name, password).status, (400, 401))
        self.assertEqual(self.browser.enter("anna", self.PASSWORD).status, 200)

    @contextlib.contextmanager
    def guessing(self, guessers):
        """Each guesses again as soon as it is answered; (name, address) as long as this lasts."""
        done = threading.Event()

        def guess(name, source):
            browser = Browser(self.web, source)
            while not done.is_set():
                with contextlib.suppress(OSError, Closed):
                    browser.enter(name, "wrong password")

        threads = [threading.Thread(target=guess, args=pair, daemon=True) for pair in guessers]
        for thread in threads:
            thread.start()
        try:
            time.sleep(3)  # they are at it
            yield
        finally:
            done.set()
            for thread in threads:
                thread.join(PATIENCE_S)

    def test_forty_addresses_that_guess_keep_nobody_out(self):
        with self.guessing([("anna", f"127.0.1.{k + 1}") for k in range(40)]):
            self.assertEqual(self.browser.enter("anna", self.PASSWORD).status, 200)

    def test_who_guesses_behind_the_same_tunnel_keeps_nobody_out(self):
        names = ("boris", "carl", "dora", "root", "admin")
        with self.guessing([(name, "127.0.0.1") for name in names for _ in range(4)]):
            self.assertEqual(self.browser.enter("anna", self.PASSWORD).status, 200)

    def test_a_user_who_is_removed_or_changed_loses_the_page(self):
        # New ones: the server may still know another anna when her password already opens.
        for name, change in (("maria", ("remove", "maria")), ("nina", ("add", "nina", "--role", "observer"))):
            self.user("add", name, "--role", "operator")
            self.wait_for_user(name)
            window = self.browser.open_window()
            window.receive()
            self.user(*change)
            self.until_refused(window)
            self.assertEqual(self.browser.request("GET", "/api/session").status, 401)

    def test_links_stay_when_users_change(self):
        self.browser.enter_by_link()
        self.user("add", "boris", "--role", "programmer")
        self.wait_for_user_of_another_browser("boris")
        self.assertEqual(self.browser.request("GET", "/api/session").status, 200)

    def wait_for_user_of_another_browser(self, name):
        mine, self.browser = self.browser, Browser(self.web)
        self.wait_for_user(name)
        self.browser = mine

    def test_the_file_holds_no_password_and_is_for_its_owner(self):
        self.user("add", "Анна Б.", "--role", "integrator")
        self.assertEqual(os.stat(self.users).st_mode & 0o777, 0o600)
        with open(self.users, encoding="utf-8") as file:
            text = file.read()
        self.assertNotIn(self.PASSWORD, text)
        self.assertIn("Анна Б.:integrator:$argon2id$", text)
        self.assertEqual([line.split() for line in self.user("list").splitlines()],
                         [["anna", "operator"], ["Анна", "Б.", "integrator"]])

    def test_what_is_no_user_is_refused(self):
        self.user("add", "a:b", "--role", "operator", code=2)
        self.user("add", "anna", "--role", "boss", code=2)
        self.user("add", "anna", code=2)
        self.user("remove", "nobody", code=1)
        self.PASSWORD = "short"
        self.assertIn("10 to 256 bytes", self.user("add", "carl", "--role", "operator", code=1))
        os.chmod(self.users, 0o644)
        self.assertIn("chmod 600", self.user("list", code=1))

    def test_a_damaged_file_changes_nothing(self):
        with open(self.users, "a", encoding="utf-8") as file:
            file.write("nonsense\n")
        self.assertIn("line 3", self.user("list", code=1))
        time.sleep(2)  # the server looks once a second: it keeps the users of before
        self.assertEqual(self.browser.enter("anna", self.PASSWORD).status, 200)


class WhatItPrints(unittest.TestCase):
    """A service prints into a journal, which others read; a terminal has one reader."""

    @contextlib.contextmanager
    def printing_to(self, output):
        with tempfile.TemporaryDirectory() as folder, FakeDaemon(os.path.join(folder, "op.sock")):
            server = subprocess.Popen([STANOK_WEB, "--listen", "127.0.0.1:0", "--socket", os.path.join(folder, "op.sock")],
                                      stdout=output, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
            try:
                yield server, os.path.join(folder, "op.panel")
            finally:
                server.terminate()
                server.wait(PATIENCE_S)

    def test_a_service_prints_no_link(self):
        with tempfile.TemporaryFile() as output:
            with self.printing_to(output) as (_, desk):
                end = time.monotonic() + PATIENCE_S
                while os.fstat(output.fileno()).st_size == 0:
                    self.assertLess(time.monotonic(), end, "it never said where it is")
                    time.sleep(0.01)
                token = new_link(desk).split("#")[1]
            output.seek(0)
            said = output.read().decode()
        self.assertRegex(said, r"http://127\.0\.0\.1:\d+\n")
        self.assertNotIn("#", said)
        self.assertNotIn(token, said)

    def test_a_terminal_gets_one(self):
        ours, its = pty.openpty()
        with self.printing_to(its), open(ours, "rb", buffering=0) as terminal:
            os.close(its)
            self.assertRegex(terminal.read(200).decode(), r"http://127\.0\.0\.1:\d+/#\S{43}\r\n")


if __name__ == "__main__":
    unittest.main(verbosity=2)
