"""hw10: Free motion of a rigid body.

figure.svg, beside this file, shows the axes, the names and the positive senses.

inertia (3,) holds A, B, C, the principal moments of inertia about the centre of mass (kg m^2); omega (3,) is the
angular velocity in rad/s, in components along the body's principal axes; R (3, 3) takes body to space components. No
moment acts. Axes 0, 1, 2 are those of A, B, C.

Off limits in this file: tam570.lectures, and in `euler_rates_313` tam570.rotations and scipy.spatial.transform, which
would answer it.
"""

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
    raise NotImplementedError


def attitude_rate(R, omega):
    """Rate of change of R.

    R     : (3, 3), body to space
    omega : (3,) rad/s, body components
    Returns (3, 3) 1/s.
    """
    raise NotImplementedError


def euler_rates_313(angles, omega):
    """Rates of the Euler angles of R = Rz(psi) Rx(theta) Rz(phi).

    angles : (psi, theta, phi) rad
    omega  : (3,) rad/s, body components
    Returns (3,) rad/s, the rates of psi, theta, phi.
    Raises ValueError where abs(sin theta) < 1e-12.
    """
    raise NotImplementedError


def energy(omega, *, inertia):
    """Kinetic energy of rotation.

    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns J.
    """
    raise NotImplementedError


def angular_momentum(R, omega, *, inertia):
    """Angular momentum about the centre of mass, in space components.

    R       : (3, 3), body to space
    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns (3,) kg m^2/s.
    """
    raise NotImplementedError


def simulate(t, R, omega, *, inertia):
    """Angular velocities and attitudes at the times `t`; rows 0 are those given.

    t       : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    R       : (3, 3), body to space, at t[0]
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, B, C) kg m^2
    Returns (omegas (n, 3), rotations (n, 3, 3)).
    """
    raise NotImplementedError


def symmetric_solution(t, omega, *, inertia):
    """(a) omega in body components at the times `t`, in closed form, of a body with A = B.

    t       : (n,) s
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, A, C) kg m^2
    Returns (n, 3) rad/s.
    """
    raise NotImplementedError


def wobble_rate(omega, *, inertia):
    """(a) Rate at which the symmetry axis goes round the angular momentum, of a body with A = B.

    omega   : (3,) rad/s, body components, not all zero
    inertia : (A, A, C) kg m^2
    Returns rad/s, positive.
    """
    raise NotImplementedError


def growth_rate_squared(axis, spin, *, inertia):
    """(b) Square of the rate at which a small deviation from spin about a principal axis grows.

    axis    : 0, 1 or 2, the axis of A, B or C
    spin    : rad/s about it
    inertia : (A, B, C) kg m^2
    Returns 1/s^2: positive where the spin is unstable; -(frequency^2) in (rad/s)^2 where it is stable.
    """
    raise NotImplementedError


def tumble_period(omega, *, inertia):
    """(b) Period of omega in body components, A < B < C.

    omega   : (3,) rad/s, body components
    inertia : (A, B, C) kg m^2
    Returns s; math.inf on the separatrix; for pure spin about axis 0 or 2 the limit of small oscillations.
    """
    raise NotImplementedError


def wireframe(R, *, size):
    """Edges of a box that is centred on the origin, turned by R.

    R    : (3, 3), body to space
    size : (3,) m, lengths along the body's axes
    Returns (12, 2, 3) m: segment i runs from [i, 0] to [i, 1].
    """
    raise NotImplementedError


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    """(a) Draw the paths of the body points (radius, 0, 0) and (0, radius, 0), seen along space x.

    ax      : Matplotlib Axes to draw on: y to the right, z up
    t       : (n,) s, strictly increasing
    R       : (3, 3), body to space, at t[0]
    omega   : (3,) rad/s, body components, at t[0]
    inertia : (A, B, C) kg m^2
    radius  : m
    """
    raise NotImplementedError
