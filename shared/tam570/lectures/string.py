"""24 Oct: Two particles on one string, one on a table, the other below a hole in it.

r is the distance from the hole on the frictionless table, th the angle there. Newton, with the tension T:
m1 (r'' - r om^2) = -T,  m1 (r th'' + 2 vr om) = 0,  m2 r'' = T - m2 g, as the string does not stretch.
Lagrange: L = (m1 + m2) vr^2/2 + m1 r^2 om^2/2 - m2 g r, and no tension anywhere.
"""

from collections.abc import Sequence
from math import nan

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, numbers, positive, positives, sequence
from tam570.integrate import solve
from tam570.show.drawing import solid, unit_circle
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import drift_caption, state_energy_plot, value_plot, values
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Numbers, Parameters

STATE = {"r": "m", "th": "rad", "vr": "m/s", "om": "rad/s"}
EXAMPLE = {"masses": (1.0, 1.5), "gravity": 9.81}  # kg, on the table and below it; m/s^2
START = (0.6, 0.0, 0.0, 3.0)
SECONDS = 10.0


def rates(t: float, state: Sequence[float], *, masses: Sequence[float], gravity: float) -> tuple[float, ...]:
    """Return (4,) rates of r, th, vr, om."""
    pair, (r, _, vr, om) = _checked(state, masses, gravity)
    try:
        return vr, om, *_accelerations(r, vr, om, pair, gravity)
    except ZeroDivisionError:  # in the hole, where a trial step may end
        return vr, om, nan, nan


def by_newton(state: Sequence[float], *, masses: Sequence[float], gravity: float) -> tuple[tuple[float, float], float]:
    """Return accelerations r'', m/s^2, and th'', rad/s^2, and the tension, N, from three balances solved together."""
    (m1, m2), (r, _, vr, om) = _on_the_table(state, masses, gravity)
    balances = np.array([[m1, 0.0, 1.0], [0.0, m1 * r, 0.0], [m2, 0.0, -1.0]])
    r_rate, th_rate, tension = np.linalg.solve(balances, [m1 * r * om**2, -2 * m1 * vr * om, -m2 * gravity]).tolist()
    return (r_rate, th_rate), tension


def by_lagrange(state: Sequence[float], *, masses: Sequence[float], gravity: float) -> tuple[float, float]:
    """Return accelerations r'', m/s^2, and th'', rad/s^2: each equation has only one of them."""
    pair, (r, _, vr, om) = _on_the_table(state, masses, gravity)
    return _accelerations(r, vr, om, pair, gravity)


def _accelerations(r: float, vr: float, om: float, pair: Sequence[float], gravity: float) -> tuple[float, float]:
    m1, m2 = pair
    return (m1 * r * om * om - m2 * gravity) / (m1 + m2), -2 * m1 * r * vr * om / (m1 * r * r)


def energy(state: ArrayLike, *, masses: Sequence[float], gravity: float) -> float:
    """Energy, J; the potential energy of the hanging mass is 0 for r = 0."""
    (m1, m2), (r, _, vr, om) = _checked(numbers(4, state=state).tolist(), masses, gravity)
    return (m1 + m2) * vr**2 / 2 + m1 * (r * om) ** 2 / 2 + m2 * gravity * r


def angular_momentum(state: ArrayLike, *, masses: Sequence[float], gravity: float) -> float:
    """Angular momentum about the hole, kg m^2/s."""
    (m1, _), (r, _, _, om) = _on_the_table(numbers(4, state=state).tolist(), masses, gravity)
    return m1 * r**2 * om


INVARIANTS = {"energy": energy, "angular_momentum": angular_momentum}


def _checked(
    state: Sequence[float], masses: Sequence[float], gravity: float
) -> tuple[tuple[float, ...], Sequence[float]]:
    pair = positives(2, masses=masses)
    finite(gravity=gravity)
    sequence(4, state=state)
    return pair, state


def _on_the_table(
    state: Sequence[float], masses: Sequence[float], gravity: float
) -> tuple[tuple[float, ...], Sequence[float]]:
    checked = _checked(state, masses, gravity)
    if not state[0] > 0:
        raise ValueError(f"state: r must be positive, got {state[0]!r}: the mass would be in the hole")
    return checked


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the table, and of the mass that hangs below it."""
    positive(**{"start.r": start[0]})
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters)
    farthest = float(states[:, 0].max())
    edge = np.column_stack([1.1 * farthest * unit_circle(61), np.zeros(61)])
    table = solid(edge, GREY, "table")

    def drawing(states: Array, parameters: Parameters) -> list[Shape]:
        above = np.column_stack(_on_table(states.T))
        below = np.column_stack([0 * above[:, :2], states[:, 0] - 2.2 * farthest])
        return [
            Shape("trail", above[:, None], 2, "path", width=1.5),
            Shape("lines", moving(above, np.zeros(3), np.zeros(3), below), INK, "string", width=2),
            Shape("dot", above[:, None], 0, "mass on the table", width=10),
            Shape("dot", below[:, None], 1, "mass below", width=12),
        ]

    turning = values(angular_momentum, states, **parameters)
    drift = drift_caption(turning, about="angular momentum: ")
    return Scene(
        "Two particles on a string",
        "A mass circles on a table. The string through the hole holds a second mass below the table. The circle's "
        "radius swings in and out, and the mass below goes down and up with it.",
        times,
        [Panel([*table, *drawing(states, parameters)])],
        [
            state_energy_plot(times, states, 2, lambda rows: values(energy, rows, **parameters)),
            value_plot("distance from the hole", times, {"": states[:, 0]}, "m", *drift),
        ],
        view=(0.6, 0.25),
        still_time=0.35,
        live=Live(rates, parameters, start, drawing, [HANDLE], energies(energy, 2), backdrop=table),
    )


def _on_table(state: Numbers, **parameters: Numbers) -> list[Numbers]:
    return [state[0] * np.cos(state[1]), state[0] * np.sin(state[1]), 0.0 * state[0]]


HANDLE = Handle(
    _on_table,
    lambda point, state, **parameters: [np.hypot(point[0], point[1]), np.arctan2(point[1], point[0]), *state[2:]],
)
