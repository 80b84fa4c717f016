"""26 Oct: Motion seen from a turntable, and Foucault's pendulum.

The turntable turns counter-clockwise at `spin` W, its axes along those of space at t = 0; a spring of zero rest length
pulls a particle to its centre. Rates of components lack the term W x: v_space = v + W x r, and once more a_space =
a + 2 W x v + W x (W x r). So an observer on the table adds -2 m W x v, Coriolis' force, and m W^2 r, the centrifugal
one, to F = m a. No body exerts them. The energy with the second one's potential, m (v^2 - W^2 r^2)/2 + k r^2/2, is
Jacobi's integral. The Earth turns at W sin(latitude) about the vertical of a place; the plane of a pendulum turns as
fast in the opposite direction (Goldstein, Classical Mechanics, sections 4.9 and 4.10).
"""

from collections.abc import Sequence
from math import hypot, sin, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, finite, nonnegative, numbers, positive, sequence
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, frames

STATE = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}  # as seen from the turntable
EXAMPLE = {"mass": 1.0, "stiffness": 0.5, "spin": 1.5}  # kg, N/m, rad/s
START = (1.0, 0.0, -0.6, -1.2)
SECONDS = 12.0


def rates(t: float, state: Sequence[float], *, mass: float, stiffness: float, spin: float) -> tuple[float, ...]:
    """Return (4,) velocity, m/s, and acceleration, m/s^2, as seen from the turntable."""
    _check(mass, stiffness, spin)
    sequence(4, state=state)
    x, y, vx, vy = state
    outward = spin * spin - stiffness / mass
    return vx, vy, outward * x + 2 * spin * vy, outward * y - 2 * spin * vx


def coriolis(state: ArrayLike, *, mass: float, stiffness: float, spin: float) -> Array:
    """Return (2,) N, -2 m W x v: to the right of the velocity if the table turns counter-clockwise."""
    _check(mass, stiffness, spin)
    _, _, vx, vy = numbers(4, state=state)
    return 2 * mass * spin * np.array([vy, -vx])


def centrifugal(state: ArrayLike, *, mass: float, stiffness: float, spin: float) -> Array:
    """Return (2,) N, m W^2 r: away from the centre."""
    _check(mass, stiffness, spin)
    return mass * spin**2 * numbers(4, state=state)[:2]


def to_space(t: ArrayLike, state: ArrayLike, *, spin: float) -> Array:
    """Convert a state (4,), seen from the turntable at the time t, s, to one in space; or (n, 4) at t (n,)."""
    finite(spin=spin)
    states = array(None, state=state)
    x, y, vx, vy = np.moveaxis(array((*states.shape[:-1], 4), state=states), -1, 0)
    turned = np.exp(1j * spin * array(states.shape[:-1], t=t))  # x + i y is turned by this factor
    r, v = turned * (x + 1j * y), turned * (vx + 1j * vy + 1j * spin * (x + 1j * y))
    return np.stack([r.real, r.imag, v.real, v.imag], axis=-1)


def from_space(t: ArrayLike, state: ArrayLike, *, spin: float) -> Array:
    """Convert a state (4,) in space, at the time t, s, to one seen from the turntable; or (n, 4) at t (n,)."""
    finite(spin=spin)
    return to_space(t, state, spin=-spin)  # seen from the turntable, space turns the other way


def exact(t: ArrayLike, state: ArrayLike, *, mass: float, stiffness: float, spin: float) -> Array:
    """Return (n, 4) states at the times t (n,), s, of the motion from `state` at t[0]: an ellipse or line in space."""
    _check(mass, stiffness, spin)
    times, start = numbers(t=t), numbers(4, state=state)
    since, w = times - times[:1], sqrt(stiffness / mass)
    r, v = start[:2], to_space(0.0, start, spin=spin)[2:]
    c, s = np.cos(w * since)[:, None], (since * np.sinc(w * since / np.pi))[:, None]
    return from_space(since, np.hstack([c * r + s * v, c * v - w**2 * s * r]), spin=spin)


def jacobi_integral(state: ArrayLike, *, mass: float, stiffness: float, spin: float) -> float:
    """Jacobi's integral, J: kinetic energy on the turntable, and potential of the spring and the centrifugal force."""
    _check(mass, stiffness, spin)
    x, y, vx, vy = numbers(4, state=state)
    return float(mass * (vx**2 + vy**2) + (stiffness - mass * spin**2) * (x**2 + y**2)) / 2


def angular_momentum(state: ArrayLike, *, mass: float, stiffness: float, spin: float) -> float:
    """Angular momentum in space about the centre, kg m^2/s."""
    _check(mass, stiffness, spin)
    x, y, vx, vy = numbers(4, state=state)
    return float(mass * (x * vy - y * vx + spin * (x**2 + y**2)))


INVARIANTS = {"jacobi_integral": jacobi_integral, "angular_momentum": angular_momentum}


def foucault(t: ArrayLike, *, length: float, gravity: float, latitude: float, spin: float) -> Array:
    """Return the angle, rad, by which a pendulum's plane has turned at the times t, s, counter-clockwise from above.

    length, gravity : m, m/s^2; they determine how fast the pendulum swings, not how fast its plane turns
    latitude        : rad, north positive
    spin            : rad/s, of the Earth
    """
    positive(length=length, gravity=gravity)
    finite(latitude=latitude, spin=spin)
    return -spin * sin(latitude) * array(None, t=t)


def foucault_path(t: ArrayLike, *, length: float, gravity: float, latitude: float, spin: float) -> Array:
    """Return (n, 2) east and north at the times t (n,), s, of a bob let go at rest on Earth at (1, 0); small swings."""
    plane = foucault(t, length=length, gravity=gravity, latitude=latitude, spin=spin)
    rate = spin * sin(latitude)
    w = hypot(sqrt(gravity / length), rate)
    swing = np.cos(w * numbers(t=t)) + 1j * rate / w * np.sin(w * numbers(t=t))
    bob = np.exp(1j * plane) * swing
    return np.column_stack([bob.real, bob.imag])


def _check(mass: float, stiffness: float, spin: float) -> None:
    positive(mass=mass)
    nonnegative(stiffness=stiffness)
    finite(spin=spin)


film = drawn_for(frames.film, globals())
