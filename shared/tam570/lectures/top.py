"""2 Nov: A heavy symmetric top on its tip.

3-1-3 Euler angles psi (round the vertical), theta (the tilt from it), phi (about the axis), their rates W, n, s.
Moments of inertia about the tip: axial C, transverse A; the centre of mass is `distance` d from the tip. Angular
momentum balance about the tip: A theta'' = (A W cos(theta) - C w) W sin(theta) + m g d sin(theta) with w = s + W
cos(theta), the spin; and neither C w nor A W sin(theta)^2 + C w cos(theta) changes. In steady precession A cos(theta)
W^2 - C w W + m g d = 0; the classic m g d/(C w) leaves out the first term (Goldstein, Classical Mechanics, section
5.7).
"""

from collections.abc import Sequence
from math import copysign, cos, inf, nan, sin, sqrt

from numpy.typing import ArrayLike

from tam570.arguments import finite, numbers, positive, sequence
from tam570.show.scenes import drawn_for, top

STATE = {"psi": "rad", "theta": "rad", "phi": "rad", "psi_rate": "rad/s", "theta_rate": "rad/s", "phi_rate": "rad/s"}
EXAMPLE = {"mass": 2.0, "distance": 1.5, "axial": 5.0, "transverse": 7.0, "gravity": 9.81}  # kg, m, kg m^2, m/s^2
START = (0.0, 1.0, 0.0, 0.0, 0.0, 5.0)
SECONDS = 5.0
LEVEL = 1e-15  # |cos(tilt)| of pi/2 rounded


def rates(
    t: float, state: Sequence[float], *, mass: float, distance: float, axial: float, transverse: float, gravity: float
) -> tuple[float, ...]:
    """Return (6,) rates of the angles, rad/s, and their accelerations, rad/s^2; nan where theta is 0."""
    weight = _weight(mass, distance, axial, transverse, gravity)
    sequence(6, state=state)
    _, theta, _, W, nod, s = state
    try:
        sine, cosine = sin(theta), cos(theta)
        gyro = axial * (s + W * cosine)
        turn = nod * (gyro - 2 * transverse * W * cosine) / (transverse * sine)
    except (ValueError, ZeroDivisionError):  # psi and phi turn about the same line, or a trial step was infinite
        return W, nod, s, nan, nan, nan
    dip = sine * ((transverse * W * cosine - gyro) * W + weight) / transverse
    return W, nod, s, turn, dip, W * nod * sine - turn * cosine


def energy(state: ArrayLike, *, mass: float, distance: float, axial: float, transverse: float, gravity: float) -> float:
    """Energy, J; the potential energy is 0 at the height of the tip."""
    weight = _weight(mass, distance, axial, transverse, gravity)
    _, theta, _, W, nod, s = numbers(6, state=state)
    across, along = nod**2 + (W * sin(theta)) ** 2, s + W * cos(theta)
    return float((transverse * across + axial * along**2) / 2 + weight * cos(theta))


def axial_momentum(
    state: ArrayLike, *, mass: float, distance: float, axial: float, transverse: float, gravity: float
) -> float:
    """Angular momentum about the top's axis, kg m^2/s."""
    _weight(mass, distance, axial, transverse, gravity)
    _, theta, _, W, _, s = numbers(6, state=state)
    return float(axial * (s + W * cos(theta)))


def vertical_momentum(
    state: ArrayLike, *, mass: float, distance: float, axial: float, transverse: float, gravity: float
) -> float:
    """Angular momentum about the vertical through the tip, kg m^2/s."""
    _weight(mass, distance, axial, transverse, gravity)
    _, theta, _, W, _, s = numbers(6, state=state)
    return float(transverse * W * sin(theta) ** 2 + axial * (s + W * cos(theta)) * cos(theta))


INVARIANTS = {"energy": energy, "axial_momentum": axial_momentum, "vertical_momentum": vertical_momentum}


def steady_precession(
    tilt: float, spin: float, *, mass: float, distance: float, axial: float, transverse: float, gravity: float
) -> tuple[float, float]:
    """Return (slow, fast) rates round the vertical, rad/s, at a tilt, rad, and a spin along the axis, rad/s.

    With a level axis, fast is infinite. Raise ValueError if the spin is too small for steady precession.
    """
    weight = _weight(mass, distance, axial, transverse, gravity)
    finite(tilt=tilt, spin=spin)
    level = 0.0 if abs(cos(tilt)) < LEVEL else transverse * cos(tilt)
    under = (axial * spin) ** 2 - 4 * level * weight
    if under < 0 or (spin == 0 and level == 0):
        raise ValueError(f"spin: {spin!r} rad/s is too slow, at a tilt of {tilt!r} rad there is no steady precession")
    larger = (axial * spin + copysign(sqrt(under), spin)) / 2  # of the two sums, the one without cancellation
    return weight / larger if larger else 0.0, larger / level if level else copysign(inf, larger)


def classic_precession(
    spin: float, *, mass: float, distance: float, axial: float, transverse: float, gravity: float
) -> float:
    """Return the precession, rad/s, as if the angular momentum were along the axis: m g d/(axial spin)."""
    weight = _weight(mass, distance, axial, transverse, gravity)
    finite(spin=spin)
    if spin == 0:
        raise ValueError("spin: must not be 0: what does not spin falls and does not precess")
    return weight / (axial * spin)


def sleeps(spin: float, *, mass: float, distance: float, axial: float, transverse: float, gravity: float) -> bool:
    """Return whether the top stands upright stably at this spin, rad/s: (axial spin)^2 > 4 transverse m g d."""
    weight = _weight(mass, distance, axial, transverse, gravity)
    finite(spin=spin)
    return (axial * spin) ** 2 > 4 * transverse * weight


def _weight(mass: float, distance: float, axial: float, transverse: float, gravity: float) -> float:
    """Return m g d, N m; check every parameter."""
    positive(mass=mass, distance=distance, axial=axial, transverse=transverse)
    finite(gravity=gravity)
    return mass * gravity * distance


film = drawn_for(top.film, globals())
