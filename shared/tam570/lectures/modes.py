"""21 Nov: Normal modes of small vibrations.

M q'' + K q = 0. With a Cholesky factor M = L L^T the shapes are L^-T times the orthonormal eigenvectors of the
symmetric L^-1 K L^-T, so shapes^T M shapes = 1 for equal frequencies too; the eigenvalues are the squares of the
frequencies, negative where the equilibrium is unstable (Greenwood, Principles of Dynamics, section 9-3).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, positive, symmetric, whole_number
from tam570.show.drawing import coil
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times
from tam570.values import Parameters

EXAMPLE = {"n": 4, "mass": 1.0, "stiffness": 40.0}  # kg, N/m
SECONDS, SWING = 10.0, 0.22  # s, m


def modes(mass: ArrayLike, stiffness: ArrayLike) -> tuple[Array, Array]:
    """Return squared frequencies (n,), rad^2/s^2, ascending, and shapes (n, n), columns with shape^T mass shape = 1.

    mass, stiffness : (n, n), symmetric, mass positive definite
    """
    M, K = symmetric((None, None), mass=mass), symmetric((None, None), stiffness=stiffness)
    if len(M) != len(K):
        raise ValueError(f"stiffness: must be of the shape {M.shape} of the mass, got {K.shape}")
    try:
        inverse = np.linalg.inv(np.linalg.cholesky(M))
    except np.linalg.LinAlgError:
        raise ValueError(f"mass: must be positive definite, got {M.tolist()}") from None
    reduced = inverse @ K @ inverse.T
    squares, vectors = np.linalg.eigh((reduced + reduced.T) / 2)
    return squares, inverse.T @ vectors


def chain(n: int, *, mass: float, stiffness: float) -> tuple[Array, Array]:
    """Return M and K (n, n), kg and N/m, of n masses in a line, with springs between neighbours and at both walls."""
    whole_number(1, n=n)
    positive(mass=mass, stiffness=stiffness)
    beside = np.eye(n, k=1)
    return mass * np.eye(n), stiffness * (2 * np.eye(n) - beside - beside.T)


def pendulum(*, mass: float, length: float, gravity: float) -> tuple[Array, Array]:
    """Return M and K (1, 1), kg m^2 and N m, of a pendulum that hangs; the coordinate is its angle."""
    positive(mass=mass, length=length)
    finite(gravity=gravity)
    return np.array([[mass * length**2]]), np.array([[mass * gravity * length]])


def inverted_pendulum(*, mass: float, length: float, gravity: float) -> tuple[Array, Array]:
    """Return M and K (1, 1), kg m^2 and N m, of an inverted pendulum."""
    M, K = pendulum(mass=mass, length=length, gravity=gravity)
    return M, -K


def saddle(*, mass: float, curvature: float, gravity: float) -> tuple[Array, Array]:
    """Return M and K (2, 2), kg and N/m, of a particle in the middle of z = curvature (x^2 - y^2)/2."""
    positive(mass=mass)
    finite(curvature=curvature, gravity=gravity)
    return mass * np.eye(2), mass * gravity * curvature * np.diag([1.0, -1.0])


def film(parameters: Parameters) -> Scene:
    """Return the scene of each mode alone, and of the first mass let go alone, which excites all modes."""
    times, (M, K) = frame_times(SECONDS), chain(**parameters)
    squares, shapes = modes(M, K)
    frequencies = np.sqrt(squares)
    n = len(squares)
    first = SWING * np.eye(n)[0]
    amounts = shapes.T @ M @ first
    waves = np.cos(np.outer(times, frequencies))
    rows = {
        f"{frequency:.3g} rad/s": waves[:, [j]] * shapes[:, j] * SWING / np.abs(shapes[:, j]).max()
        for j, frequency in enumerate(frequencies)
    }
    rows["all together"] = (waves * amounts) @ shapes.T
    drawn = [shape for j, (name, q) in enumerate(rows.items()) for shape in _chain(q, -0.6 * j, min(j, 5), name)]
    q, rate = rows["all together"], -np.sin(np.outer(times, frequencies)) * frequencies * amounts
    one_by_one = (rate**2 + squares * (q @ M @ shapes) ** 2) / 2
    curves = {f"mode {j + 1}": one_by_one[:, j] for j in range(n)}
    places = {f"mass {j + 1}": q[:, j] for j in range(n)}
    drift = drift_caption(curves, float(one_by_one[0].sum()), "all of it")
    return Scene(
        "Modes of a chain",
        f"{n} masses between springs vibrate in each normal mode, one row for a mode. All masses keep time, from one "
        "mode to the next ever faster. In the last row one mass alone was pulled aside, and all modes sound together.",
        times,
        [Panel(drawn)],
        [
            value_plot("last row: displacements", times, places, "m"),
            value_plot("last row: energy in each mode", times, curves, "J", *drift),
        ],
        still_time=0.02,
    )


def _chain(q: Array, height: float, color: int, name: str) -> list[Shape]:
    """Return masses a metre apart, displaced by q (k, n), m, with zigzag springs from wall to wall."""
    n = q.shape[1]
    x = np.column_stack([np.zeros(len(q)), q + np.arange(1, n + 1), np.full(len(q), n + 1.0)])
    line = np.stack([x, np.full(x.shape, height)], axis=-1)
    springs = [coil(line[:, i], line[:, i + 1], 0.07, turns=5) for i in range(n + 1)]
    places = np.stack([x[:, 1:-1], np.full(q.shape, height)], axis=-1)
    walls = np.array([[0.0, height - 0.2], [0.0, height + 0.2], [n + 1.0, height - 0.2], [n + 1.0, height + 0.2]])
    return [
        Shape("lines", walls, INK, width=3),
        *(Shape("path", spring, GREY, width=1.2) for spring in springs),
        Shape("dot", places, color, name, width=10),
    ]
