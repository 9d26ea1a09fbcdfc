#!/usr/bin/env python3
"""What a log tells of the cutting process, and .npz files: the same bits in CSV, in NumPy's files and in Python."""
import resource
import shutil
import struct
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path

import numpy as np
import stanok
from stanok import PROCESS_COLUMNS, ProcessRows
from surroundings import BIN, EXAMPLES, MACHINES, ROOT, InFolder, columns_of_csv, same_bits
from surroundings import stanok as command

LATHE, MILL = MACHINES / "lathe.toml", MACHINES / "mill3.toml"
AXES = ("axes", "words", "units")


def messages(log, topic, layout):
    """The messages of channel 1 of a topic by cycle, read without stanok: LCM's header, then fields, big endian."""
    content, at, found = log.read_bytes(), 0, {}
    while at < len(content):
        sync, _, _, name_bytes, data_bytes = struct.unpack_from(">IqqII", content, at)
        assert sync == 0xEDA1DA01
        name = content[at + 28:at + 28 + name_bytes]
        if name.endswith(f"_CH1_{topic}".encode()):
            _, cycle, _, *fields = struct.unpack_from(">8xqqqi" + layout, content, at + 28 + name_bytes)
            found[cycle] = fields[1:]
        at += 28 + name_bytes + data_bytes
    return found


def numbers_of(texts):
    """A column of CSV: nothing is not a number."""
    return np.array([float(text) if text else np.nan for text in texts])


def extreme(array):
    """The value farthest from 0."""
    known = array[~np.isnan(array.astype(float))]
    return known[np.abs(known).argmax()]


class Process(InFolder):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.cut = Path(folder.name) / "cut.lcm"
        stanok.simulate(LATHE, EXAMPLES / "adaptive_steps.nc", drives="simulated", log=cls.cut)

    def setUp(self):
        super().setUp()
        self.log = self.folder / "cut.lcm"
        shutil.copy(self.cut, self.log)

    def exported(self, *options, log=None):
        """CSV by heading, and what numpy.load gives."""
        table, arrays = self.folder / "table.csv", self.folder / "table.npz"
        command("log", "export", log or self.log, "--csv", table, "--npz", arrays, *options)
        with np.load(arrays, allow_pickle=False) as loaded:
            return columns_of_csv(table), dict(loaded)

    def test_every_face_has_the_same_bits(self):
        rows = stanok.open_log(self.log).process()
        table, arrays = self.exported("--process")
        self.assertEqual(tuple(rows), PROCESS_COLUMNS)
        self.assertEqual(tuple(table), PROCESS_COLUMNS)
        self.assertEqual(tuple(arrays), PROCESS_COLUMNS)
        self.assertGreater(rows.rows, 100)
        for name in PROCESS_COLUMNS:
            self.assertTrue(same_bits(rows[name], arrays[name]), name)
            self.assertEqual(rows[name].shape, (rows.rows,))
            text = np.array([int(cell) for cell in table[name]]) if name == "cycle" else numbers_of(table[name])
            known = ~np.isnan(rows[name].astype(float))
            self.assertTrue(same_bits(rows[name][known], text[known]), name)
            self.assertTrue(np.isnan(text[~known].astype(float)).all(), name)

    def test_the_extreme_of_each_column_is_one_in_all_faces(self):
        rows = stanok.open_log(self.log).process()
        table, arrays = self.exported("--process")
        for name in PROCESS_COLUMNS:
            found = {float(extreme(rows[name])), float(extreme(arrays[name])), float(extreme(numbers_of(table[name])))}
            self.assertEqual(len(found), 1, name)
        self.assertGreater(extreme(rows.power_w), 1000.0)
        self.assertGreater(extreme(rows.force_n), 1000.0)
        self.assertEqual(extreme(rows.force_set_n), 1200.0)

    def test_numbers_are_those_of_the_messages(self):
        rows = stanok.open_log(self.log).process()
        process = messages(self.log, "PROCESS", "bbqdddd")
        force = messages(self.log, "FORCE", "b13d")
        self.assertEqual(sorted(set(process) | set(force)), list(rows.cycle))
        self.assertLess(len(force), len(process))
        names = ("law", "stands", "increments", "feed_mm_min", "feed_mm_rev", "spindle_rev_min", "cutting_speed_m_min")
        for k, name in enumerate(names):
            self.assertTrue(np.array_equal(rows[name], [process[cycle][k] for cycle in rows.cycle]), name)
        names = ("force_state", "force_set_mean_n", "force_set_n", "force_n", "power_w", "power_idle_w", "radius_mm",
                 "feed_requested_mm_min", "feed_min_mm_min", "feed_max_mm_min", "vibration_um", "vibration_hz",
                 "oscillation_n", "oscillation_hz")
        for k, name in enumerate(names):
            factor = 60.0 if name.endswith("_mm_min") else 1.0  # the message has mm/s
            told = [factor * force[cycle][k] if cycle in force else np.nan for cycle in rows.cycle]
            self.assertTrue(np.array_equal(rows[name], told, equal_nan=True), name)

    def test_rows_find_their_setpoints(self):
        log = stanok.open_log(self.log)
        rows, setpoints = log.process(channel=1), log.setpoints()
        at = np.searchsorted(setpoints.cycle, rows.cycle)
        self.assertTrue(same_bits(setpoints.cycle[at], rows.cycle))
        self.assertTrue(same_bits(setpoints.time_s[at], rows.time_s))

    def test_columns_are_documented_from_their_table(self):
        for name in PROCESS_COLUMNS:
            text = getattr(ProcessRows, name).__doc__
            self.assertIn(ProcessRows.meaning(name), text)
            self.assertIn(ProcessRows.unit(name), text)
            self.assertTrue(text.startswith("``(n,)``"))
        self.assertEqual(ProcessRows.power_w.__doc__,
                         "``(n,)`` W, power N_d of the spindle; not a number: the sensor reports none.")
        rows = stanok.open_log(self.log).process()
        self.assertIs(rows.power_w, rows["power_w"])
        with self.assertRaisesRegex(KeyError, "the columns are time_s, cycle"):
            rows["no"]

    def test_the_manual_lists_the_columns_of_the_table(self):
        told = [line for line in (ROOT / "docs" / "operator" / "replay.md").read_text().splitlines()
                if line.startswith("| `") and line.count("|") == 4]
        listed = [f"| `{name}` | {ProcessRows.unit(name)} | {ProcessRows.meaning(name)} |" for name in PROCESS_COLUMNS]
        self.assertEqual([line for line in told if line.split("`")[1] in PROCESS_COLUMNS], listed)

    def test_setpoints_for_numpy_have_the_bits_of_the_log(self):
        setpoints = stanok.read_log(self.log)
        _, arrays = self.exported()
        self.assertEqual(tuple(arrays), (*stanok.ALL_COLUMNS, *AXES))
        for name in stanok.ALL_COLUMNS:
            self.assertTrue(same_bits(setpoints[name], arrays[name]), name)
        for name in AXES:
            self.assertEqual(tuple(arrays[name]), getattr(setpoints, name))

    def test_the_file_is_a_sound_zip_that_does_not_depend_on_the_time(self):
        self.exported()
        first = (self.folder / "table.npz").read_bytes()
        with zipfile.ZipFile(self.folder / "table.npz") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual({one.compress_type for one in archive.infolist()}, {zipfile.ZIP_STORED})
        self.exported()
        self.assertEqual((self.folder / "table.npz").read_bytes(), first)

    def test_a_damaged_log_is_exported_as_far_as_it_can_be(self):
        content = bytearray(self.log.read_bytes())
        content[1_000_000:1_000_100] = bytes(100)
        del content[-1000:]
        self.log.write_bytes(content)
        opened = stanok.open_log(self.log)
        _, arrays = self.exported()
        setpoints = opened.setpoints()
        for name in stanok.ALL_COLUMNS:
            self.assertTrue(same_bits(setpoints[name], arrays[name]), name)
        _, arrays = self.exported("--process")
        rows = opened.process()
        for name in PROCESS_COLUMNS:
            self.assertTrue(same_bits(rows[name], arrays[name]), name)

    def test_several_channels(self):
        log = self.folder / "run.lcm"
        command("simulate", "--machine", MACHINES / "millturn4.toml", "--run", f"1={EXAMPLES / 'millturn4.nc'}",
                "--log", log, "--until", 3, code=4)
        opened = stanok.open_log(log)
        with self.assertRaisesRegex(ValueError, "choose one"):
            opened.process()
        command("log", "export", log, "--process", "--csv", "-", code=1)
        for channel in opened.channels[:2]:
            rows = opened.process(channel)
            self.assertEqual(rows.channel, channel)
            _, arrays = self.exported("--process", "--channel", channel, log=log)
            self.assertTrue(same_bits(rows.spindle_rev_min, arrays["spindle_rev_min"]))
            self.assertTrue(np.isnan(rows.power_w).all())

    def refused(self, *arguments, code=1):
        ended = subprocess.run([BIN / "stanok", "log", "export", *map(str, arguments)], capture_output=True, text=True,
                               check=False)
        self.assertEqual(ended.returncode, code, ended.stderr)
        return ended.stderr

    def test_what_cannot_be_exported_is_told(self):
        self.assertIn("--csv or --npz", self.refused(self.log, code=2))
        self.assertIn("not the standard output", self.refused(self.log, "--npz", "-"))
        for option in ("--csv", "--npz"):
            self.assertIn("is the log itself", self.refused(self.log, option, self.log))
            self.assertIn("No such file or directory", self.refused(self.log, option, self.folder / "no" / "table"))
            for process in ([], ["--process"]):
                self.assertIn("No space left on device", self.refused(self.log, *process, option, "/dev/full"))
        self.assertIn("channels with setpoints: 1", self.refused(self.log, "--channel", 7, "--csv", "-"))
        self.assertTrue(stanok.open_log(self.log).is_sound)
        for channel in (7, 0, -1):
            with self.assertRaises(ValueError):
                stanok.open_log(self.log).process(channel)

    def test_a_log_without_the_process_is_told(self):
        """As a log of setpoints alone: the events of other topics are left out."""
        content, at, kept = self.log.read_bytes(), 0, []
        while at < len(content):
            name_bytes, data_bytes = struct.unpack_from(">II", content, at + 20)
            end = at + 28 + name_bytes + data_bytes
            if content[at + 28:at + 28 + name_bytes].endswith((b"SETPOINT", b"META")):
                kept.append(content[at:end])
            at = end
        self.log.write_bytes(b"".join(kept))
        self.assertIn("no process data of channel 1", self.refused(self.log, "--process", "--csv", "-"))
        with self.assertRaisesRegex(ValueError, "no process data of channel 1"):
            stanok.open_log(self.log).process()

    def test_a_long_log_is_exported_in_bounded_memory(self):
        log, arrays, copies = self.folder / "long.lcm", self.folder / "long.npz", 0
        with open(log, "wb") as stream:
            while stream.tell() < 150 << 20:
                stream.write(self.log.read_bytes())
                copies += 1
        limit = 40 << 20
        subprocess.run([BIN / "stanok", "log", "export", log, "--npz", arrays], check=True, capture_output=True,
                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (limit, limit)))
        self.assertGreater(arrays.stat().st_size, limit)
        with np.load(arrays) as loaded:
            self.assertEqual(loaded["cycle"].shape[0], copies * stanok.read_log(self.log, columns=["cycle"]).rows)


if __name__ == "__main__":
    unittest.main()
