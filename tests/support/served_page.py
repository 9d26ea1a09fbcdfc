"""Tests of stanok-web before a daemon that only speaks as one does: each has a server of its own, some with users.

The first argument of the test is the program stanok-web.
"""
import contextlib
import gzip
import os
import subprocess
import sys
import tempfile
import time
import unittest

from web_browser import PATIENCE_S, Browser, Closed, FakeDaemon, new_link, running_web

STANOK_WEB = sys.argv.pop(1)


class WithServer(unittest.TestCase):
    options = ()

    def start_options(self):
        return self.options

    def setUp(self):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.folder = stack.enter_context(tempfile.TemporaryDirectory())
        page = os.path.join(self.folder, "page")
        os.makedirs(os.path.join(page, "assets"))
        self.write("page/index.html", "<p>the page")
        self.write("page/assets/index-1a2b3c4d.js", "let x;")
        self.write("secret.txt", "not for others")
        manual = os.path.join(self.folder, "docs")
        os.makedirs(os.path.join(manual, "operator"))
        self.write("docs/README.md", "# Documents")
        self.write("docs/operator/panel.md", "# The page")
        os.symlink(os.path.join(self.folder, "secret.txt"), os.path.join(manual, "linked.md"))
        os.symlink(os.path.join(self.folder, "secret.txt"), os.path.join(page, "linked.txt"))
        with gzip.open(os.path.join(page, "assets/index-1a2b3c4d.js.gz"), "wb") as compressed:
            compressed.write(b"let x;")
        path = os.path.join(self.folder, "op.sock")
        self.daemon = stack.enter_context(FakeDaemon(path))
        self.web = stack.enter_context(running_web(STANOK_WEB, self.folder, path, "--manual", manual, *self.start_options(),
                                                   error=subprocess.DEVNULL))
        self.browser = Browser(self.web)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def another_link(self):
        return new_link(os.path.join(self.folder, "links.panel"))


class WithUsers(WithServer):
    PASSWORD = "correct horse battery"

    def setUp(self):
        # The options of the server name files that its folder does not have yet.
        with contextlib.ExitStack() as stack:
            self.access = stack.enter_context(tempfile.TemporaryDirectory())
            self.addCleanup(stack.pop_all().close)
        self.users = os.path.join(self.access, "users")
        self.user("add", "anna", "--role", "operator")
        self.options = ("--users", self.users)
        super().setUp()

    def user(self, *arguments, code=0):
        done = subprocess.run([STANOK_WEB, "user", *arguments, "--users", self.users], input=self.PASSWORD + "\n",
                              capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def until_refused(self, window):
        with self.assertRaises((Closed, OSError)):
            while True:
                window.receive()
        window.close()

    def wait_for_user(self, name):
        """The server looks at its file about once a second."""
        end = time.monotonic() + PATIENCE_S
        while self.browser.enter(name, self.PASSWORD).status != 200:
            self.assertLess(time.monotonic(), end, "the user never came to be known")
