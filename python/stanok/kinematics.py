"""Kinematics of a machine for arrays of points: forward, inverse and derivatives."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _native
from .machine import MachineLike, as_machine

__all__ = ["Jets", "Kinematics", "Turn"]

Floats = npt.NDArray[np.float64]
Turn = tuple[Sequence[float], float]
"""An axis (three numbers of any length) and an angle about it in deg, counter-clockwise."""


class Jets(NamedTuple):
    """Machine axes with their derivatives in time, each ``(n, k)``: mm or deg, per s, per s², per s³."""

    position: Floats
    velocity: Floats
    acceleration: Floats
    jerk: Floats


class Kinematics:
    """The map between programmed points W and machine axes M in a scheme of a channel.

    These are the functions that the real-time cycle calls: axes of a simulation are, bit for bit, the inverse
    of its points. Columns are the axes of the channel in its order (``axes``, ``words``); mm and deg.

    Args:
        machine: a machine file, or a machine that was read.
        channel: channel of the scheme.
        scheme: number of the scheme; ``None``: the scheme of the machine file.
        mode: ``"axes"``: linear axes are programmed directly (G43, G49); ``"tip"``: the tool tip is programmed,
            regardless of the rotary axes (G43.4).
        nose_to_tip: vector from the spindle nose to the tip when the head is at 0, ``(3,)`` mm;
            ``(0, 0, -120)`` for a tool of 120 mm.
        offset: zero of the workpiece in the base of the scheme, by word, mm or deg.
        turns: rotations of the workpiece system, in order.
    """

    def __init__(self, machine: MachineLike, channel: int = 1, scheme: int | None = None, *,
                 mode: Literal["axes", "tip"] = "axes", nose_to_tip: Sequence[float] = (0.0, 0.0, 0.0),
                 offset: Mapping[str, float] | None = None, turns: Sequence[Turn] = ()) -> None:
        read = as_machine(machine)
        self._channel = read.channel(channel)
        self._scheme = self._channel.scheme if scheme is None else scheme
        if mode not in ("axes", "tip"):
            raise ValueError(f"mode is {mode!r}; give 'axes' or 'tip'")
        tool = [float(value) for value in nose_to_tip]
        if len(tool) != 3:
            raise ValueError("nose_to_tip must have three values")
        for word in offset or {}:
            if word not in self._channel.words:
                raise ValueError(f"offset: channel {channel} has no axis {word!r}; "
                                 f"it has {', '.join(self._channel.words)}")
        shifts = [float((offset or {}).get(word, 0.0)) for word in self._channel.words]
        rotation = [[*map(float, axis), float(angle)] for axis, angle in turns]
        if any(len(turn) != 4 for turn in rotation):
            raise ValueError("turns: give an axis of three values and an angle each")
        self._native = _native.Kinematics(read._native, channel, self._scheme, mode == "tip", tool, shifts, rotation)

    @property
    def axes(self) -> tuple[str, ...]:
        """Names of the machine axes: the columns of all arrays."""
        return self._channel.axes

    @property
    def words(self) -> tuple[str, ...]:
        """The words of the same axes in programs."""
        return self._channel.words

    @property
    def scheme(self) -> int:
        """Number of the scheme."""
        return self._scheme

    @property
    def type(self) -> str:
        """Type of the scheme, as in the scheme file."""
        return self._native.type()

    @property
    def taking_part(self) -> tuple[bool, ...]:
        """Which axes take part; the others pass through unchanged."""
        return self._set(self._native.taking_part())

    @property
    def winding(self) -> tuple[bool, ...]:
        """Which axes the inverse determines only up to whole turns of 360 deg."""
        return self._set(self._native.winding())

    def forward(self, axes: npt.ArrayLike) -> Floats:
        """Programmed points of machine axes: ``(n, k)`` or ``(k,)`` to the same shape; mm and deg."""
        given, shape = self._rows(axes, "axes")
        return self._native.forward(given).reshape(shape)

    def inverse(self, points: npt.ArrayLike) -> Floats:
        """Machine axes of programmed points: ``(n, k)`` or ``(k,)`` to the same shape; mm and deg."""
        given, shape = self._rows(points, "points")
        return self._native.inverse(given).reshape(shape)

    def jets(self, position: npt.ArrayLike, velocity: npt.ArrayLike, acceleration: npt.ArrayLike | None = None,
             jerk: npt.ArrayLike | None = None) -> Jets:
        """Exact velocity, acceleration and jerk of the machine axes for a moving point.

        Args:
            position: programmed points, ``(n, k)`` or ``(k,)``, mm or deg.
            velocity: of the points, same shape, per s.
            acceleration: of the points, per s²; ``None``: zero.
            jerk: of the points, per s³; ``None``: zero.
        """
        given, shape = self._rows(position, "position")
        derivatives = []
        for name, value in (("velocity", velocity), ("acceleration", acceleration), ("jerk", jerk)):
            rows = np.zeros_like(given) if value is None else self._rows(value, name)[0]
            if rows.shape != given.shape:
                raise ValueError(f"{name} must have the shape of position, {shape}")
            derivatives.append(rows)
        return Jets(*(array.reshape(shape) for array in self._native.jets(given, *derivatives)))

    def jacobian(self, points: npt.ArrayLike) -> Floats:
        """Derivatives of the machine axes with respect to the programmed coordinates: ``(n, k, k)`` or ``(k, k)``.

        ``J[i, a, p]`` is the derivative of axis ``a`` with respect to coordinate ``p``: mm or deg per mm or deg.
        """
        given, shape = self._rows(points, "points")
        width = given.shape[1]
        result = np.empty((given.shape[0], width, width))
        zero = np.zeros_like(given)
        for p in range(width):
            direction = np.zeros_like(given)
            direction[:, p] = 1.0
            result[:, :, p] = self._native.jets(given, direction, zero, zero)[1]
        return result.reshape((*shape, width))

    def __repr__(self) -> str:
        return f"<Kinematics of channel {self._channel.id}: scheme {self._scheme}, {self.type}>"

    def _set(self, bits: int) -> tuple[bool, ...]:
        return tuple(bool(bits >> k & 1) for k in range(len(self._channel.axes)))

    def _rows(self, values: npt.ArrayLike, name: str) -> tuple[Floats, tuple[int, ...]]:
        array = np.ascontiguousarray(values, dtype=np.float64)
        shape = np.shape(values)
        width = len(self._channel.axes)
        if len(shape) not in (1, 2) or shape[-1] != width:
            raise ValueError(f"{name} has the shape {shape}; it must be (n, {width}) or ({width},): "
                             f"{', '.join(self._channel.words)}")
        return array.reshape(-1, width), shape
