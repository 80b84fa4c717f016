"""14 Sept: A uniform bar that swings about a hinge at its end.

The angle is measured from straight down, positive to the right. About the hinge the moment of inertia is m l^2/3 and
the weight's moment -m g (l/2) sin th, so th'' = -(3 g/(2 l)) sin th. The hinge's force follows from F = m a of the
centre of mass G: along the bar (from G to the hinge) m (om^2 l/2 + g cos th), across it (towards growing th)
m (th'' l/2 + g sin th) = (m g/4) sin th. From rest, sin(th/2) = sin(th0/2) cd(w t) with w^2 = 3 g/(2 l) and Jacobi's
cd of the modulus sin(th0/2) (Whittaker, Analytical Dynamics, section 44).
"""

from collections.abc import Mapping, Sequence
from math import cos, pi, sin, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, positive, sequence
from tam570.integrate import solve
from tam570.show.drawing import unit_circle
from tam570.show.live import Live, energies
from tam570.show.plots import state_energy_plot, values
from tam570.show.rods import joints, rod_handles
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, arrow, frame_times, moving

STATE = {"th": "rad", "om": "rad/s"}
EXAMPLE = {"mass": 2.0, "length": 1.0, "gravity": 9.81}  # kg, m, m/s^2
START = (2.5, 0.0)
SECONDS = 10.0


def rates(t: float, state: Sequence[float], *, mass: float, length: float, gravity: float) -> tuple[float, ...]:
    """Return (2,) om, rad/s, and om', rad/s^2."""
    positive(mass=mass, length=length, gravity=gravity)
    sequence(2, state=state)
    th, om = state
    return om, -1.5 * gravity / length * sin(th)


def hinge_force(state: Sequence[float], *, mass: float, length: float, gravity: float) -> tuple[float, float]:
    """Return (along, across), N, the hinge's force on the bar: along from G to the hinge, across towards growing th."""
    positive(mass=mass, length=length, gravity=gravity)
    th, om = map(float, numbers(2, state=state))
    return mass * (om * om * length / 2 + gravity * cos(th)), mass * gravity / 4 * sin(th)


def energy(state: Sequence[float], *, mass: float, length: float, gravity: float) -> float:
    """Energy, J; 0 when the bar hangs straight down at rest."""
    positive(mass=mass, length=length, gravity=gravity)
    th, om = map(float, numbers(2, state=state))
    return mass * length * (length * om * om / 6 + gravity * sin(th / 2) ** 2)


INVARIANTS = {"energy": energy}


def exact(t: ArrayLike, state: ArrayLike, *, mass: float, length: float, gravity: float) -> Array:
    """Return (n, 2) states at the times t (n,), s, of the bar let go at rest: `state` is (th0, 0) at t[0].

    Raise ValueError for a start that moves.
    """
    positive(mass=mass, length=length, gravity=gravity)
    times, (th, om) = numbers(t=t), numbers(2, state=state)
    if om:
        raise ValueError(f"state: the exact motion begins at rest, got om = {om:g}")
    turns = 2 * pi * round(th / (2 * pi))
    modulus, other = sin((th - turns) / 2), cos((th - turns) / 2)
    w = sqrt(1.5 * gravity / length)  # rad/s
    sn, cn = _jacobi(w * (times - times[:1]), modulus, other)
    dn = np.hypot(other, modulus * cn)  # sqrt(1 - modulus^2 sn^2) would lose digits near the top
    angle = 2 * np.arctan2(modulus * cn, np.full_like(cn, other))
    return np.column_stack([turns + angle, -2 * modulus * other * w * sn / dn])


def _jacobi(u: Array, modulus: float, other: float) -> tuple[Array, Array]:
    """Return sn and cn by the arithmetic-geometric mean (Abramowitz and Stegun 16.4), `other` = sqrt(1 - modulus^2).

    SciPy's function takes the square of the modulus, which loses too many digits for a bar that starts near the top.
    """
    means, gaps, b = [1.0], [abs(modulus)], other
    while gaps[-1] > 1e-8 * means[-1]:  # the next would be a quarter of its square
        a = means[-1]
        means.append((a + b) / 2)
        gaps.append((a - b) / 2)
        b = sqrt(a * b)
    phase = 2.0 ** (len(means) - 1) * means[-1] * u
    for a, gap in zip(means[:0:-1], gaps[:0:-1], strict=True):
        phase = (phase + np.arcsin(gap / a * np.sin(phase))) / 2
    return np.sin(phase), np.cos(phase)


def film(parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the bar and the force of its hinge."""
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters, rtol=1e-8)
    length = parameters["length"]
    c, s = np.cos(states[:, 0]), np.sin(states[:, 0])
    down, aside = np.column_stack([s, -c]), np.column_stack([c, s])
    forces = np.array([hinge_force(state, **parameters) for state in states])
    force = forces[:, :1] * -down + forces[:, 1:] * aside
    hinge = 0.25 * length / (parameters["mass"] * parameters["gravity"]) * force
    G, weight = length / 2 * down, np.array([0.0, -0.25 * length])
    shapes = [
        *_draw(states, parameters),
        arrow(G, weight, 3, "weight", 3),
        arrow(G + weight, hinge, 1, "force of the hinge", 3),
        arrow(G, weight + hinge, 4, "sum: m a of G", 3),
    ]
    handles = rod_handles(1, lambda parameters: [parameters["length"]])
    return Scene(
        "Swinging bar",
        "A bar swings about a hinge at its end. Arrows at its centre of mass G show the weight and the force of the "
        "hinge, one after the other, and their sum, m a of G: the polygon closes.",
        times,
        [Panel(shapes)],
        [state_energy_plot(times, states, 1, lambda rows: values(energy, rows, **parameters))],
        still_time=0.06,
        live=Live(rates, parameters, start, _draw, handles, energies(energy, 1)),
    )


def _draw(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
    length = parameters["length"]
    (tip,) = joints(states[:, :1].T, [length])
    return [
        Shape("path", length * unit_circle(61), GREY, width=1, faint=True),
        Shape("lines", moving(np.zeros(2), tip), 0, "bar", width=7),
        Shape("dot", (tip / 2)[:, None], 2, "G", width=5),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]
