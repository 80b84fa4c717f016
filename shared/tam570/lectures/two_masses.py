"""5 Sept: Two masses on a line with a spring between them.

x1 and x2 along the line. The tension T = k (x2 - x1 - rest) pulls mass 1 forwards and mass 2 back: m1 x1'' = T,
m2 x2'' = -T. By their sum the centre of mass moves uniformly; by their difference the distance swings about the rest
length at sqrt(k/mu), 1/mu = 1/m1 + 1/m2. The masses may pass through each other: T stays linear.
"""

from collections.abc import Sequence
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, nonnegative, numbers, positive, positives, sequence
from tam570.integrate import solve
from tam570.show.drawing import coil
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import state_energy_plot, value_plot, values
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Parameters

STATE = {"x1": "m", "x2": "m", "v1": "m/s", "v2": "m/s"}
EXAMPLE: Parameters = {"masses": (1.0, 2.0), "stiffness": 6.0, "rest_length": 1.0}  # kg, N/m, m
START = (0.0, 1.6, 0.0, 0.6)
SECONDS = 8.0


def rates(
    t: float, state: Sequence[float], *, masses: Sequence[float], stiffness: float, rest_length: float
) -> tuple[float, ...]:
    """Return (4,) velocities, m/s, and accelerations, m/s^2."""
    m1, m2 = _checked(masses, stiffness, rest_length)
    sequence(4, state=state)
    x1, x2, v1, v2 = state
    pull = stiffness * (x2 - x1 - rest_length)  # N
    return v1, v2, pull / m1, -pull / m2


def tension(length: float, *, stiffness: float, rest_length: float) -> float:
    """Return the force of the spring, N, positive when it pulls."""
    finite(length=length)
    positive(stiffness=stiffness)
    nonnegative(rest_length=rest_length)
    return stiffness * (length - rest_length)


def spring_energy(length: float, *, stiffness: float, rest_length: float) -> float:
    """Return the work, J, that stretches the spring from its rest length: the integral of the tension."""
    return tension(length, stiffness=stiffness, rest_length=rest_length) * (length - rest_length) / 2


def exact(t: ArrayLike, state: ArrayLike, *, masses: Sequence[float], stiffness: float, rest_length: float) -> Array:
    """Return (n, 4) states at the times t (n,), s, of the motion that has `state` at t[0]."""
    m1, m2 = _checked(masses, stiffness, rest_length)
    times = numbers(t=t)
    x1, x2, v1, v2 = numbers(4, state=state)
    total, since = m1 + m2, times - times[:1]
    speed = (m1 * v1 + m2 * v2) / total
    centre = (m1 * x1 + m2 * x2) / total + speed * since
    w = sqrt(stiffness / m1 + stiffness / m2)  # rad/s
    stretch, stretching = x2 - x1 - rest_length, v2 - v1
    c, s = np.cos(w * since), np.sin(w * since)
    length = rest_length + stretch * c + stretching / w * s
    rate = stretching * c - stretch * w * s
    shares = np.array([-m2 / total, m1 / total])
    return np.hstack([centre[:, None] + np.outer(length, shares), speed + np.outer(rate, shares)])


def energy(state: Sequence[float], *, masses: Sequence[float], stiffness: float, rest_length: float) -> float:
    """Energy of both masses and the spring, J."""
    m1, m2 = _checked(masses, stiffness, rest_length)
    x1, x2, v1, v2 = map(float, numbers(4, state=state))
    spring = spring_energy(x2 - x1, stiffness=stiffness, rest_length=rest_length)
    return m1 * v1 * v1 / 2 + m2 * v2 * v2 / 2 + spring


def momentum(state: Sequence[float], *, masses: Sequence[float], stiffness: float, rest_length: float) -> float:
    """Linear momentum, kg m/s."""
    m1, m2 = _checked(masses, stiffness, rest_length)
    _, _, v1, v2 = map(float, numbers(4, state=state))
    return m1 * v1 + m2 * v2


INVARIANTS = {"energy": energy, "momentum": momentum}


def _checked(masses: Sequence[float], stiffness: float, rest_length: float) -> tuple[float, ...]:
    positive(stiffness=stiffness)
    nonnegative(rest_length=rest_length)
    return positives(2, masses=masses)


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the masses and of their centre of mass, which moves uniformly."""
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters)
    ends = np.array([states[:, :2].min() - 0.3, states[:, :2].max() + 0.3])
    ground = [Shape("lines", np.column_stack([ends, [-0.25, -0.25]]), GREY, width=1)]
    places = dict(zip(("mass 1", "mass 2", "centre of mass"), _places(states, parameters), strict=True))
    return Scene(
        "Two masses and a spring",
        "Two masses swing on a line at the ends of a spring. Their centre of mass, a bar across the line, moves on at "
        "one speed.",
        times,
        [Panel([*ground, *_draw(states, parameters)])],
        [
            value_plot("x", times, places, "m"),
            state_energy_plot(times, states, 2, lambda rows: values(energy, rows, **parameters)),
        ],
        live=Live(rates, parameters, start, _draw, [*map(_handle, (0, 1))], energies(energy, 2), backdrop=ground),
    )


def _places(states: Array, parameters: Parameters) -> tuple[Array, Array, Array]:
    """Return (n,) m, the positions of both masses and of their centre of mass."""
    (m1, m2), (x1, x2) = parameters["masses"], states[:, :2].T
    return x1, x2, (m1 * x1 + m2 * x2) / (m1 + m2)


def _draw(states: Array, parameters: Parameters) -> list[Shape]:
    first, second, middle = (np.column_stack([x, 0 * x]) for x in _places(states, parameters))
    return [
        Shape("path", coil(first, second, 0.08), GREY, "spring", width=2),
        Shape("dot", first[:, None], 0, "mass 1", width=10),
        Shape("dot", second[:, None], 1, "mass 2", width=10),
        Shape("lines", moving(middle - [0.0, 0.25], middle + [0.0, 0.25]), 2, "centre of mass", width=2),
    ]


def _handle(i: int) -> Handle:
    return Handle(
        lambda state, **parameters: [state[i], 0.0],
        lambda point, state, **parameters: [*state[:i], point[0], *state[i + 1 :]],
    )
