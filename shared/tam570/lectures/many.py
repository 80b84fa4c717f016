"""31 Aug, 5 Sept: Systems of particles, and what their centre of mass tells.

State: all positions, then all velocities, in space, of n particles. With G the centre of mass, T = m v_G^2/2 + the same
sum with velocities seen from G (Koenig), and H about a point P = (r_G - r_P) x m v_G + H about G. The forces come in
pairs. If they are opposite, they cancel in linear momentum balance; if they also act along the line between the two,
in angular momentum balance, too, and their power is that of the pairs' tensions as distances change. That they are
opposite and central is an assumption in addition to F = m a (Ruina's "rude" one; Goldstein, Classical Mechanics,
section 1.2, has both laws of action and reaction).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, numbers, positives
from tam570.integrate import solve
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Parameters

EXAMPLE: Parameters = {"masses": (3.0, 1.0, 2.0)}  # kg
TRIANGLE = ((0.2, -0.4), (1.4, -0.3), (0.7, 0.6))  # m, of the scene's particles; if not 3, they are on a circle
STIFFNESS, LENGTH, PUSH, SPIN = 20.0, 1.0, (-0.15, 0.3), 1.5  # N/m, m, m/s, rad/s, of the scene
SECONDS = 6.0


def kinetic(state: ArrayLike, *, masses: Sequence[float]) -> tuple[float, float]:
    """Return (of the centre of mass, about it) kinetic energy, J; state (6 n,), masses (n,)."""
    m, _, v = _particles(state, masses)
    v_G = m @ v / m.sum()
    return float(m.sum() * v_G @ v_G / 2), float(m @ ((v - v_G) ** 2).sum(axis=1) / 2)


def angular_momentum(state: ArrayLike, about: ArrayLike, *, masses: Sequence[float]) -> tuple[Array, Array]:
    """Return (of the centre of mass, about it), (3,) kg m^2/s each; the sum is that about the point `about` (3,), m."""
    m, r, v = _particles(state, masses)
    r_G, v_G = m @ r / m.sum(), m @ v / m.sum()
    orbital = np.cross(r_G - numbers(3, about=about), m.sum() * v_G)
    return orbital, m @ np.cross(r - r_G, v - v_G)


def balances(state: ArrayLike, forces: ArrayLike, *, masses: Sequence[float]) -> tuple[Array, Array, float]:
    """Return residuals of the system's balances if each particle moves by F = m a and nothing acts from outside.

    state  : (6 n,)
    forces : (n, n, 3) N, [i, j] on particle i by particle j; the diagonal must be 0
    masses : (n,) kg
    Returns the rates of linear momentum (3,), N, and of angular momentum about the origin (3,), N m, both of which
    should be 0; and that of the kinetic energy, W, less the power of the tensions as the distances change.
    """
    m, r, v = _particles(state, masses)
    pairs = array((len(m), len(m), 3), forces=forces)
    if np.einsum("iik->ik", pairs).any():
        raise ValueError("forces: no particle acts on itself, the diagonal must be 0")
    on_each = pairs.sum(axis=1)
    apart, parting = r[:, None] - r, v[:, None] - v
    distance = np.linalg.norm(apart, axis=2)
    along = apart / np.where(distance, distance, 1.0)[..., None]
    central = np.einsum("ijk,ijk->ij", pairs, along) * np.einsum("ijk,ijk->ij", parting, along)
    power = central.sum() / 2  # each pair is there twice
    return on_each.sum(axis=0), np.cross(r, on_each).sum(axis=0), float((on_each * v).sum() - power)


def _particles(state: ArrayLike, masses: Sequence[float]) -> tuple[Array, Array, Array]:
    """Return masses (n,), positions and velocities (n, 3); check every argument."""
    m = np.array(positives(masses=masses))
    r, v = numbers(6 * len(m), state=state).reshape(2, -1, 3)
    return m, r, v


def _springs(r: Array) -> Array:
    """Return (n, n, 3) N, the forces of springs between all pairs of particles."""
    apart = r[:, None] - r
    distance = np.linalg.norm(apart, axis=2, keepdims=True) + np.eye(len(r))[..., None]
    return -STIFFNESS * (1 - LENGTH / distance) * apart


def film(parameters: Parameters) -> Scene:
    """Return the scene of particles, joined by springs and thrown, whose centre of mass goes straight on."""
    masses = positives(masses=parameters["masses"])
    n, m = len(masses), np.array(masses)

    def rates(t: float, state: Array) -> Array:
        r, v = np.reshape(state, (2, n, 3))
        return np.concatenate([v, _springs(r).sum(axis=1) / m[:, None]]).ravel()

    angles = 2 * np.pi * np.arange(n) / n
    circle = 0.7 * np.column_stack([np.cos(angles), np.sin(angles)])
    r = np.column_stack([TRIANGLE if n == len(TRIANGLE) else circle, np.zeros(n)])
    v = [*PUSH, 0.0] + SPIN * np.cross([0.0, 0.0, 1.0], r - m @ r / m.sum())
    times = frame_times(SECONDS)
    states = solve(rates, times, np.concatenate([r, v]).ravel(), rtol=1e-9)
    places = states[:, : 3 * n].reshape(-1, n, 3)[..., :2]
    of_G, about_G = values(kinetic, states, masses=masses).T
    origin = np.array([angular_momentum(state, np.zeros(3), masses=masses) for state in states])[..., 2]
    momenta = {"of G": origin[:, 0], "about G": origin[:, 1], "about the origin": origin.sum(axis=1)}
    scale = float(np.abs(momenta["about the origin"]).max())
    drift = drift_caption(momenta["about the origin"], scale)
    return Scene(
        "Particles and their centre of mass",
        f"{n} particles joined by springs are thrown across a table. They turn and swing about their centre of mass, "
        "which goes straight on at one speed. Its kinetic energy stays; that about it goes into the springs and back.",
        times,
        [Panel(_drawn(places, m))],
        [
            value_plot("kinetic energy", times, {"of G": of_G, "about G": about_G}, "J"),
            value_plot("angular momentum", times, momenta, "kg m²/s", *drift),
        ],
        still_time=0.3,
    )


def _drawn(places: Array, masses: Array) -> list[Shape]:
    n = len(masses)
    pairs = [(i, j) for i in range(n) for j in range(i)]
    G = np.einsum("i,nik->nk", masses, places) / masses.sum()
    sizes = 6 + 5 * np.sqrt(masses / masses.max())
    springs = [Shape("lines", moving(places[:, i], places[:, j]), GREY, "springs", width=1.5) for i, j in pairs]
    dots = [Shape("dot", places[:, [i]], 0, "particles", width=float(sizes[i])) for i in range(n)]
    trails = [Shape("trail", places[:, [i]], 0, width=1, faint=True) for i in range(n)]
    return [
        *trails,
        *springs,
        *dots,
        Shape("trail", G[:, None], 1, width=2),
        Shape("dot", G[:, None], 1, "centre of mass G", width=5),
        Shape("dot", np.zeros((1, 2)), INK, "origin", width=3),
    ]
