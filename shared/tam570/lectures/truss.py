"""12 Sept: A rigid body as particles that stiff bars join, the way that nobody uses.

In the plane; positions, then velocities. Each bar is a spring with its rest length: its tension k (length - rest)
pulls its two ends together. Nothing else acts, so momentum, angular momentum and energy are constant. The stiffer the
bars, the closer the motion to that of the rigid body, whose centre of mass moves uniformly while it turns at H/I; the
distance goes as 1/k, like the stretch that bends the particles' paths.
"""

from collections.abc import Sequence
from math import nan, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, numbers, positive, positives, sequence
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, truss
from tam570.values import Numbers, Parameters

STATE = {f"{part}{axis}{i}": unit for part, unit in (("", "m"), ("v", "m/s")) for i in (1, 2, 3, 4) for axis in "xy"}
EXAMPLE: Parameters = {  # kg, -, m, N/m: a square with one diagonal
    "masses": (1.0, 1.0, 2.0, 1.0),
    "bars": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 2)),
    "lengths": (1.0, 1.0, 1.0, 1.0, sqrt(2.0)),
    "stiffness": 300.0,
}
START = (0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.9, -1.5, 1.9, 1.5, -1.1, 1.5, -1.1, -1.5)  # turns at 3 rad/s
SECONDS = 6.0


def rates(
    t: float,
    state: Sequence[float],
    *,
    masses: Sequence[float],
    bars: Sequence[Sequence[int]],
    lengths: Sequence[float],
    stiffness: float,
) -> tuple[float, ...]:
    """Return (4 n,) velocities x1, y1, ..., m/s, then accelerations, m/s^2.

    masses    : (n,) kg
    bars      : (m, 2) indices of the two particles that each bar joins
    lengths   : (m,) m, without tension
    stiffness : of every bar, N/m
    """
    each, joined, rests = _checked(masses, bars, lengths, stiffness)
    n = len(each)
    sequence(4 * n, state=state)
    forces = [0.0] * (2 * n)
    for (i, j), rest in zip(joined, rests, strict=True):
        x, y = state[2 * j] - state[2 * i], state[2 * j + 1] - state[2 * i + 1]
        try:
            pull = stiffness * (1.0 - rest / sqrt(x * x + y * y))  # N/m, tension over length
        except ZeroDivisionError:  # both at the same place, where a trial step may end
            pull = nan
        for end, sign in ((i, pull), (j, -pull)):
            forces[2 * end] += sign * x
            forces[2 * end + 1] += sign * y
    return (*state[2 * n :], *(forces[k] / each[k // 2] for k in range(2 * n)))


def energy(state: ArrayLike, *, masses: Numbers, bars: Numbers, lengths: Numbers, stiffness: float) -> float:
    """Energy of the particles and the bars, J."""
    m, r, v = _parts(state, masses, bars, lengths, stiffness)
    i, j = np.transpose(bars)
    stretch = np.sqrt(((r[j] - r[i]) ** 2).sum(axis=1)) - lengths
    return float(m @ (v * v).sum(axis=1) + stiffness * stretch @ stretch) / 2


def momentum(state: ArrayLike, *, masses: Numbers, bars: Numbers, lengths: Numbers, stiffness: float) -> Array:
    """Linear momentum, (2,) kg m/s."""
    m, _, v = _parts(state, masses, bars, lengths, stiffness)
    return m @ v


def angular_momentum(state: ArrayLike, *, masses: Numbers, bars: Numbers, lengths: Numbers, stiffness: float) -> float:
    """Angular momentum about the origin, kg m^2/s."""
    m, r, v = _parts(state, masses, bars, lengths, stiffness)
    return float(m @ (r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0]))


INVARIANTS = {"energy": energy, "momentum": momentum, "angular_momentum": angular_momentum}


def rigid(
    t: ArrayLike, state: ArrayLike, *, masses: Numbers, bars: Numbers, lengths: Numbers, stiffness: float
) -> Array:
    """Return (m, 4 n) states at the times t (m,), s, of the rigid body with places and momenta of `state` at t[0]."""
    times = numbers(t=t)
    m, r, v = _parts(state, masses, bars, lengths, stiffness)
    centre, speed = m @ r / m.sum(), m @ v / m.sum()
    arms, flow = r - centre, v - speed
    turning = (m @ (arms[:, 0] * flow[:, 1] - arms[:, 1] * flow[:, 0])) / (m @ (arms * arms).sum(axis=1))  # H/I
    since = (times - times[:1])[:, None, None]
    c, s = np.cos(turning * since), np.sin(turning * since)
    ahead = np.column_stack([-arms[:, 1], arms[:, 0]])
    places = centre + speed * since + c * arms + s * ahead
    velocities = speed + turning * (c * ahead - s * arms)
    return np.hstack([places.reshape(len(times), 2 * len(m)), velocities.reshape(len(times), 2 * len(m))])


def _checked(
    masses: Sequence[float], bars: Sequence[Sequence[int]], lengths: Sequence[float], stiffness: float
) -> tuple[tuple[float, ...], list[list[int]], tuple[float, ...]]:
    positive(stiffness=stiffness)
    each, pairs = positives(masses=masses), array((None, 2), bars=bars)
    if (pairs != np.round(pairs)).any() or (pairs < 0).any() or (pairs >= len(each)).any():
        raise ValueError(f"bars: must be pairs of numbers of particles, 0 to {len(each) - 1}, got {bars!r}")
    if (pairs[:, 0] == pairs[:, 1]).any():
        raise ValueError(f"bars: must join two different particles, got {bars!r}")
    return each, pairs.astype(int).tolist(), positives(len(pairs), lengths=lengths)


def _parts(
    state: ArrayLike, masses: Numbers, bars: Numbers, lengths: Numbers, stiffness: float
) -> tuple[Array, Array, Array]:
    """Return (n,) masses, (n, 2) positions, (n, 2) velocities."""
    m = np.array(_checked(masses, bars, lengths, stiffness)[0])
    r, v = numbers(4 * len(m), state=state).reshape(2, -1, 2)
    return m, r, v


film = drawn_for(truss.film, globals())
