"""Runs part programs on LinuxCNC (Debian's package linuxcnc-uspace) and samples its commanded positions.

The plainest machine: motmod with its planner as shipped, trivkins, a servo thread of one period,
positions fed back as they are commanded, no display, no real-time privileges. The numbers of a run are
counted in servo cycles; a loaded machine delays cycles and loses none.

All of it runs as one process tree in namespaces of its own: without a network, without the IPC keys
of another LinuxCNC, and with process ids that end together with the first process. As root it runs as
`nobody`, with the set-uid bit of rtapi_app without effect. Files stay in the folder given.

Motion is inhibited until the whole program stands in the queue of the planner, so that neither the
interpreter nor the load of the machine can make it wait for blocks.

With --drive this file is the "display" that LinuxCNC starts; nobody else calls it so.
"""

import array
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

NOBODY = 65534
MOST_BLOCKS = 1900  # the planner's queue takes 2000
SAMPLES = 65536  # of the queue between servo thread and this program: a minute
PATIENCE = 600  # s of wall time that a program may take


class Unavailable(Exception):
    """LinuxCNC cannot run here; the text says why."""


class Failed(Exception):
    """LinuxCNC did not run a program to its end; the text says what it printed."""


def ini_text(axes, cycle):
    """axes: name, kind (LINEAR or ANGULAR), velocity and acceleration."""
    letters = " ".join(name for name, *_ in axes)
    lines = ["[EMC]", "VERSION = 1.1", "MACHINE = peer", "DEBUG = 0",
             "[DISPLAY]", "DISPLAY = ./display",
             "[RS274NGC]", "PARAMETER_FILE = parameters.var",
             "[TASK]", "TASK = milltask", "CYCLE_TIME = 0.001",
             "[EMCMOT]", "EMCMOT = motmod", "COMM_TIMEOUT = 60", f"SERVO_PERIOD = {round(cycle * 1e9)}",
             "[HAL]", "HALFILE = machine.hal",
             "[KINS]", f"JOINTS = {len(axes)}", f"KINEMATICS = trivkins coordinates={letters.replace(' ', '')}",
             "[EMCIO]", "EMCIO = io", "CYCLE_TIME = 0.1", "TOOL_TABLE = tool.tbl",
             # No limits along the path but those of the axes.
             "[TRAJ]", f"COORDINATES = {letters}", "LINEAR_UNITS = mm", "ANGULAR_UNITS = degree",
             "NO_FORCE_HOMING = 1"]
    for kind in ("LINEAR", "ANGULAR"):
        lines += [f"DEFAULT_{kind}_VELOCITY = 50", f"MAX_{kind}_VELOCITY = 10000",
                  f"DEFAULT_{kind}_ACCELERATION = 100000", f"MAX_{kind}_ACCELERATION = 100000"]
    for number, (name, kind, velocity, acceleration) in enumerate(axes):
        limits = ["MIN_LIMIT = -9999", "MAX_LIMIT = 9999", f"MAX_VELOCITY = {velocity}",
                  f"MAX_ACCELERATION = {acceleration}"]
        lines += [f"[AXIS_{name}]", *limits,
                  f"[JOINT_{number}]", *limits, f"TYPE = {kind}", "FERROR = 100", "MIN_FERROR = 100", "HOME = 0",
                  "HOME_SEARCH_VEL = 0", "HOME_LATCH_VEL = 0", "HOME_SEQUENCE = 0"]
    return "\n".join([*lines, ""])


def hal_text(count):
    lines = ["loadrt [KINS]KINEMATICS",
             "loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS",
             f"loadrt sampler depth={SAMPLES} cfg={'f' * count}",
             "setp sampler.0.enable 0",
             "addf motion-command-handler servo-thread", "addf motion-controller servo-thread",
             "addf sampler.0 servo-thread",
             "net stop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in",
             "net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared",
             "net change iocontrol.0.tool-change => iocontrol.0.tool-changed"]
    lines += [f"net place-{n} joint.{n}.motor-pos-cmd => joint.{n}.motor-pos-fb sampler.0.pin.{n}"
              for n in range(count)]
    return "\n".join([*lines, ""])


def enclosure():
    """The command that runs another one in namespaces of its own, without privileges."""
    as_nobody = [f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"] if os.geteuid() == 0 else []
    return ["setpriv", "--no-new-privs", "--pdeathsig", "KILL", *as_nobody,
            "unshare", "--user", "--map-current-user", "--ipc", "--net", "--pid", "--fork", "--kill-child",
            "--mount-proc"]


def require():
    """Raises Unavailable where a run would not be possible."""
    for program, package in (("linuxcnc", "linuxcnc-uspace"), ("unshare", "util-linux"), ("setpriv", "util-linux")):
        if not shutil.which(program):
            raise Unavailable(f"{program} is not installed; it is in Debian's package {package}")
    probe = subprocess.run([*enclosure(), "true"], capture_output=True, text=True, check=False)
    if probe.returncode != 0:
        raise Unavailable(f"no namespaces are to be had here: {probe.stderr.strip()}")


def version():
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "linuxcnc-uspace"], capture_output=True, text=True,
                          check=False).stdout or "of unknown version"


def run(folder, programs, axes, cycle):
    """Rows of positions of each program (name -> text), a row per servo cycle."""
    (folder / "home").mkdir()
    for name, text in (("machine.ini", ini_text(axes, cycle)), ("machine.hal", hal_text(len(axes))),
                       ("tool.tbl", ""), ("programs.json", json.dumps([len(axes), list(programs)])),
                       ("display", '#!/bin/sh\nexec /usr/bin/python3 "$(dirname "$0")/driver.py" --drive\n')):
        (folder / name).write_text(text, encoding="ascii")
    for number, text in enumerate(programs.values()):
        (folder / f"{number}.ngc").write_text(text, encoding="ascii")
    (folder / "display").chmod(0o755)
    shutil.copy(__file__, folder / "driver.py")
    if os.geteuid() == 0:
        for place in (folder, *folder.iterdir()):
            os.chown(place, NOBODY, NOBODY)
    environment = {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "HOME": str(folder / "home"), "RUNTESTS": "1",
                   "LC_ALL": "C.UTF-8"}
    with open(folder / "output.txt", "w", encoding="ascii") as output:
        process = subprocess.Popen([*enclosure(), "linuxcnc", "machine.ini"], cwd=folder, env=environment,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True)
        try:
            process.wait(60 + PATIENCE * len(programs))
        except subprocess.TimeoutExpired:
            pass
        finally:
            # A no-op when all went well. Else it ends the first process of the namespace, and the kernel the others.
            process.kill()
            process.wait()
    if not (folder / "done").exists():
        text = (folder / "output.txt").read_text(encoding="utf-8", errors="replace")
        raise Failed(f"LinuxCNC did not end well; its output:\n{text}")
    found = {}
    for number, name in enumerate(programs):
        numbers = array.array("d", (folder / f"{number}.rows").read_bytes())
        found[name] = [tuple(numbers[k:k + len(axes)]) for k in range(0, len(numbers), len(axes))]
    return found


class Driver:
    """Inside: what an operator would do at the display."""

    def __init__(self, axis_count):
        import hal
        import linuxcnc
        self.hal, self.linuxcnc = hal, linuxcnc
        self.component = hal.component("driver")
        self.component.ready()
        self.samples = hal.stream(self.component, hal.sampler_base, "f" * axis_count)
        self.command, self.status, self.errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()

    def wait(self, what, reached):
        end = time.monotonic() + PATIENCE
        while not reached():
            if time.monotonic() > end:
                sys.exit(f"{what}: not reached within {PATIENCE} s")
            error = self.errors.poll()
            if error:
                sys.exit(f"{what}: {error}")
            time.sleep(0.002)
            self.status.poll()

    def done(self, what):
        if self.command.wait_complete(PATIENCE) != self.linuxcnc.RCS_DONE:
            sys.exit(f"{what}: refused, {self.errors.poll()}")
        self.status.poll()

    def mode(self, mode):
        self.command.mode(mode)
        self.done("mode")

    def switch_on(self, axis_count):
        for state in (self.linuxcnc.STATE_ESTOP_RESET, self.linuxcnc.STATE_ON):
            self.command.state(state)
            self.done("state")
        self.command.home(-1)
        self.wait("homing", lambda: all(self.status.homed[:axis_count]))

    def is_idle(self):
        return self.status.interp_state == self.linuxcnc.INTERP_IDLE and self.status.inpos and not self.status.queue

    def go_to_zero(self):
        self.mode(self.linuxcnc.MODE_MDI)
        self.command.mdi("G21 G90 G0 X0 Y0 Z0 B0 C0")
        self.done("way to zero")
        self.wait("way to zero", self.is_idle)

    def fill_queue(self):
        """Waits until the queue has not grown for a second, which is when all blocks are in it."""
        seen = [0, time.monotonic()]

        def is_full():
            if self.status.queue != seen[0]:
                seen[:] = self.status.queue, time.monotonic()
            return seen[0] and time.monotonic() - seen[1] > 1

        self.wait("queue", is_full)
        if self.status.queue > MOST_BLOCKS + 50:
            sys.exit(f"the program is too long for the planner's queue: {self.status.queue} blocks")

    def measure(self, program):
        """The rows from before the first motion until all stands."""
        self.mode(self.linuxcnc.MODE_AUTO)
        self.command.program_open(program)
        self.done(program)
        self.hal.set_p("motion.feed-inhibit", "1")
        self.command.auto(self.linuxcnc.AUTO_RUN, 0)
        self.fill_queue()
        self.hal.set_p("sampler.0.enable", "1")
        rows, lost = array.array("d"), self.samples.num_overruns

        def read():
            while self.samples.readable:
                rows.extend(self.samples.read())
            return len(rows)

        self.wait("samples", read)
        self.hal.set_p("motion.feed-inhibit", "0")
        self.wait(program, lambda: read() and self.is_idle())
        stood = len(rows)
        self.wait("samples", lambda: read() > stood + 100)
        self.hal.set_p("sampler.0.enable", "0")
        time.sleep(0.1)
        read()
        if self.samples.num_overruns != lost:
            sys.exit(f"{program}: the sampler lost rows")
        return rows


def drive():
    axis_count, names = json.loads(Path("programs.json").read_text(encoding="ascii"))
    driver = Driver(axis_count)
    driver.switch_on(axis_count)
    for number, name in enumerate(names):
        print(f"program {number}: {name}", flush=True)
        driver.go_to_zero()
        Path(f"{number}.rows").write_bytes(driver.measure(str(Path(f"{number}.ngc").resolve())))
    Path("done").touch()


if __name__ == "__main__" and "--drive" in sys.argv:
    drive()
