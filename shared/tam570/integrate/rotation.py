"""Rotations that stay orthogonal: Runge-Kutta steps for the rotation vector in each step (Munthe-Kaas).

R' = R hat(omega). Within a step R = R0 exp(u) with small u; u' is omega plus a Bernoulli series in u. After the step
R0 is multiplied by exp(u) and u is reset to zero, so R^T R = I up to round-off for any length of the run.
Munthe-Kaas, High order Runge-Kutta methods on manifolds, Appl. Num. Math. 29 (1999).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import adaptive
from tam570.integrate.arguments import Array, of_one_step, sample_times, tolerance
from tam570.integrate.engine import Mistraced, engine
from tam570.integrate.rates import RhsError
from tam570.values import Function, Numbers, Parameters

# |B_2n| / (2n)! for n = 1, 2, ...; for 1 rad per step the first omitted term, |B_20| / 20!, is 2.2e-16 of omega.
_BERNOULLI = (
    1 / 12,
    1 / 720,
    1 / 30240,
    1 / 1209600,
    1 / 47900160,
    691 / 1307674368000,
    1 / 74724249600,
    3617 / 10670622842880000,
    43867 / 5109094217170944000,
)

ORTHOGONAL = 1e-6  # error of R^T R, up to which R is a rotation whose numbers were rounded


def solve_rotation(
    acceleration: Function,
    t: ArrayLike,
    omega: ArrayLike,
    R: ArrayLike,
    *,
    parameters: Parameters | None = None,
    rtol: float = 1e-10,
) -> tuple[Array, Array]:
    """Return angular velocities and rotations of a body with R' = R hat(omega), at the times `t`.

    Parameters
    ----------
    acceleration : callable
        `acceleration(t, omega, **parameters)` returns omega', both (3,) in body axes.
    t : (n,) array_like
        Strictly increasing or decreasing.
    omega : (3,) array_like
        At t[0], in body axes, rad/s.
    R : (3, 3) array_like
        At t[0], body to space.
    parameters : mapping, optional
        Keyword arguments of acceleration.
    rtol : float
        As in `solve`.

    Returns
    -------
    omegas : (n, 3) ndarray
    rotations : (n, 3, 3) ndarray
        R^T R is the identity up to round-off, for any length of the run.

    Raises
    ------
    ValueError
        If an argument has another shape or is not finite, t is not monotonic, R is no rotation, or rtol is not between
        0 and 1.
    ArithmeticError
        If acceleration or solution is no longer finite; the message gives the time.

    Examples
    --------
    >>> omegas, rotations = solve_rotation(lambda t, omega: (0.0, 0.0, 0.0), [0.0, np.pi], [0.0, 0.0, 1.0], np.eye(3))
    >>> np.diag(rotations[-1]).round(9)
    array([-1., -1.,  1.])
    """
    fixed = dict(parameters or {})
    spinning, turned = np.array(omega, dtype=float), np.array(R, dtype=float)
    for name, numbers, shape in (("omega", spinning, (3,)), ("R", turned, (3, 3))):
        if numbers.shape != shape or not np.isfinite(numbers).all():
            raise ValueError(f"{name}: need finite numbers of shape {shape}, got {numbers}")
    if not (np.abs(turned.T @ turned - np.eye(3)).max() < ORTHOGONAL and np.linalg.det(turned) > 0):
        raise ValueError(
            f"R: must be a rotation, R^T R = I with determinant 1, got {turned}; try tam570.rotations.nearest(R)"
        )

    def rates(time: Numbers, state: Numbers) -> list[Numbers]:
        spin, u = state[:3], state[3:6]
        return [*acceleration(time, spin, **fixed), *_vector_rate(u, spin), *[0.0] * 9]

    def one_radian(state: Array) -> float:  # s; up to this step the series is accurate to round-off
        return float(1 / max(np.abs(state[:3]).sum(), 1e-300))

    start = np.concatenate([spinning, np.zeros(3), turned.ravel()])
    (times, sign), tolerated = sample_times(t), of_one_step(tolerance(rtol))
    control = adaptive.Control(tolerated, project=_recentred, longest=one_radian)

    def run(*, may_trace: bool) -> Array:
        run_engine = engine(rates, None, times, start, sign=sign, may_trace=may_trace)
        return adaptive.integrate(run_engine, times, start, "python", control).rows

    try:
        states = run(may_trace=True)
    except Mistraced:
        states = run(may_trace=False)
    except RhsError as error:
        raise ValueError(str(error).replace("rhs", "acceleration", 1)) from None
    rotations = states[:, 6:].reshape(-1, 3, 3)
    rotations[0] = turned
    return states[:, :3], rotations


def _vector_rate(u: Numbers, omega: Numbers) -> list[Numbers]:
    """Return u' for R0 exp(u): omega + u x omega / 2 + (sum of |B_2n| / (2n)! |u|^(2n - 2)) u x (u x omega)."""
    once = _cross(u, omega)
    twice = _cross(u, once)
    square, series = u[0] * u[0] + u[1] * u[1] + u[2] * u[2], 0.0
    for term in reversed(_BERNOULLI):
        series = series * square + term
    return [w + 0.5 * a + series * b for w, a, b in zip(omega, once, twice, strict=True)]


def _cross(a: Numbers, b: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _recentred(state: Array) -> Array:
    """Return the state with R0 exp(u) as R0 and zero as u; a Newton step prevents drift of R0 by round-off."""
    u, R = state[3:6], state[6:].reshape(3, 3)
    angle = np.sqrt(u @ u)
    hat = np.array([[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]])
    half = np.sinc(angle / (2 * np.pi))  # sin(angle / 2) / (angle / 2)
    R = R @ (np.eye(3) + np.sinc(angle / np.pi) * hat + 0.5 * half * half * (hat @ hat))
    R = 1.5 * R - 0.5 * R @ (R.T @ R)
    return np.concatenate([state[:3], np.zeros(3), R.ravel()])
