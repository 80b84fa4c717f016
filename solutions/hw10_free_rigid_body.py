"""hw10: Free motion of a rigid body.

figure.svg, beside this file, shows the axes, the names and the positive senses.

inertia (3,) holds A, B, C, the principal moments of inertia about the centre of mass (kg m^2); omega (3,) is the
angular velocity in rad/s, in components along the body's principal axes; R (3, 3) takes body to space components. No
moment acts. Axes 0, 1, 2 are those of A, B, C.

Off limits in this file: tam570.lectures, and in `euler_rates_313` tam570.rotations and scipy.spatial.transform, which
would answer it.
"""

import math

import numpy as np

__all__ = [
    "angular_momentum",
    "attitude_rate",
    "energy",
    "euler_equations",
    "euler_rates_313",
    "growth_rate_squared",
    "plot_rim_paths",
    "simulate",
    "symmetric_solution",
    "tumble_period",
    "wireframe",
    "wobble_rate",
]


def euler_equations(omega, *, inertia):
    """Rate of change of omega, in body components.

    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns (3,) rad/s^2.
    """
    p, q, r = omega
    A, B, C = inertia
    return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q


def attitude_rate(R, omega):
    """Rate of change of R.

    R     : (3, 3), body to space
    omega : (3,) rad/s, body components
    Returns (3, 3) 1/s.
    """
    p, q, r = omega
    return np.asarray(R) @ np.array([[0.0, -r, q], [r, 0.0, -p], [-q, p, 0.0]])


def euler_rates_313(angles, omega):
    """Rates of the Euler angles of R = Rz(psi) Rx(theta) Rz(phi).

    angles : (psi, theta, phi) rad
    omega  : (3,) rad/s, body components
    Returns (3,) rad/s, the rates of psi, theta, phi.
    Raises ValueError where abs(sin theta) < 1e-12.
    """
    _, theta, phi = angles
    p, q, r = omega
    s = math.sin(theta)
    if abs(s) < 1e-12:
        raise ValueError("psi and phi turn about the same line where sin theta is 0; their rates are not determined")
    psi_rate = (p * math.sin(phi) + q * math.cos(phi)) / s
    theta_rate = p * math.cos(phi) - q * math.sin(phi)
    return np.array([psi_rate, theta_rate, r - psi_rate * math.cos(theta)])


def energy(omega, *, inertia):
    """Kinetic energy of rotation.

    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns J.
    """
    A, B, C = inertia
    p, q, r = omega
    return (A * p**2 + B * q**2 + C * r**2) / 2


def angular_momentum(R, omega, *, inertia):
    """Angular momentum about the centre of mass, in space components.

    R       : (3, 3), body to space
    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns (3,) kg m^2/s.
    """
    return np.asarray(R) @ np.multiply(inertia, omega)


def simulate(t, R, omega, *, inertia):
    """Angular velocities and attitudes at the times `t`; rows 0 are those given.

    t       : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    R       : (3, 3), body to space, at t[0]
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, B, C) kg m^2
    Returns (omegas (n, 3), rotations (n, 3, 3)).
    """
    from tam570.integrate import solve

    # The attitude as a quaternion: brought to unit length at the end, it is a rotation. It starts where all four
    # numbers are alike: the solver keeps each error small beside the number itself, even if that is all rounding.
    states = solve(_rates, t, [*omega, 0.5, 0.5, 0.5, 0.5], parameters={"inertia": tuple(inertia)}, rtol=TOLERANCE)
    turned = _matrices(states[:, 3:])
    return states[:, :3], np.asarray(R) @ turned[0].T @ turned


def symmetric_solution(t, omega, *, inertia):
    """(a) omega in body components at the times `t`, in closed form, of a body with A = B.

    t       : (n,) s
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, A, C) kg m^2
    Returns (n, 3) rad/s.
    """
    p, q, r = omega
    A, _, C = inertia
    turned = (C - A) / A * r * (np.asarray(t) - t[0])
    c, s = np.cos(turned), np.sin(turned)
    return np.column_stack([p * c - q * s, q * c + p * s, np.full(len(turned), r)])


def wobble_rate(omega, *, inertia):
    """(a) Rate at which the symmetry axis goes round the angular momentum, of a body with A = B.

    omega   : (3,) rad/s, body components, not all zero
    inertia : (A, A, C) kg m^2
    Returns rad/s, positive.
    """
    # omega = H/A plus a part along the symmetry axis, which does not move that axis.
    return math.hypot(*np.multiply(inertia, omega)) / inertia[0]


def growth_rate_squared(axis, spin, *, inertia):
    """(b) Square of the rate at which a small deviation from spin about a principal axis grows.

    axis    : 0, 1 or 2, the axis of A, B or C
    spin    : rad/s about it
    inertia : (A, B, C) kg m^2
    Returns 1/s^2: positive where the spin is unstable; -(frequency^2) in (rad/s)^2 where it is stable.
    """
    about, next_one, last = (inertia[(axis + k) % 3] for k in range(3))
    return (last - about) / next_one * ((about - next_one) / last) * spin**2


def tumble_period(omega, *, inertia):
    """(b) Period of omega in body components, A < B < C.

    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns s; math.inf on the separatrix; for pure spin about axis 0 or 2 the limit of small oscillations.
    """
    # 4 K(k) over a rate (Landau and Lifshitz, Mechanics, paragraph 37), with K = pi / (2 agm(1, k')): Gauss's mean
    # takes the complementary modulus k', which keeps its digits next to the separatrix.
    A, B, C = inertia
    p, q, r = map(abs, omega)
    # Axis 0 or 2, whichever omega goes round; on the separatrix the two squares are equal, and no root is taken first.
    round_0, round_2 = A * (B - A) * p * p, C * (C - B) * r * r
    fast = math.sqrt(B * (B - A) * (C - B)) * q
    larger = math.hypot(fast, math.sqrt((C - A) * max(round_0, round_2)))
    smaller = math.sqrt((C - A) * abs(round_2 - round_0))
    if smaller == 0.0:
        return math.inf
    return 2.0 * math.pi * math.sqrt(A * B * C) / _agm(larger, smaller)


def wireframe(R, *, size):
    """Edges of a box that is centred on the origin, turned by R.

    R    : (3, 3), body to space
    size : (3,) m, lengths along the body's axes
    Returns (12, 2, 3) m: segment i runs from [i, 0] to [i, 1].
    """
    half = 0.5 * np.asarray(size, dtype=float)
    signs = np.array([[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]])
    edges = np.empty((3, 4, 2, 3))
    for k in range(3):
        edges[k, :, :, (k + 1) % 3] = signs[:, :1]
        edges[k, :, :, (k + 2) % 3] = signs[:, 1:]
        edges[k, :, :, k] = [-1.0, 1.0]
    return (edges.reshape(12, 2, 3) * half) @ np.asarray(R).T


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    """(a) Draw the paths of the body points (radius, 0, 0) and (0, radius, 0), seen along space x.

    ax      : Matplotlib Axes to draw on: y to the right, z up
    t       : (n,) s, strictly increasing
    R       : (3, 3), body to space, at t[0]
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, B, C) kg m^2
    radius  : m
    """
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for axis, name in enumerate(("(radius, 0, 0)", "(0, radius, 0)")):
        y, z = radius * rotations[:, 1:, axis].T
        ax.plot(y, z, label=f"the point {name}")
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


TOLERANCE = 1e-13  # keeps energy and angular momentum to 5e-12 over 1e3 s of a few radians a second


def _rates(t, state, *, inertia):
    """Rates of omega and of the quaternion (scalar first) of the attitude."""
    p, q, r, w, x, y, z = state
    return (
        *euler_equations((p, q, r), inertia=inertia),
        -0.5 * (x * p + y * q + z * r),
        0.5 * (w * p + y * r - z * q),
        0.5 * (w * q + z * p - x * r),
        0.5 * (w * r + x * q - y * p),
    )


def _matrices(quaternions):
    """(n, 3, 3) of quaternions (n, 4) of any length."""
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def _agm(a, b):
    """Arithmetic-geometric mean of a >= b > 0; scipy.special has it too, but takes longer to import than all else."""
    while a - b > 1e-8 * a:
        a, b = (a + b) / 2, math.sqrt(a) * math.sqrt(b)
    return (a + b) / 2  # the next step would change it by (a - b)^2/(16 a), below rounding
