"""hw01: The simple pendulum, derived as many ways as you can.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A point mass on a massless rod. The hinge is the origin, x right, y up; theta is measured from straight down,
counter-clockwise positive, so that the mass is at r = length (sin theta, -cos theta); omega and alpha are its
first and second rates. The potential energy is zero at the lowest point.

Off limits in this file: tam570.lagrange and tam570.lectures, which would answer it.

Ways of my own
--------------
(Write them here before you go on: which law, about which point, with which unknowns?)
"""

import numpy as np

__all__ = [
    "action",
    "angular_momentum_balance",
    "energy_balance",
    "free_body_diagram",
    "lagrange_equation",
    "lagrangian",
    "linear_momentum_balance",
    "period",
    "power_balance",
    "simulate",
    "small_angle_solution",
    "virtual_work",
]


def free_body_diagram(theta, omega, *, mass, length, gravity):
    """The forces on the mass, cut free from the rod.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    """
    raise NotImplementedError


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration and tension by F = m a along the circle and along the rod.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, tension): rad/s^2, N; a rod that pulls the mass has positive tension.
    """
    raise NotImplementedError


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration by the balance of angular momentum about the hinge.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, angular_momentum, moment): rad/s^2, kg m^2/s, N m; z components about the hinge.
    """
    raise NotImplementedError


def energy_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration from the constancy of kinetic plus potential energy; also where omega is 0.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, kinetic, potential): rad/s^2, J, J; the potential is 0 at the lowest point.
    """
    raise NotImplementedError


def power_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration from power = rate of kinetic energy; also where omega is 0.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, power): rad/s^2, W; the power of gravity.
    """
    raise NotImplementedError


def virtual_work(theta, omega, *, mass, length, gravity):
    """Angular acceleration by virtual work: (F - m a) . dr = 0 for every dr that the rod allows.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, generalized_force): rad/s^2, N m; the virtual work of gravity is generalized_force * dtheta.
    """
    raise NotImplementedError


def lagrangian():
    """Kinetic less potential energy; the potential is 0 at the lowest point.

    Returns a SymPy expression in the symbols theta, omega, m, l, g.
    """
    raise NotImplementedError


def lagrange_equation():
    """Angular acceleration by Lagrange's equation, obtained from `lagrangian()` by differentiation.

    Returns a SymPy expression in the symbols theta, l, g.
    """
    raise NotImplementedError


def action(theta, step, *, mass, length, gravity):
    """Hamilton's action of a sampled path: the integral of the Lagrangian over time.

    theta  : (n,) rad, n >= 2, the path at equal steps of time
    step   : s, > 0
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns J s; the error is of order step^2 or smaller.
    """
    raise NotImplementedError


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    """Solution of the linearised equation theta'' + (gravity/length) theta = 0, theta0 and omega0 at t = 0.

    t      : (n,) s
    theta0 : rad
    omega0 : rad/s
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 2): theta in rad, omega in rad/s.
    """
    raise NotImplementedError


def period(amplitude, *, length, gravity):
    """Exact period of the swing between -amplitude and amplitude.

    amplitude : rad, 0 < amplitude < pi
    length    : m
    gravity   : m/s^2, > 0
    Returns s.
    """
    raise NotImplementedError


def simulate(t, theta0, omega0, *, length, gravity):
    """Motion by the full nonlinear equation, from theta0 and omega0 at t[0].

    t      : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    theta0 : rad
    omega0 : rad/s
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 2): theta in rad (never wrapped), omega in rad/s; row i is the state at t[i].
    """
    raise NotImplementedError
