#!/usr/bin/env python3
"""Control characters of programs and names of files are shown on a terminal, and never sent to it.

usage: terminal_escapes_test.py STANOK MACHINE_FILE
"""
import os
import pty
import subprocess
import sys
import tempfile
import unittest

STANOK, MACHINE = sys.argv.pop(1), sys.argv.pop(1)
# Sets the title, clears the screen, colours, hides; as bytes of C0, as C1 in UTF-8, and a backspace that erases.
ORDERS = ("\x1b]0;owned\x07", "\x1b[2J", "\x1b[31m", "\x1b[8m", "\x9b2J", "\x9d0;owned\x9c", "ok\b\bno", "\rno", "\x7f")


def on_a_terminal(*words):
    """What the terminal is sent, its own line ends apart."""
    ours, its = pty.openpty()
    process = subprocess.Popen([STANOK, *words], stdin=subprocess.DEVNULL, stdout=its, stderr=its,
                               env={**os.environ, "NO_COLOR": "1", "TERM": "xterm"})
    os.close(its)
    sent = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # the other side is closed
            break
        if not piece:
            break
        sent += piece
    os.close(ours)
    process.wait()
    # The line of progress and its end are our own.
    return sent.decode().replace("\r\n", "\n").replace("\r\x1b[K", "")


def orders_in(text):
    return sorted({c for c in text if (ord(c) < 0x20 and c not in "\n\t") or 0x7F <= ord(c) < 0xA0})


class TerminalEscapes(unittest.TestCase):
    def expect_none(self, text, wanted):
        self.assertEqual(orders_in(text), [], text)
        self.assertIn(wanted, text)

    def test_of_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "part.nc")
            for order in ORDERS:
                for line in (f"G1 Q{order} X2", f"FOO{order}BAR X1", f'print ("{order}")', f"(MSG, {order})"):
                    with open(program, "w", encoding="utf-8", newline="") as file:
                        file.write(f"{line}\nG1 X1 F100\nM30\n")
                    for command in ("check", "simulate", "interpret"):
                        with self.subTest(command=command, line=line):
                            self.assertEqual(orders_in(on_a_terminal(command, "--machine", MACHINE, program)), [])

    def test_of_names_of_files(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "a\x1b]0;owned\x07b.nc")
            with open(program, "w", encoding="utf-8") as file:
                file.write("FOO X1\nM30\n")
            for command in ("check", "simulate", "interpret"):
                with self.subTest(command):
                    self.expect_none(on_a_terminal(command, "--machine", MACHINE, program), "a␛]0;owned␇b.nc")
                    self.expect_none(on_a_terminal(command, "--machine", MACHINE, program + "x"), "a␛]0;owned␇b.ncx")

    def test_a_file_gets_data_as_they_are(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "a\x1bb\x9b.nc")
            with open(program, "w", encoding="utf-8") as file:
                file.write("FOO X1\nM30\n")
            printed = subprocess.run([STANOK, "check", "--json", "--machine", MACHINE, program], capture_output=True,
                                     text=True, check=False)
            self.assertIn("a\\u001bb\x9b.nc", printed.stdout)


if __name__ == "__main__":
    unittest.main()
