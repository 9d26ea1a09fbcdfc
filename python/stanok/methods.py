"""The methods of the operator protocol, a class for each noun.

Written by tools/generate_python_methods.py from the table of methods (protocol/contract/method_table.h); see
docs/reference/protocol.md for the members of the results.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

Call = Callable[[str, dict[str, Any]], dict[str, Any]]

STOPS = frozenset({
    "machine.off", "machine.estop", "program.hold", "program.stop", "program.reset",
})
MOVES = frozenset({
    "machine.on", "program.run", "program.start", "program.resume", "program.return", "program.retrace",
    "program.spindles", "program.coolant", "queue.start", "kinematics.select", "mdi", "jog",
    "handwheel", "home",
})


def _given(**params: Any) -> dict[str, Any]:
    """Parameters without those that are left out; a name that Python has taken ends in _ here."""
    return {name.removesuffix("_"): value for name, value in params.items() if value is not None}


class MachineMethods:
    """Methods ``machine.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def on(self, *, seen_cycle: int | None = None) -> dict[str, Any]:
        """Switch on the drives of all axes that are not parked.

        ``machine.on``, for the role operator.

        Args:
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("machine.on", _given(seen_cycle=seen_cycle))

    def off(self) -> dict[str, Any]:
        """Stop all channels and switch the drives off.

        ``machine.off``, for the role operator.
        """
        return self._call("machine.off", _given())

    def estop(self) -> dict[str, Any]:
        """STOP ALL (not the E-stop): stop immediately along the path, then switch the drives off; always accepted.

        ``machine.estop``, for the role operator.
        """
        return self._call("machine.estop", _given())

    def journal(self) -> dict[str, Any]:
        """List the commands of operators and the starts and ends of the daemon: the newest 2000 entries, including
        those from before the last start.

        ``machine.journal``, for the role observer.
        """
        return self._call("machine.journal", _given())

    def status(self) -> dict[str, Any]:
        """Show cycle, drives, real-time figures, and the state of every channel.

        ``machine.status``, for the role observer.
        """
        return self._call("machine.status", _given())


class ChannelMethods:
    """Methods ``channel.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self) -> dict[str, Any]:
        """List the channels with kind, axes, scheme and state.

        ``channel.list``, for the role observer.
        """
        return self._call("channel.list", _given())

    def status(self, *, channel: int | None = None) -> dict[str, Any]:
        """Show state, program, block, position, feed and overrides of a channel.

        ``channel.status``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("channel.status", _given(channel=channel))

    def position(self, *, why: int | None = None, channel: int | None = None) -> dict[str, Any]:
        """Show the words that would lead to the present position of a channel, and how they are derived.

        ``channel.position``, for the role observer.

        Args:
            why: 1: also show everything between the machine position and each word: zero of the scheme,
                offsets, lengths, rotations; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("channel.position", _given(why=why, channel=channel))

    def control(self, *, on: int | None = None, channel: int | None = None) -> dict[str, Any]:
        """Take sole control of a channel until the connection ends; others can still stop it.

        ``channel.control``, for the role operator.

        Args:
            on: 1 (default): take control; 0: release it; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("channel.control", _given(on=on, channel=channel))

    def watch(self, *, channel: int | None = None, rate_hz: float | None = None) -> dict[str, Any]:
        """Show the status of a channel as it changes.

        ``channel.watch``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
            rate_hz: maximum number of status messages per second; default 10; 0.1 to 50 Hz.
        """
        return self._call("channel.watch", _given(channel=channel, rate_hz=rate_hz))


class ProgramMethods:
    """Methods ``program.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def read(self, program: str, *, offset: int | None = None) -> dict[str, Any]:
        """Read the text of a program and its version, at most 512 KiB at a time.

        ``program.read``, for the role observer.

        Args:
            program: program file under the program root.
            offset: byte at which the answer begins; default 0; 0 to 1000000000.
        """
        return self._call("program.read", _given(program=program, offset=offset))

    def write(
        self,
        program: str,
        text: str,
        *,
        version: str | None = None,
        more: int | None = None,
        file: str | None = None,
    ) -> dict[str, Any]:
        """Write a program, completely or not at all, if nobody has changed it in the meantime.

        ``program.write``, for the role programmer.

        Args:
            program: program file under the program root.
            text: text of the program; send a longer text in parts, with `more`.
            version: version of the existing text, as program.read returned it; default: no text exists yet;
                any: whatever exists.
            more: 1: the text continues in the next request; default 0; 0 to 1.
            file: where the text comes from; information for people only.
        """
        return self._call("program.write", _given(program=program, text=text, version=version, more=more, file=file))

    def remove(self, program: str, *, version: str | None = None) -> dict[str, Any]:
        """Remove a program, if nobody has changed it in the meantime.

        ``program.remove``, for the role programmer.

        Args:
            program: program file under the program root.
            version: version of the existing text, as program.read returned it; default: no text exists yet;
                any: whatever exists.
        """
        return self._call("program.remove", _given(program=program, version=version))

    def check(
        self,
        program: str,
        *,
        text: str | None = None,
        channel: int | None = None,
        file: str | None = None,
    ) -> dict[str, Any]:
        """Find errors and warnings of a program without running it, and the positions of the rotary axes in its
        tilted planes; another check on this connection cancels this one.

        ``program.check``, for the role observer.

        Args:
            program: program file under the program root.
            text: text to check instead of the file.
            channel: channel; default: the first one; 1 to 999.
            file: where the text comes from; information for people only.
        """
        return self._call("program.check", _given(program=program, text=text, channel=channel, file=file))

    def picture(self, program: str, *, channel: int | None = None) -> dict[str, Any]:
        """Draw the virtual workpiece as the program leaves it after a run on a virtual clock: `picture` is a PNG
        in base64, seen from the front, right and above, or null if the program declares no blank; a check on
        this connection cancels it.

        ``program.picture``, for the role observer.

        Args:
            program: program file under the program root.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.picture", _given(program=program, channel=channel))

    def estimate(self, program: str, *, channel: int | None = None) -> dict[str, Any]:
        """Find the time and path length of a program from a run on a virtual clock, with the present tables,
        schemes and positions and with overrides at 100 %; a check on this connection cancels it.

        ``program.estimate``, for the role observer.

        Args:
            program: program file under the program root.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.estimate", _given(program=program, channel=channel))

    def check_cancel(self) -> dict[str, Any]:
        """Cancel the check or estimate of this connection, which then answers E9017.

        ``program.check_cancel``, for the role observer.
        """
        return self._call("program.check_cancel", _given())

    def path(
        self,
        *,
        channel: int | None = None,
        path: int | None = None,
        page: int | None = None,
        follow: int | None = None,
        system: Literal["work", "part"] | None = None,
    ) -> dict[str, Any]:
        """Read the planned path of the tool tip from the simulation of the loaded program: pages of points with
        the program lines that lead to them.

        ``program.path``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
            path: id of a path that was requested before; default: the newest path; 1 to 4000000000.
            page: page of the path, from 0; default: all pages, one by one; 0 to 1000000.
            follow: 1: the answer names the request for the next page, as it does without `page`; default 0;
                0 to 1.
            system: coordinate system of the points: work, the workpiece system that is active at each
                point, or part, a system that is fixed to the part; default: work.
        """
        return self._call("program.path", _given(channel=channel, path=path, page=page, follow=follow, system=system))

    def load(
        self,
        program: str,
        *,
        channel: int | None = None,
        wait: Literal["accepted", "done"] | None = None,
    ) -> dict[str, Any]:
        """Load and compile a program; errors are reported with file, line and column.

        ``program.load``, for the role operator.

        Args:
            program: program file under the program root.
            channel: channel; default: the first one; 1 to 999.
            wait: whether to answer when the request is accepted, or when the work is done.
        """
        return self._call("program.load", _given(program=program, channel=channel, wait=wait))

    def run(
        self,
        program: str,
        *,
        channel: int | None = None,
        wait: Literal["accepted", "done"] | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Load a program and start it.

        ``program.run``, for the role operator.

        Args:
            program: program file under the program root.
            channel: channel; default: the first one; 1 to 999.
            wait: whether to answer when the request is accepted, or when the work is done.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.run", _given(program=program, channel=channel, wait=wait, seen_cycle=seen_cycle))

    def start(
        self,
        *,
        channel: int | None = None,
        wait: Literal["accepted", "done"] | None = None,
        approach: int | None = None,
        restore: int | None = None,
        situation: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Start the loaded program, or continue it if it is held.

        ``program.start``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
            wait: whether to answer when the request is accepted, or when the work is done.
            approach: number of the approach from the answer to the block search; 1 to 4294967295.
            restore: 1: at the height of the approach, change tool, spindle and coolant to what the block
                needs; 0 to 1.
            situation: situation of the channel in the status that the request is based on; the request is
                refused if the situation has changed since; 1 to 2147483647.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.start", _given(
            channel=channel, wait=wait, approach=approach, restore=restore, situation=situation,
            seen_cycle=seen_cycle))

    def hold(self, *, channel: int | None = None) -> dict[str, Any]:
        """Feed hold: stop along the path.

        ``program.hold``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.hold", _given(channel=channel))

    def resume(self, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """Continue after a feed hold.

        ``program.resume``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.resume", _given(channel=channel, seen_cycle=seen_cycle))

    def return_(
        self,
        *,
        velocity: float | None = None,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Move the axes of a held program back to where it was held, the way that they came, jogged or along the
        path; first spindles and coolant are as the program left them.

        ``program.return``, for the role operator.

        Args:
            velocity: velocity along the way back; default: that with which the slowest axis searches its
                home switch; 0 to 100000 mm/s, deg/s.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.return", _given(velocity=velocity, channel=channel, seen_cycle=seen_cycle))

    def retrace(
        self,
        direction: Literal["back", "forward"],
        *,
        increment: float | None = None,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Move the axes of a held program back along its path, or forward again, at the programmed feed under the
        overrides: by an increment, or for 200 ms at a time.

        ``program.retrace``, for the role operator.

        Args:
            direction: back along what was passed, or forward as far as where the program is held.
            increment: way along the path; without it the axes move as long as the command is repeated; 0 to
                100000 mm.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.retrace", _given(
            direction=direction, increment=increment, channel=channel, seen_cycle=seen_cycle))

    def spindles(self, on: int, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """Stop the spindles of a held program, or let them turn again; they turn before the program continues.

        ``program.spindles``, for the role operator.

        Args:
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.spindles", _given(on=on, channel=channel, seen_cycle=seen_cycle))

    def coolant(self, on: int, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """Switch the coolant of a held program off, or on again; it is on before the program continues.

        ``program.coolant``, for the role operator.

        Args:
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.coolant", _given(on=on, channel=channel, seen_cycle=seen_cycle))

    def stop(self, *, channel: int | None = None) -> dict[str, Any]:
        """Hold the feed, then end the program without an alarm.

        ``program.stop``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.stop", _given(channel=channel))

    def reset(self, *, channel: int | None = None) -> dict[str, Any]:
        """End the program and clear the alarms of the channel.

        ``program.reset``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.reset", _given(channel=channel))

    def optional_stop(self, on: int, *, channel: int | None = None) -> dict[str, Any]:
        """Optional stop: set whether M1 stops the program.

        ``program.optional_stop``, for the role operator.

        Args:
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.optional_stop", _given(on=on, channel=channel))

    def first_part(self, on: int, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """First part: rapid traverse keeps to 25 %, whatever the rapid override is.

        ``program.first_part``, for the role operator.

        Args:
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("program.first_part", _given(on=on, channel=channel, seen_cycle=seen_cycle))

    def step(self, on: int, *, channel: int | None = None) -> dict[str, Any]:
        """Single block: stop after each block; `program start` begins the next one.

        ``program.step``, for the role operator.

        Args:
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.step", _given(on=on, channel=channel))

    def skip(self, level: int, *, channel: int | None = None) -> dict[str, Any]:
        """Skip the blocks of a level from the next sync point on.

        ``program.skip``, for the role operator.

        Args:
            level: level of block skip: 1 for /, 2 to 9 for /2 to /9; 1 to 9.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.skip", _given(level=level, channel=channel))

    def unskip(self, level: int, *, channel: int | None = None) -> dict[str, Any]:
        """Execute the blocks of a level again.

        ``program.unskip``, for the role operator.

        Args:
            level: level of block skip: 1 for /, 2 to 9 for /2 to /9; 1 to 9.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.unskip", _given(level=level, channel=channel))

    def list(self) -> dict[str, Any]:
        """List the program files under the program root, with the times (Unix) of their last change, and of the
        last check and run since the daemon started.

        ``program.list``, for the role observer.
        """
        return self._call("program.list", _given())

    def history(self, *, channel: int | None = None) -> dict[str, Any]:
        """List the newest 500 program runs of each channel, with their times and how they ended; cycles count from
        the last start of the daemon.

        ``program.history``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.history", _given(channel=channel))

    def search(
        self,
        target: str,
        *,
        pass_: int | None = None,
        calculation: Literal["with", "without"] | None = None,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Block search: make the loaded program begin at this block when it is started; the answer shows what
        precedes the block.

        ``program.search``, for the role operator.

        Args:
            target: line (120) or block number (N40); in another file: sub.nc:120.
            pass_: pass of the loop that contains the block; default 1; 1 to 1000000.
            calculation: with (default): begin in the state that the preceding blocks would leave; without:
                begin in the default state.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("program.search", _given(
            target=target, pass_=pass_, calculation=calculation, channel=channel))


class OverrideMethods:
    """Methods ``override.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def feed(
        self,
        percent: float,
        *,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Set the feed override of a channel.

        ``override.feed``, for the role operator.

        Args:
            percent: percent of the programmed value; 0 to 200 %.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("override.feed", _given(percent=percent, channel=channel, seen_cycle=seen_cycle))

    def rapid(
        self,
        percent: float,
        *,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Set the rapid override of a channel.

        ``override.rapid``, for the role operator.

        Args:
            percent: percent of the programmed value; 0 to 100 %.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("override.rapid", _given(percent=percent, channel=channel, seen_cycle=seen_cycle))

    def spindle(self, percent: float, *, channel: int | None = None) -> dict[str, Any]:
        """Set the spindle override of a channel.

        ``override.spindle``, for the role operator.

        Args:
            percent: percent of the programmed value; 50 to 150 %.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("override.spindle", _given(percent=percent, channel=channel))


class QueueMethods:
    """Methods ``queue.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self, *, channel: int | None = None) -> dict[str, Any]:
        """List the waiting programs of one channel or of all, and what stopped a queue.

        ``queue.list``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("queue.list", _given(channel=channel))

    def add(self, program: str, *, channel: int | None = None) -> dict[str, Any]:
        """Add a program to the end of the queue of a channel.

        ``queue.add``, for the role operator.

        Args:
            program: program file under the program root.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("queue.add", _given(program=program, channel=channel))

    def remove(self, id: int, *, channel: int | None = None) -> dict[str, Any]:
        """Remove a program from the queue, unless it is in progress.

        ``queue.remove``, for the role operator.

        Args:
            id: number of the entry, as queue.list shows it; 1 to 1000000000.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("queue.remove", _given(id=id, channel=channel))

    def move(self, id: int, place: int, *, channel: int | None = None) -> dict[str, Any]:
        """Move a program to another position in the queue.

        ``queue.move``, for the role operator.

        Args:
            id: number of the entry, as queue.list shows it; 1 to 1000000000.
            place: new position in the queue, from 1; 1 to 500.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("queue.move", _given(id=id, place=place, channel=channel))

    def start(self, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """Run the programs of the queue one after the other, until one fails, an alarm occurs, or somebody stops
        or resets something or takes the channel.

        ``queue.start``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("queue.start", _given(channel=channel, seen_cycle=seen_cycle))

    def stop(self, *, channel: int | None = None) -> dict[str, Any]:
        """Start no further program of the queue; the one in progress continues.

        ``queue.stop``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("queue.stop", _given(channel=channel))


class KinematicsMethods:
    """Methods ``kinematics.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self, *, channel: int | None = None) -> dict[str, Any]:
        """List the kinematic schemes of a channel.

        ``kinematics.list``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("kinematics.list", _given(channel=channel))

    def select(self, scheme: int, *, channel: int | None = None, seen_cycle: int | None = None) -> dict[str, Any]:
        """Switch a channel to another kinematic scheme; the channel must be idle.

        ``kinematics.select``, for the role operator.

        Args:
            scheme: number of the kinematic scheme; 0 to 9999.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("kinematics.select", _given(scheme=scheme, channel=channel, seen_cycle=seen_cycle))

    def status(self, *, channel: int | None = None) -> dict[str, Any]:
        """Show the active scheme, its axes, and their drives and brakes.

        ``kinematics.status``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("kinematics.status", _given(channel=channel))


class DriveMethods:
    """Methods ``drive.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self) -> dict[str, Any]:
        """List the drives of the machine file with bus address, kind and requests per exchange.

        ``drive.list``, for the role observer.
        """
        return self._call("drive.list", _given())

    def status(self) -> dict[str, Any]:
        """Show state, fault, position, switches and errors of every drive, and exchanges and latency of the bus.

        ``drive.status``, for the role observer.
        """
        return self._call("drive.status", _given())

    def reset(self, drive: str) -> dict[str, Any]:
        """Clear the fault of a drive.

        ``drive.reset``, for the role operator.

        Args:
            drive: name of the axis; for a spindle, S and its number.
        """
        return self._call("drive.reset", _given(drive=drive))

    def fault(
        self,
        drive: str,
        fault: Literal["none", "off", "stuck", "garbage", "slow", "intermittent", "trip", "elsewhere",
            "mangled", "hang_up", "jammed", "frozen"],
    ) -> dict[str, Any]:
        """Make a simulated drive fail or work again.

        ``drive.fault``, for the role integrator.

        Args:
            drive: name of the axis; for a spindle, S and its number.
            fault: fault that the drive has from now on, or none: the drive works again.
        """
        return self._call("drive.fault", _given(drive=drive, fault=fault))


class AlarmMethods:
    """Methods ``alarm.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self, *, channel: int | None = None) -> dict[str, Any]:
        """List the active alarms.

        ``alarm.list``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("alarm.list", _given(channel=channel))

    def ack(self, *, channel: int | None = None) -> dict[str, Any]:
        """Acknowledge the alarms of a channel.

        ``alarm.ack``, for the role operator.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("alarm.ack", _given(channel=channel))

    def history(self, *, channel: int | None = None) -> dict[str, Any]:
        """List the newest 500 alarms of each channel.

        ``alarm.history``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("alarm.history", _given(channel=channel))


class MeasurementMethods:
    """Methods ``measurement.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def history(self, *, channel: int | None = None) -> dict[str, Any]:
        """List what programs have measured since the daemon started: the newest 500 results of each channel.

        ``measurement.history``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("measurement.history", _given(channel=channel))


class ToolMethods:
    """Methods ``tool.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self) -> dict[str, Any]:
        """List the tool table.

        ``tool.list``, for the role observer.
        """
        return self._call("tool.list", _given())

    def get(self, number: int, *, edge: int | None = None) -> dict[str, Any]:
        """Show the values of one edge of a tool.

        ``tool.get``, for the role observer.

        Args:
            number: number of the tool; 0 to 32000.
            edge: edge of the tool; default 1; 1 to 99.
        """
        return self._call("tool.get", _given(number=number, edge=edge))

    def set(
        self,
        number: int,
        key: Literal["length", "length_x", "length_y", "radius", "wear_length", "wear_length_x", "wear_radius",
            "overhang", "orientation", "angle_front", "angle_back"],
        value: float,
        *,
        edge: int | None = None,
        confirmed: int | None = None,
    ) -> dict[str, Any]:
        """Change a value of a tool; not while a program runs.

        ``tool.set``, for the role operator.

        Args:
            number: number of the tool; 0 to 32000.
            key: name of the value.
            value: new value; -100000 to 100000 mm, deg.
            edge: edge of the tool; default 1; 1 to 99.
            confirmed: 1: set the value even if the value or the change exceeds entry_limits; 0 to 1.
        """
        return self._call("tool.set", _given(number=number, key=key, value=value, edge=edge, confirmed=confirmed))

    def touch(
        self,
        number: int,
        axis: str,
        value: float,
        *,
        as_: Literal["radius", "diameter"] | None = None,
        situation: int | None = None,
        edge: int | None = None,
        confirmed: int | None = None,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Touch off: set the length of a tool so that an axis is at a given value; at rest, or in a hold.

        ``tool.touch``, for the role operator.

        Args:
            number: number of the tool; 1 to 32000.
            axis: axis, by its word or its name.
            value: position that the axis is to have in the work system; -100000 to 100000 mm, deg.
            as_: whether the value is a radius or a diameter; required if X is shown as a diameter.
            situation: situation of the channel in the status that the request is based on; the request is
                refused if the situation has changed since; 1 to 2147483647.
            edge: edge of the tool; default 1; 1 to 99.
            confirmed: 1: set the value even if the value or the change exceeds entry_limits; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("tool.touch", _given(
            number=number, axis=axis, value=value, as_=as_, situation=situation, edge=edge,
            confirmed=confirmed, channel=channel))

    def load(self, tables: str, *, file: str | None = None, confirmed: int | None = None) -> dict[str, Any]:
        """Set the tools and work offsets listed in a text; not while a program is running.

        ``tool.load``, for the role operator.

        Args:
            tables: tools and work offsets, as in a tables file.
            file: name of the text in messages; default: the name of the file.
            confirmed: 1: set the value even if the value or the change exceeds entry_limits; 0 to 1.
        """
        return self._call("tool.load", _given(tables=tables, file=file, confirmed=confirmed))

    def save(self) -> dict[str, Any]:
        """Print tools and work offsets as a text for `tool load`.

        ``tool.save``, for the role observer.
        """
        return self._call("tool.save", _given())

    def history(self) -> dict[str, Any]:
        """List the newest 500 changes of tools and work offsets since the daemon started, newest first: by an
        operator, or by the program that ran last.

        ``tool.history``, for the role observer.
        """
        return self._call("tool.history", _given())


class OffsetMethods:
    """Methods ``offset.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def list(self) -> dict[str, Any]:
        """List the work offsets.

        ``offset.list``, for the role observer.
        """
        return self._call("offset.list", _given())

    def set(self, offset: str, axis: str, value: float, *, confirmed: int | None = None) -> dict[str, Any]:
        """Change a work offset; not while a program runs.

        ``offset.set``, for the role operator.

        Args:
            offset: work offset: G54 to G59, G59.1 to G59.3, "G54.1 P1".
            axis: axis of the machine, or R for the rotation.
            value: new value; -100000 to 100000 mm, deg.
            confirmed: 1: set the value even if the value or the change exceeds entry_limits; 0 to 1.
        """
        return self._call("offset.set", _given(offset=offset, axis=axis, value=value, confirmed=confirmed))

    def touch(
        self,
        offset: str,
        axis: str,
        value: float,
        *,
        as_: Literal["radius", "diameter"] | None = None,
        situation: int | None = None,
        confirmed: int | None = None,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Touch off: set a work offset so that an axis is at a given value; only at rest.

        ``offset.touch``, for the role operator.

        Args:
            offset: work offset: G54 to G59, G59.1 to G59.3, "G54.1 P1".
            axis: axis, by its word or its name.
            value: position that the axis is to have in the work system; -100000 to 100000 mm, deg.
            as_: whether the value is a radius or a diameter; required if X is shown as a diameter.
            situation: situation of the channel in the status that the request is based on; the request is
                refused if the situation has changed since; 1 to 2147483647.
            confirmed: 1: set the value even if the value or the change exceeds entry_limits; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("offset.touch", _given(
            offset=offset, axis=axis, value=value, as_=as_, situation=situation, confirmed=confirmed,
            channel=channel))

    def undo(self, undo: int) -> dict[str, Any]:
        """Undo a touch-off of an offset or a tool, if nobody has changed the value since.

        ``offset.undo``, for the role operator.

        Args:
            undo: number from the answer to the touch-off; 1 to 1000000000.
        """
        return self._call("offset.undo", _given(undo=undo))


class ProcessMethods:
    """Methods ``process.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def status(self, *, channel: int | None = None) -> dict[str, Any]:
        """Show feed law, feed, spindle, cutting speed and force control.

        ``process.status``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("process.status", _given(channel=channel))

    def interrupt(self, la: float, *, lb: float | None = None, channel: int | None = None) -> dict[str, Any]:
        """Interrupt the feed for the time of L_A, immediately and then after each L_B of path.

        ``process.interrupt``, for the role operator.

        Args:
            la: equivalent dwell path L_A: the axes dwell for the time that this path would take at the
                feed; 0 ends the interruption; 0 to 10000 mm.
            lb: path L_B at feed from one dwell to the next; 0 to 10000 mm.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("process.interrupt", _given(la=la, lb=lb, channel=channel))

    def automatic(
        self,
        law: Literal["modulated", "linear"],
        on: int,
        *,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Switch an automatic feed law on or off: the channel derives the feed from a sensor.

        ``process.automatic``, for the role operator.

        Args:
            law: modulated: acts on the vibration; linear: acts on the spindle power.
            on: 1: on; 0: off; 0 to 1.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("process.automatic", _given(law=law, on=on, channel=channel))

    def adaptive(
        self,
        action: Literal["off", "on", "set"],
        *,
        quantity: Literal["force", "level", "mass", "frequency"] | None = None,
        value: float | None = None,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Switch the adaptive control of the cutting force on or off, or change one of its values.

        ``process.adaptive``, for the role operator.

        Args:
            action: on: control to the given force, or to the last one; set: change one value.
            quantity: force: cutting force P_z; level: permissible vibration; mass, frequency: reduced mass
                and frequency of the oscillation that is formed from the vibration.
            value: new value of the quantity, greater than 0; 0 to 1000000 N, um, kg, Hz.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("process.adaptive", _given(action=action, quantity=quantity, value=value, channel=channel))

    def grinding(self, program: str) -> dict[str, Any]:
        """Design a plunge grinding cycle from a process file, or verify one from a control file; samples are time
        s, X mm, remaining allowance mm, infeed mm/s, removal mm2/rad, and the ratio of the removal to its
        boundary; a check on this connection cancels it.

        ``process.grinding``, for the role observer.

        Args:
            program: process file (.toml) or control file under the program root.
        """
        return self._call("process.grinding", _given(program=program))

    def stability(
        self,
        program: str,
        *,
        from_: float | None = None,
        to: float | None = None,
        count: int | None = None,
        method: Literal["zeroth-order", "semi-discretisation"] | None = None,
        speed: float | None = None,
        depth: float | None = None,
    ) -> dict[str, Any]:
        """Calculate stability lobes like `stanok process lobes`: the depths up to which a cut does not chatter;
        limits are speed rev/min, depth mm (null: any), chatter Hz (0: not known).

        ``process.stability``, for the role observer.

        Args:
            program: file with cut, tool and vibrations (.toml) under the program root.
            from_: lowest speed; default 1000; 1 to 1000000 rev/min.
            to: highest speed; default 20000; 1 to 1000000 rev/min.
            count: number of speeds in the range; default 400; 2 to 1200.
            method: zeroth-order (default): uses the mean over a tooth; semi-discretisation: follows each
                tooth, for small widths of cut.
            speed: speed of a planned cut to be checked; 1 to 1000000 rev/min.
            depth: depth of the planned cut; grinding: its width; 0.0001 to 10000 mm.
        """
        return self._call("process.stability", _given(
            program=program, from_=from_, to=to, count=count, method=method, speed=speed, depth=depth))

    def figures(
        self,
        file: str,
        *,
        kind: Literal["turning", "milling", "grinding"] | None = None,
        stock: str | None = None,
        program: str | None = None,
        channel: int | None = None,
        spindle: int | None = None,
        coefficient: float | None = None,
        touch: float | None = None,
        force_ratio: float | None = None,
        wheel_speed: float | None = None,
        tool: int | None = None,
        efficiency: float | None = None,
    ) -> dict[str, Any]:
        """Figures of a cut from its log, as `stanok process identify`, with intervals of 95 %; si is the same in
        SI units; power is time s, as recorded W, as fitted W; text is what to write into a file; fit says
        whether the model fits: if ok is false, the figures are not those of the cut; if it is true and there is
        a reason, their intervals are widened.

        ``process.figures``, for the role observer.

        Args:
            file: log, as history.logs lists them.
            kind: kind of cut in the log; default turning.
            stock: turning: bar before the cut in program coordinates, as Z:RADIUS or Z:RADIUS:HARDNESS in
                mm and HB, from each Z on: 0:32,-20:33.
            program: file under the program root; milling: tool and material (.toml); grinding: process file
                (.toml).
            channel: channel; default: the first one; 1 to 999.
            spindle: number of the machine spindle, from 1; grinding: the wheel spindle; default 1; 1 to 16.
            coefficient: turning: C of the material; set it if you know it to get the efficiency; 1 to
                1000000 N.
            touch: grinding: program X at which the wheel touches the part; default: the allowance; -10000
                to 10000 mm.
            force_ratio: grinding: ratio of tangential to normal force of the wheel; default 0.4; 0.05 to 2.
            wheel_speed: grinding: surface speed of the wheel; default 35; 1 to 200 m/s.
            tool: milling: number of the tool whose cuts are evaluated; default: all tools; 1 to 1000000.
            efficiency: grinding: efficiency of the wheel drive, default 0.85; milling: converts the forces
                at the drive into those of the cut, default 1; 0.1 to 1.
        """
        return self._call("process.figures", _given(
            file=file, kind=kind, stock=stock, program=program, channel=channel, spindle=spindle,
            coefficient=coefficient, touch=touch, force_ratio=force_ratio, wheel_speed=wheel_speed,
            tool=tool, efficiency=efficiency))

    def forces(
        self,
        program: str,
        *,
        cut: str | None = None,
        tool: int | None = None,
        step: float | None = None,
        force: float | None = None,
        feed_min: float | None = None,
        feed_max: float | None = None,
        stiffness: float | None = None,
        channel: int | None = None,
    ) -> dict[str, Any]:
        """Calculate forces along a program, and feeds that hold a force, like `stanok process optimise`; places
        are path mm, force as programmed N, force as planned N, feed as programmed mm/min, feed as planned
        mm/min, power W, depth mm or area mm2, deflection um; text is the program with the planned feeds.

        ``process.forces``, for the role observer.

        Args:
            program: part program under the program root.
            cut: milling: file with tool and material (.toml) under the program root; without it the program
                is a turning program.
            tool: milling: number of the tool whose cuts are evaluated; default: all tools; 1 to 1000000.
            step: milling: distance between two evaluated positions; default: twice the resolution of the
                workpiece; 0.0001 to 100 mm.
            force: cutting force to hold; without it only the forces as programmed are calculated; 0.001 to
                1000000 N.
            feed_min: lowest feed per revolution; default: a twentieth of the programmed feed; 0.0001 to
                1000 mm.
            feed_max: highest feed per revolution; default: the programmed feed; 0.0001 to 1000 mm.
            stiffness: turning: stiffness of tool and part across the cut; set it to get the deflection;
                0.001 to 1000000 N/um.
            channel: channel; default: the first one; 1 to 999.
        """
        return self._call("process.forces", _given(
            program=program, cut=cut, tool=tool, step=step, force=force, feed_min=feed_min,
            feed_max=feed_max, stiffness=stiffness, channel=channel))

    def cancel(self) -> dict[str, Any]:
        """Cancel the process calculation of this connection, which then answers E9017.

        ``process.cancel``, for the role observer.
        """
        return self._call("process.cancel", _given())


class WorkpieceMethods:
    """Methods ``workpiece.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def status(self) -> dict[str, Any]:
        """Show whether announcements of workpieces are published, and the latest one of every channel.

        ``workpiece.status``, for the role observer.
        """
        return self._call("workpiece.status", _given())

    def surface(
        self,
        *,
        channel: int | None = None,
        workpiece: int | None = None,
        since: int | None = None,
        from_: int | None = None,
        reference: str | None = None,
    ) -> dict[str, Any]:
        """Read the surface of the workpiece that is being cut, page by page, or only what has changed.

        ``workpiece.surface``, for the role observer.

        Args:
            channel: channel; default: the first one; 1 to 999.
            workpiece: workpiece that `since` and `from` refer to; if the channel has another one, the
                answer contains all of it, from its beginning; 0 to 4000000000.
            since: version that you already have: the answer contains only what has changed since; default
                0: everything; 0 to 4000000000.
            from_: brick at which the page begins: `next` of the previous page; default 0; 0 to 1000000000.
            reference: STL file under the program root, in the workpiece system of the announcement: the
                numbers of the corners are then their distances from its surface, Int32 in 0.1 um, positive
                outside, instead of tools.
        """
        return self._call("workpiece.surface", _given(
            channel=channel, workpiece=workpiece, since=since, from_=from_, reference=reference))

    def allow(self, *, on: int | None = None) -> dict[str, Any]:
        """Publish the workpieces that programs announce with #workpiece, so that viewers can follow the cut.

        ``workpiece.allow``, for the role operator.

        Args:
            on: 1 (default): publish them; 0: stop publishing them; 0 to 1.
        """
        return self._call("workpiece.allow", _given(on=on))


class ScopeMethods:
    """Methods ``scope.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def signals(self) -> dict[str, Any]:
        """List the signals of axes, channels and cycle that can be recorded, with units and limits.

        ``scope.signals``, for the role observer.
        """
        return self._call("scope.signals", _given())

    def start(
        self,
        signals: str,
        *,
        trigger: Literal["none", "level", "event", "block", "alarm"] | None = None,
        signal: str | None = None,
        level: float | None = None,
        edge: Literal["rising", "falling"] | None = None,
        event: str | None = None,
        line: int | None = None,
        channel: int | None = None,
        before_s: float | None = None,
        length_s: float | None = None,
    ) -> dict[str, Any]:
        """Record signals in every cycle, starting before a trigger; ends the previous recording.

        ``scope.start``, for the role operator.

        Args:
            signals: up to 8 names from scope.signals, separated by blanks or commas.
            trigger: what the recording waits for; default none: it starts immediately.
            signal: signal that is compared with the level; default: the first one.
            level: value that the signal must cross, in its unit; -1000000000 to 1000000000.
            edge: direction of the crossing; default rising.
            event: code of the event, such as E6010; default: any.
            line: line of the block whose beginning is the trigger; 1 to 4000000000.
            channel: channel; default: the first one; 1 to 999.
            before_s: time recorded before the trigger; default: a quarter of length_s; 0 to 120 s.
            length_s: duration of the whole recording, at most 120,000 cycles; default 2; 0.001 to 120 s.
        """
        return self._call("scope.start", _given(
            signals=signals, trigger=trigger, signal=signal, level=level, edge=edge, event=event, line=line,
            channel=channel, before_s=before_s, length_s=length_s))

    def stop(self) -> dict[str, Any]:
        """End the recording; what has been recorded can be read.

        ``scope.stop``, for the role operator.
        """
        return self._call("scope.stop", _given())

    def read(self, *, from_: int | None = None) -> dict[str, Any]:
        """Read the recording, at most 4096 cycles at a time: Float32, little endian, in base64, one value of each
        signal, cycle by cycle.

        ``scope.read``, for the role observer.

        Args:
            from_: cycle of the recording at which the answer begins; default 0; 0 to 1000000000.
        """
        return self._call("scope.read", _given(from_=from_))


class HistoryMethods:
    """Methods ``history.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def logs(self) -> dict[str, Any]:
        """List the log files of the machine, newest first.

        ``history.logs``, for the role observer.
        """
        return self._call("history.logs", _given())

    def verify(self, file: str) -> dict[str, Any]:
        """Repeat the run of a log from its inputs and compare every setpoint; the verdict is same, part (the log
        is cut off, damaged or lacks inputs, but is the same as far as it goes), or differs.

        ``history.verify``, for the role observer.

        Args:
            file: name of a log, as history.logs lists it.
        """
        return self._call("history.verify", _given(file=file))

    def path(
        self,
        file: str,
        *,
        channel: int | None = None,
        page: int | None = None,
        system: Literal["work", "part"] | None = None,
    ) -> dict[str, Any]:
        """Read the path of the tool tip of a channel from a log: pages of points with their times.

        ``history.path``, for the role observer.

        Args:
            file: name of a log, as history.logs lists it.
            channel: channel; default: the first one; 1 to 999.
            page: page of the path, from 0; default 0, which reads the log again; 0 to 1000000.
            system: coordinate system of the points: work, the workpiece system that is active at each
                point, or part, a system that is fixed to the part; default: work.
        """
        return self._call("history.path", _given(file=file, channel=channel, page=page, system=system))


class LogMethods:
    """Methods ``log.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def status(self) -> dict[str, Any]:
        """Show file, bytes and losses of the recorder and the LCM publisher.

        ``log.status``, for the role observer.
        """
        return self._call("log.status", _given())

    def start(self) -> dict[str, Any]:
        """Start a new log file.

        ``log.start``, for the role operator.
        """
        return self._call("log.start", _given())

    def stop(self) -> dict[str, Any]:
        """Close the log file.

        ``log.stop``, for the role operator.
        """
        return self._call("log.stop", _given())


class SessionMethods:
    """Methods ``session.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def role(
        self,
        role: Literal["observer", "operator", "programmer", "integrator"],
        *,
        name: str | None = None,
    ) -> dict[str, Any]:
        """Lower the role of this connection, and name the person who works there.

        ``session.role``, for the role observer.

        Args:
            role: highest role of the connection from now on; a connection cannot raise its role again.
            name: name of the person who works here, for the log and for others who see who controls a
                channel; once given, the name cannot be changed.
        """
        return self._call("session.role", _given(role=role, name=name))


class SystemMethods:
    """Methods ``system.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def info(self) -> dict[str, Any]:
        """Show version, build, process, files and clients of the daemon.

        ``system.info``, for the role observer.
        """
        return self._call("system.info", _given())

    def shutdown(self) -> dict[str, Any]:
        """Hold the feed, then switch the drives off, then end the daemon.

        ``system.shutdown``, for the role integrator.
        """
        return self._call("system.shutdown", _given())


class RpcMethods:
    """Methods ``rpc.*``."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def discover(self) -> dict[str, Any]:
        """Show this table of methods as an OpenRPC document.

        ``rpc.discover``, for the role observer.
        """
        return self._call("rpc.discover", _given())


class Methods:
    """Every method of the protocol: nouns as attributes, verbs as their methods."""

    def __init__(self, call: Call) -> None:
        self._call = call
        self.machine = MachineMethods(call)
        self.channel = ChannelMethods(call)
        self.program = ProgramMethods(call)
        self.override = OverrideMethods(call)
        self.queue = QueueMethods(call)
        self.kinematics = KinematicsMethods(call)
        self.drive = DriveMethods(call)
        self.alarm = AlarmMethods(call)
        self.measurement = MeasurementMethods(call)
        self.tool = ToolMethods(call)
        self.offset = OffsetMethods(call)
        self.process = ProcessMethods(call)
        self.workpiece = WorkpieceMethods(call)
        self.scope = ScopeMethods(call)
        self.history = HistoryMethods(call)
        self.log = LogMethods(call)
        self.session = SessionMethods(call)
        self.system = SystemMethods(call)
        self.rpc = RpcMethods(call)

    def mdi(
        self,
        text: str,
        *,
        channel: int | None = None,
        wait: Literal["accepted", "done"] | None = None,
        situation: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Execute one line of program text: a block or a statement.

        ``mdi``, for the role operator.

        Args:
            text: one complete statement.
            channel: channel; default: the first one; 1 to 999.
            wait: whether to answer when the request is accepted, or when the work is done.
            situation: situation of the channel in the status that the request is based on; the request is
                refused if the situation has changed since; 1 to 2147483647.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("mdi", _given(
            text=text, channel=channel, wait=wait, situation=situation, seen_cycle=seen_cycle))

    def jog(
        self,
        axis: str,
        velocity: float,
        *,
        increment: float | None = None,
        frame: Literal["machine", "tool", "plane"] | None = None,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Jog an axis by an increment, or for 200 ms at a time; repeat the command to keep the axis moving.

        ``jog``, for the role operator.

        Args:
            axis: machine axis as named in the machine file; with another frame than machine: X, Y or Z.
            velocity: velocity; its sign is the direction; -100000 to 100000 mm/s, deg/s.
            increment: distance to move; without it the axis moves as long as the jog is repeated; 0 to
                100000 mm, deg.
            frame: directions of the jog: those of one machine axis, of the tool (Z points from its tip into
                the spindle), or of the workpiece as programs see it at present, including tilted planes;
                with `tool` and `plane` the tool moves in a straight line and the rotary axes do not move.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("jog", _given(
            axis=axis, velocity=velocity, increment=increment, frame=frame, channel=channel,
            seen_cycle=seen_cycle))

    def handwheel(
        self,
        axis: str,
        way: float,
        *,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Move an axis as a handwheel does: the way is added to where the axis goes, and followed as fast as the
        axis can; what it cannot follow is dropped, so that it stands soon after the wheel.

        ``handwheel``, for the role operator.

        Args:
            axis: machine axis as named in the machine file, or path: that of a held program, back or
                forward.
            way: way by which the wheel was turned; its sign is the direction; -1000 to 1000 mm, deg.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("handwheel", _given(axis=axis, way=way, channel=channel, seen_cycle=seen_cycle))

    def home(
        self,
        *,
        axis: str | None = None,
        channel: int | None = None,
        seen_cycle: int | None = None,
    ) -> dict[str, Any]:
        """Home the axes of a channel in the order of the machine file; finds the home switches or index pulses,
        and answers when homing is done.

        ``home``, for the role operator.

        Args:
            axis: home only this axis; default: all axes of the channel.
            channel: channel; default: the first one; 1 to 999.
            seen_cycle: cycle of the newest status that was seen; the request is refused if that is too long
                ago.
        """
        return self._call("home", _given(axis=axis, channel=channel, seen_cycle=seen_cycle))

    def subscribe(
        self,
        topics: Sequence[Literal["machine", "channels", "drives", "events"]],
        *,
        rate_hz: float | None = None,
    ) -> dict[str, Any]:
        """Send a snapshot of these topics, then their changes as notifications.

        ``subscribe``, for the role observer.

        Args:
            topics: topics to subscribe to; an empty list ends the subscription.
            rate_hz: maximum number of status messages per second; default 10; 0.1 to 50 Hz.
        """
        return self._call("subscribe", _given(topics=topics, rate_hz=rate_hz))
