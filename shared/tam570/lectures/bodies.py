"""5 Sept: n bodies that attract each other, as in the solar system.

Positions and velocities in space. m_i r_i'' = sum over j of G m_i m_j (r_j - r_i)/|r_j - r_i|^3. The example is the
figure of eight of Chenciner and Montgomery (Annals of Mathematics 152, 2000), start by Simo: three equal bodies chase
each other on one curve, once round in 6.32591398 s.
"""

from collections.abc import Sequence
from math import inf, nan, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import divisors, nonnegative, numbers, positives, sequence
from tam570.integrate import solve
from tam570.show.live import Live, drag, energies
from tam570.show.plots import state_energy_plot, values
from tam570.show.scene import Array, Panel, Scene, Shape, drawable_rate, frame_times
from tam570.values import Parameters

STATE = {f"{part}{axis}{i}": unit for part, unit in (("", "m"), ("v", "m/s")) for i in (1, 2, 3) for axis in "xyz"}
EXAMPLE: Parameters = {"masses": (1.0, 1.0, 1.0), "newton": 1.0}  # kg, m^3/(kg s^2)
X, Y, VX, VY = 0.97000436, -0.24308753, 0.466203685, 0.43236573  # m, m, m/s, m/s
START = (X, Y, 0.0, -X, -Y, 0.0, 0.0, 0.0, 0.0, VX, VY, 0.0, VX, VY, 0.0, -2 * VX, -2 * VY, 0.0)
SECONDS = 12.65182796
MANY = 10  # bodies, from which arrays are faster than loops


def rates(t: float, state: Sequence[float], *, masses: Sequence[float], newton: float) -> Sequence[float]:
    """Return (6 n,) all velocities, m/s, then all accelerations, m/s^2.

    masses : (n,) kg
    newton : the constant of gravitation, m^3/(kg s^2)
    """
    each = _checked(masses, newton)
    n = len(each)
    sequence(6 * n, state=state)
    try:
        accelerations = (_by_arrays if n >= MANY else _by_pairs)(state[: 3 * n], each, newton)
    except ZeroDivisionError:  # two bodies at the same place, where a trial step may end
        accelerations = [nan] * (3 * n)
    return (*state[3 * n :], *accelerations)


def _by_pairs(places: Sequence[float], masses: Sequence[float], newton: float) -> list[float]:
    pulls = [0.0] * len(places)
    for i in range(len(masses)):
        for j in range(i):
            gap = [places[3 * j + axis] - places[3 * i + axis] for axis in range(3)]
            square = gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2]
            factor = newton / (square * sqrt(square))
            for axis in range(3):
                pulls[3 * i + axis] += factor * masses[j] * gap[axis]
                pulls[3 * j + axis] -= factor * masses[i] * gap[axis]
    return pulls


def _by_arrays(places: Sequence[float], masses: Sequence[float], newton: float) -> list[float]:
    r = np.reshape(places, (-1, 3))
    gaps = r - r[:, None]  # from i, the first index, to j
    squares = (gaps * gaps).sum(axis=-1) + np.eye(len(r))  # no body pulls itself: its gap is 0
    divisors(squares)
    factors = newton * np.asarray(masses) / (squares * np.sqrt(squares))
    return (factors[:, :, None] * gaps).sum(axis=1).ravel().tolist()


def energy(state: ArrayLike, *, masses: Sequence[float], newton: float) -> float:
    """Energy, J: kinetic, and potential of all pairs."""
    m, r, v = _parts(state, masses, newton)
    first, second = np.triu_indices(len(m), 1)
    distances = np.sqrt(((r[first] - r[second]) ** 2).sum(axis=1))
    return float(m @ (v * v).sum(axis=1) / 2 - newton * (m[first] * m[second] / distances).sum())


def momentum(state: ArrayLike, *, masses: Sequence[float], newton: float) -> Array:
    """Linear momentum, (3,) kg m/s."""
    m, _, v = _parts(state, masses, newton)
    return m @ v


def angular_momentum(state: ArrayLike, *, masses: Sequence[float], newton: float) -> Array:
    """Angular momentum about the origin, (3,) kg m^2/s."""
    m, r, v = _parts(state, masses, newton)
    return m @ np.cross(r, v)


INVARIANTS = {"energy": energy, "momentum": momentum, "angular_momentum": angular_momentum}


def _checked(masses: Sequence[float], newton: float) -> tuple[float, ...]:
    nonnegative(newton=newton)
    return positives(masses=masses)


def _parts(state: ArrayLike, masses: Sequence[float], newton: float) -> tuple[Array, Array, Array]:
    """Return (n,) masses, (n, 3) positions, (n, 3) velocities."""
    m = np.array(_checked(masses, newton))
    r, v = numbers(6 * len(m), state=state).reshape(2, -1, 3)
    return m, r, v


def _fastest(start: ArrayLike, *, masses: Sequence[float], newton: float) -> float:
    """Return the rate, rad/s, at which the two nearest bodies would circle each other if they had the mass of all."""
    m, r, _ = _parts(start, masses, newton)
    first, second = np.triu_indices(len(m), 1)
    nearest = float(((r[first] - r[second]) ** 2).sum(axis=1).min(initial=inf))  # m^2
    return sqrt(newton * m.sum() / nearest**1.5) if nearest else inf


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of all bodies with their paths."""
    drawable_rate("masses and newton at this start", _fastest(start, **parameters))
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters)
    n = len(start) // 6
    dim = 3 if states[:, 2 : 3 * n : 3].any() else 2

    def drawing(states: Array, parameters: Parameters) -> list[Shape]:
        places = np.reshape(states[:, : 3 * n], (-1, n, 3))[..., :dim]
        trails = [Shape("trail", places[:, [i]], i % 6, width=2) for i in range(n)]
        return [*trails, *(Shape("dot", places[:, [i]], i % 6, f"body {i + 1}", width=8) for i in range(n))]

    handles = [drag(3 * i, dim) for i in range(n)]
    return Scene(
        f"{n} bodies",
        "Bodies attract each other and move on paths that bend around each other. In the example three equal bodies "
        "chase each other on one curve in the shape of an eight.",
        times,
        [Panel(drawing(states, parameters))],
        [state_energy_plot(times, states, 3 * n, lambda rows: values(energy, rows, **parameters))],
        still_time=0.2,
        live=Live(rates, parameters, start, drawing, handles, energies(energy, 3 * n)),
    )
