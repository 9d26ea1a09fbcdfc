#!/usr/bin/env python3
"""stanok-web before a real daemon with simulated drives: what a browser does to the machine, and what it cannot.

usage: machine_test.py STANOK_WEB STANOKD STANOK MACHINE_FILE [unittest arguments]
"""
import contextlib
import functools
import json
import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support"))
from running_daemon import Operator, connect, running_daemon  # noqa: E402
from web_browser import PATIENCE_S, Browser, Closed, running_web  # noqa: E402

STANOK_WEB, STANOKD, STANOK, MACHINE = (sys.argv.pop(1) for _ in range(4))
FOLLOWED_S = 5
LONG_PROGRAM = "for (num turn = 0; turn < 100000; turn++) {\nG1 X5 F600\nX0\n}\nM30\n"


class Starved(Exception):
    """The computer had too much else to do, and the daemon says so: drives without contact, outputs that are lost."""


def again_where_starved(test):
    """Up to five times, each with a daemon of its own."""
    @functools.wraps(test)
    def repeated(self):
        for _ in range(4):
            try:
                return test(self)
            except Starved as why:
                print(f"once more: {why}")
                self.doCleanups()
                self.setUp()
        return test(self)
    return repeated


class AtTheMachine(unittest.TestCase):
    def setUp(self):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        self.folder = stack.enter_context(tempfile.TemporaryDirectory())
        logs = ("--log", os.path.join(self.folder, "log"))
        self.machine = stack.enter_context(running_daemon(STANOKD, MACHINE, LONG_PROGRAM, options=logs))
        self.operator = Operator(self.machine.socket_path)
        stack.callback(self.operator.socket.close)
        stack.callback(self.operator.lines.close)
        self.web = stack.enter_context(running_web(STANOK_WEB, self.folder, self.machine.socket_path,
                                                   error=subprocess.DEVNULL))
        self.browser = Browser(self.web)

    def until(self, condition, what):
        """The status of the channel, when it is so."""
        end = time.monotonic() + PATIENCE_S
        while not condition(status := self.operator.ask("channel.status")):
            self.assertLess(time.monotonic(), end, f"never {what}: {status}")
            time.sleep(0.02)
        return status

    def open_window(self):
        self.browser.enter_by_link()
        window = self.browser.open_window()
        self.assertEqual(window.receive()["method"], "hello")
        return window

    def insist(self, window, method, /, code, **parameters):
        """Asks again as long as the refusal is the one that is to be expected meanwhile."""
        end = time.monotonic() + PATIENCE_S
        while "result" not in (answer := window.answer(method, **parameters)):
            self.assertEqual(answer["error"]["data"]["code"], code)
            self.assertLess(time.monotonic(), end, answer)
            time.sleep(0.05)

    def switch_on(self, window):
        """A computer that is loaded may starve the drives inside the daemon; one switches on again."""
        self.insist(window, "machine.on", code="A3001")

    def expect_enough_time(self):
        lost = self.operator.ask("machine.status")["outputs_lost"]
        status = self.operator.ask("channel.status")
        if lost > 0 or '"code": "A300' in json.dumps(status):
            raise Starved(f"{lost} outputs lost, {status}")

    def verify(self, window, log):
        """Of a log that is not verified to its end since the recorder fell behind is told that, and no more."""
        verified = window.ask("history.verify", file=log)
        if any(remark.startswith("W720") for remark in verified["remarks"]):
            raise Starved(verified["remarks"])
        self.assertEqual((verified["verdict"], verified["difference"]), ("same", None), verified)
        return verified

    def test_a_job_outlives_the_page_and_its_server(self):
        window = self.open_window()
        self.switch_on(window)
        window.ask("program.run", program="part.nc")
        self.until(lambda status: status["line"] > 0, "a line was executed")
        self.web.process.send_signal(signal.SIGKILL)
        with self.assertRaises((Closed, OSError)):
            while True:
                window.receive()
        window.close()
        block = self.operator.ask("channel.status")["block"]
        status = self.until(lambda status: status["block"] > block + 3, "the job went on")
        self.assertEqual(status["state"], "Active")
        self.web.process.wait()
        self.web.process.returncode = 0  # as it was meant

    def test_a_jog_ends_with_the_browser(self):
        window = self.open_window()
        self.switch_on(window)
        # The drives hold the axes a moment after they were switched on.
        self.insist(window, "jog", code="E6008", axis="X", velocity=5)
        self.until(lambda status: status["speed_mm_s"] != 0 or status["position"]["X"] != 0, "the axis moved")
        window.socket.close()
        window.stream.close()
        last = [None]

        def rests(status):
            stood, last[0] = last[0] == status["position"]["X"], status["position"]["X"]
            return stood
        self.until(rests, "at rest")

    def test_status_comes_by_itself(self):
        window = self.open_window()
        window.ask("subscribe", topics=["channels", "machine"], rate_hz=20)
        while (message := window.receive()).get("method") != "status":
            pass
        self.assertIn("1", message["params"]["state"]["channels"])
        window.close()

    def test_the_planned_path_follows_in_binary_frames(self):
        window = self.open_window()
        round_program = "G21 G90 G17\nG0 X20 Y0 Z5\nG1 Z0 F6000\n" + "G2 I-20\nG3 I-20\n" * 40 + "M30\n"
        window.ask("program.write", program="round.nc", text=round_program)
        window.ask("program.load", program="round.nc")
        end = time.monotonic() + PATIENCE_S
        while not (path := window.ask("program.path"))["complete"]:
            self.assertLess(time.monotonic(), end, path)
            time.sleep(0.05)
        self.assertNotIn("base64", path["geometry"])
        pages = {}
        while len(pages) < path["pages"]:
            for frame in window.binary:
                kind, number, page, count = struct.unpack_from("<4I", frame)
                if number == path["id"]:
                    pages[page] = (kind, count, frame)
            window.binary.clear()
            if len(pages) < path["pages"]:
                opcode, payload = window.receive_frame()
                if opcode == 2:
                    window.binary.append(payload)
                else:
                    self.assertEqual(json.loads(payload)["method"], "geometry")
        self.assertGreater(path["pages"], 1)
        points, lines = [], []
        for page in sorted(pages):
            kind, count, frame = pages[page]
            self.assertEqual((kind, len(frame)), (1, 16 + 16 * count))
            numbers = struct.unpack_from(f"<{3 * count}f", frame, 16)
            points += zip(*[iter(numbers)] * 3)
            lines += struct.unpack_from(f"<{count}I", frame, 16 + 12 * count)
        self.assertEqual(len(points), path["points"])
        self.assertEqual(lines, sorted(lines))
        for (x, y, _), line in zip(points, lines):
            if line > 3:
                self.assertAlmostEqual(math.hypot(x, y), 20.0, delta=1e-4)
        window.close()

    @again_where_starved
    def test_a_workpiece_is_seen_while_it_is_cut(self):
        window = self.open_window()
        self.switch_on(window)
        # A block of 40 x 30 x 10 mm, and a slot along X of the width of the tool, 2 mm deep.
        radius = 4
        window.ask("tool.load", tables=f'[[tool]]\nnumber = 1\nkind = "flat"\nradius = {radius}.0\nlength = 0.0\n'
                                       "overhang = 40.0\n")
        program = ("G21 G90 G17\n#workpiece (0, 0.5, 0, 40, 30, 10, 0, 0, 10)\nT1 M6\nM3 S3000\n"
                   "G0 X-20 Y15 Z5\nG1 Z-2 F6000\nG1 X60\nG0 Z5\nM30\n")
        window.ask("program.write", program="slot.nc", text=program)
        self.insist(window, "program.run", code="E6008", program="slot.nc")
        wanted = 40 * 30 * 10 - 40 * 2 * radius * 2
        bricks, known = {}, {"workpiece": 0, "since": 0}
        end = time.monotonic() + PATIENCE_S
        while abs(self.volume_of(bricks) - wanted) > 0.01 * wanted:
            self.expect_enough_time()
            self.assertLess(time.monotonic(), end, self.volume_of(bricks))
            self.look_at_surface(window, bricks, known)
        self.assertEqual({tool for corners in bricks.values() for _, tool in corners}, {0, 1})
        window.close()

    @again_where_starved
    def test_a_log_is_verified_and_its_path_comes_with_times(self):
        window = self.open_window()
        self.switch_on(window)
        # G55 lies 100 mm beside G54.
        window.ask("offset.set", offset="G54", axis="X", value=0.0)
        window.ask("offset.set", offset="G55", axis="X", value=100.0)
        text = "G21 G90 G54\nG1 X20 F3000\nG1 Y10\nG55\nG1 X-70\nG54\nM30\n"
        window.ask("program.write", program="way.nc", text=text)
        self.insist(window, "program.run", code="E6008", program="way.nc")
        self.until(lambda status: status["position"]["Y"] == 10 and status["state"] == "Reset", "it was there")
        log = os.path.basename(window.ask("log.stop")["path"])
        listed = [one["file"] for one in window.ask("history.logs")["logs"]]
        self.assertIn(log, listed)
        self.verify(window, log)
        for system, end_of_row in (("work", (-70, 10)), ("part", (30, 10))):
            path = window.ask("history.path", file=log, system=system)
            self.assertEqual(path["system"], system)
            frame = window.receive_frame()[1] if not window.binary else window.binary.pop()
            kind, _, _, count = struct.unpack_from("<4I", frame)
            self.assertEqual((kind, count), (3, path["points"]))
            points = list(zip(*[iter(struct.unpack_from(f"<{3 * count}f", frame, 16))] * 3))
            times = struct.unpack_from(f"<{count}I", frame, 16 + 12 * count)
            self.assertEqual(list(times), sorted(times))
            for corner in ((20, 0), (20, 10), end_of_row):
                self.assertLess(min(math.dist(corner, point[:2]) for point in points), 0.1)
            # 40 mm at 50 mm/s take 0.8 s and a little more.
            self.assertGreater(times[-1] - times[0], 800)
            self.assertEqual({line for _, line in path["geometry"]["lines"]} - {0, 4, 6}, {2, 3, 5})
        window.close()

    def test_a_log_under_a_scheme_that_the_machine_no_longer_has(self):
        window = self.open_window()
        self.operator.ask("log.stop")
        # The same machine, when its scheme had another number; 25 mm at 50 mm/s and no more than a second for its ramps.
        before = os.path.join(self.folder, "before.toml")
        with open(MACHINE, encoding="utf-8") as now, open(before, "w", encoding="utf-8") as file:
            head, scheme, rest = now.read().partition("[[channel.scheme]]\n")
            file.write(head + scheme + rest.replace("id = 1\n", "id = 7\n", 1))
        program = os.path.join(self.folder, "way.nc")
        with open(program, "w", encoding="utf-8") as file:
            file.write("G21 G90 G54\nG1 X25 F3000\nM30\n")
        log = os.path.join(self.folder, "log", "before.lcm")
        subprocess.run([STANOK, "simulate", "--machine", before, "--log", log, program], check=True,
                       stdout=subprocess.DEVNULL)
        in_work = window.ask("history.path", file="before.lcm", system="work")
        self.assertEqual(in_work["left_out_s"], 0)
        self.assertGreater(in_work["points"], 10)
        on_part = window.ask("history.path", file="before.lcm", system="part")
        self.assertEqual(on_part["points"], 0)
        self.assertEqual((on_part["first_cycle"], on_part["time_s"]), (in_work["first_cycle"], in_work["time_s"]))
        self.assertGreater(on_part["left_out_s"], 0.5)
        self.assertLess(abs(on_part["left_out_s"] - on_part["time_s"]), 0.02)
        window.close()

    def look_at_surface(self, window, bricks, known):
        """All that has changed behind the version that is known, page by page."""
        start, version = 0, None
        while start is not None:
            page = window.ask("workpiece.surface", **known, **{"from": start})
            if page["workpiece"] is None:
                time.sleep(0.05)
                return
            if page["workpiece"] != known["workpiece"]:
                bricks.clear()
                known.update(workpiece=page["workpiece"], since=0)
            version = version or page["version"]
            if not window.binary:
                opcode, payload = window.receive_frame()
                self.assertEqual(opcode, 2)
                window.binary.append(payload)
            kind, _, _, count = struct.unpack_from("<4I", frame := window.binary.pop())
            self.assertEqual((kind, count), (2, page["geometry"]["count"]))
            numbers = struct.unpack_from(f"<{3 * count}f", frame, 16)
            tools = struct.unpack_from(f"<{count}I", frame, 16 + 12 * count)
            corners = list(zip(zip(*[iter(numbers)] * 3), tools))
            for brick, first, behind in page["geometry"]["bricks"]:
                bricks[brick] = corners[first:behind]
            start = page["next"]
        known["since"] = version

    @staticmethod
    def volume_of(bricks):
        """By the divergence theorem."""
        volume = 0
        for corners in bricks.values():
            for a, b, c in zip(*[iter(place for place, _ in corners)] * 3):
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        return volume

    def test_programs_are_edited_by_who_knows_their_version(self):
        window = self.open_window()
        text = window.ask("program.read", program="part.nc")
        self.assertEqual(text["text"], LONG_PROGRAM)
        window.ask("program.write", program="part.nc", text="M30\n", version=text["version"])
        refused = window.answer("program.write", program="part.nc", text="M2\n", version=text["version"])
        self.assertEqual(refused["error"]["data"]["code"], "E9019")
        found = window.ask("program.check", program="part.nc", text="G1 X1 F100\nthis is none\nM30\n")
        self.assertFalse(found["ok"])
        self.assertEqual(found["diagnostics"][0]["line"], 2)
        window.close()

    def test_an_estimate_runs_the_program_on_a_virtual_clock(self):
        window = self.open_window()
        window.ask("program.write", program="wait.nc", text="G4 P20\nG4 P40\nM30\n")
        found = window.ask("program.estimate", program="wait.nc")
        self.assertTrue(found["ok"] and found["complete"])
        self.assertAlmostEqual(found["time_s"], 60, delta=0.1)
        window.ask("program.write", program="far.nc", text="G0 X1\nG0 X100000\nM30\n")
        self.assertEqual(window.ask("program.estimate", program="far.nc")["alarm"]["code"], "E5101")
        refused = window.answer("program.estimate", program="none.nc")
        self.assertIn("error", refused)
        window.close()

    def test_an_endless_check_delays_no_stop_and_can_be_ended(self):
        window = self.open_window()
        endless = "for (num turn = 0; turn < 1000000000; turn++) {\nG1 X5 F600\nX0\n}\nM30\n"
        window.send({"jsonrpc": "2.0", "id": 1000, "method": "program.check",
                     "params": {"program": "endless.nc", "text": endless}})
        self.switch_on(window)
        window.ask("program.stop")
        window.ask("program.read", program="part.nc")
        window.ask("program.check_cancel")
        while (message := next((one for one in window.notifications if one.get("id") == 1000), None)) is None:
            window.notifications.append(window.receive())
        self.assertEqual(message["error"]["data"]["code"], "E9017")
        window.close()

    def test_a_page_without_a_place_stops_the_machine(self):
        first = self.open_window()
        self.switch_on(first)
        first.ask("program.write", program="endless.nc", text="G21 G90 F600\nwhile (true) {\nG1 X20\nX0\n}\n")
        first.ask("program.run", program="endless.nc")
        self.until(lambda status: status["speed_mm_s"] > 1.0, "it ran")
        idle = [connect(self.machine.socket_path) for _ in range(70)]
        self.addCleanup(lambda: [one.close() for one in idle])
        end = time.monotonic() + 60
        while self.browser.request("GET", "/health").json() != {"status": "full", "daemon": True}:  # a second old
            self.assertLess(time.monotonic(), end, "/health does not report that all places are taken")
            time.sleep(0.1)
        window = self.browser.open_window()
        hello = window.receive()
        self.assertEqual(hello["method"], "hello")
        self.assertEqual([one["id"] for one in hello["params"]["channels"]], [1])
        self.assertEqual(window.receive()["params"]["code"], "E9008")
        self.assertEqual(window.answer("machine.status")["error"]["data"]["code"], "E9008")
        window.ask("program.hold", channel=1)
        self.until(lambda status: status["speed_mm_s"] == 0.0, "it was held")
        window.ask("machine.estop")
        self.until(lambda status: status["state"] == "Error" or status["alarm"] is not None, "an emergency stop")
        window.close()
        first.close()

    def test_a_stop_waits_for_no_other_request_of_its_page(self):
        window = self.open_window()
        self.switch_on(window)
        window.ask("program.write", program="endless.nc", text="G21 G90 F600\nwhile (true) {\nG1 X20\nX0\n}\n")
        window.ask("program.run", program="endless.nc")
        self.until(lambda status: status["speed_mm_s"] > 1.0, "it ran")
        for number in range(2000, 2500):
            window.send({"jsonrpc": "2.0", "id": number, "method": "channel.status", "params": {}})
        window.send({"jsonrpc": "2.0", "id": 3000, "method": "program.hold", "params": {"channel": 1}})
        answered = []
        while not answered or answered[-1] != 3000:
            message = window.receive()
            if "id" in message:
                answered.append(message["id"])
        self.assertLess(len(answered), 500, "it was not the last one")
        self.until(lambda status: status["speed_mm_s"] == 0.0, "it was held")
        window.close()

    def test_fifty_pages_at_once(self):
        self.browser.enter_by_link()
        windows = [self.browser.open_window() for _ in range(50)]
        for window in windows:
            self.assertEqual(window.receive()["method"], "hello")
        for window in windows:
            self.assertIn("state", window.ask("channel.status"))
            window.close()
        self.until(lambda _: self.operator.ask("system.info")["clients"] == 1, "they had gone")

    @again_where_starved
    def test_a_run_that_fifty_pages_follow_repeats_from_its_log(self):
        owner = self.open_window()
        self.switch_on(owner)
        self.insist(owner, "program.run", code="E6008", program="part.nc")
        self.until(lambda status: status["line"] > 0, "a line was executed")
        time.sleep(FOLLOWED_S)
        alone = owner.ask("machine.status")
        windows = [self.browser.open_window() for _ in range(49)]
        for window in windows:
            window.ask("subscribe", topics=["machine", "channels", "drives", "events"], rate_hz=20)
        counts = [[] for _ in windows]
        readers = [threading.Thread(target=self.count_status, args=pair) for pair in zip(windows, counts)]
        for thread in readers:
            thread.start()
        for thread in readers:
            thread.join()
        followed = owner.ask("machine.status")
        self.assertEqual(followed["outputs_lost"], alone["outputs_lost"])
        # However many a loaded computer leaves out: no page is forgotten.
        self.assertGreater(min(len(count) for count in counts), 0)
        log = os.path.basename(owner.ask("log.stop")["path"])
        verified = self.verify(owner, log)
        figures = [(one["rt"]["cycle_us"]["p999"], one["rt"]["latency_us"]["p999"]) for one in (alone, followed)]
        print(f"cycle and lateness p99.9 in us: {figures[0]} alone, {figures[1]} with 50 pages; "
              f"{sum(len(count) for count in counts)} messages; {verified}")
        for window in windows:
            window.close()
        owner.close()

    @staticmethod
    def count_status(window, times):
        """The times of the status messages of some seconds."""
        end = time.monotonic() + FOLLOWED_S
        while (now := time.monotonic()) < end:
            if window.receive().get("method") == "status":
                times.append(now)

    def test_stanok_panel_prints_a_link_that_opens(self):
        desk = os.path.join(self.folder, "links.panel")
        surroundings = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        printed = subprocess.run([STANOK, "panel", "--link-socket", desk, "--json"], env=surroundings, check=True,
                                 capture_output=True, timeout=PATIENCE_S)
        link = json.loads(printed.stdout)
        self.assertFalse(link["opened"])
        self.web.token = link["link"].split("#")[1]
        self.browser.enter_by_link()
        session = self.browser.request("GET", "/api/session").json()
        self.assertEqual(session["role"], "integrator")

    def test_stanok_panel_hands_a_link_to_the_browser_past_other_users(self):
        """What a program is started with can be read by everybody in /proc; the page that it is given by its user."""
        programs = os.path.join(self.folder, "programs")
        os.mkdir(programs)
        seen = os.path.join(self.folder, "seen.json")
        browser = os.path.join(programs, "xdg-open")
        with open(browser, "w", encoding="utf-8") as file:
            file.write("#!/usr/bin/env python3\nimport json, os, sys\n"
                       "place = sys.argv[1]\nmode = lambda name: os.stat(name).st_mode & 0o777\n"
                       "seen = {'argv': sys.argv, 'file': mode(place), 'folder': mode(os.path.dirname(place)),\n"
                       "        'text': open(place).read()}\n"
                       f"json.dump(seen, open({seen + '.new'!r}, 'w'))\nos.rename({seen + '.new'!r}, {seen!r})\n")
        os.chmod(browser, 0o755)
        surroundings = {**os.environ, "DISPLAY": ":0", "PATH": f"{programs}:{os.environ['PATH']}"}
        desk = os.path.join(self.folder, "links.panel")
        printed = subprocess.run([STANOK, "panel", "--link-socket", desk, "--json"], env=surroundings, check=True,
                                 capture_output=True, timeout=PATIENCE_S)
        answer = json.loads(printed.stdout)
        self.assertTrue(answer["opened"])
        end = time.monotonic() + PATIENCE_S
        while not os.path.exists(seen):
            self.assertLess(time.monotonic(), end, "the browser was never started")
            time.sleep(0.02)
        with open(seen, encoding="utf-8") as file:
            found = json.load(file)
        token = answer["link"].split("#")[1]
        self.assertNotIn(token, json.dumps(found["argv"]))
        self.assertEqual((found["file"], found["folder"]), (0o600, 0o700))
        self.assertIn(f'content="0; url={answer["link"]}"', found["text"])
        while os.path.exists(os.path.dirname(found["argv"][1])):
            self.assertLess(time.monotonic(), end, "the page was never removed")
            time.sleep(0.2)

    def test_stanok_panel_says_that_there_is_no_server(self):
        done = subprocess.run([STANOK, "panel", "--socket", os.path.join(self.folder, "none.sock")], check=False,
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 3)
        self.assertIn("stanok-web --socket", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
