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

import math

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
    r = np.array([length * math.sin(theta), -length * math.cos(theta)])
    return [(r, (0.0, -1.0)), (r, -r)]


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration and tension by F = m a along the circle and along the rod.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, tension): rad/s^2, N; a rod that pulls the mass has positive tension.
    """
    tangential = -mass * gravity * math.sin(theta)
    tension = mass * length * omega**2 + mass * gravity * math.cos(theta)
    return tangential / (mass * length), tension


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration by the balance of angular momentum about the hinge.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, angular_momentum, moment): rad/s^2, kg m^2/s, N m; z components about the hinge.
    """
    inertia = mass * length**2
    moment = -mass * gravity * length * math.sin(theta)
    return moment / inertia, inertia * omega, moment


def energy_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration from the constancy of kinetic plus potential energy; also where omega is 0.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, kinetic, potential): rad/s^2, J, J; the potential is 0 at the lowest point.
    """
    inertia = mass * length**2
    kinetic = inertia * omega**2 / 2
    potential = 2 * mass * gravity * length * math.sin(theta / 2) ** 2  # 1 - cos without its cancellation
    slope = mass * gravity * length * math.sin(theta)  # of the potential over theta
    return -slope / inertia, kinetic, potential


def power_balance(theta, omega, *, mass, length, gravity):
    """Angular acceleration from power = rate of kinetic energy; also where omega is 0.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, power): rad/s^2, W; the power of gravity.
    """
    power_per_omega = -mass * gravity * length * math.sin(theta)
    return power_per_omega / (mass * length**2), power_per_omega * omega


def virtual_work(theta, omega, *, mass, length, gravity):
    """Angular acceleration by virtual work: (F - m a) . dr = 0 for every dr that the rod allows.

    theta  : rad
    omega  : rad/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (alpha, generalized_force): rad/s^2, N m; the virtual work of gravity is generalized_force * dtheta.
    """
    generalized_force = -mass * gravity * length * math.sin(theta)
    return generalized_force / (mass * length**2), generalized_force


def lagrangian():
    """Kinetic less potential energy; the potential is 0 at the lowest point.

    Returns a SymPy expression in the symbols theta, omega, m, l, g.
    """
    import sympy

    theta, omega, mass, length, gravity = sympy.symbols("theta omega m l g")
    return mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - sympy.cos(theta))


def lagrange_equation():
    """Angular acceleration by Lagrange's equation, obtained from `lagrangian()` by differentiation.

    Returns a SymPy expression in the symbols theta, l, g.
    """
    import sympy

    theta, omega = sympy.symbols("theta omega")
    momentum = sympy.diff(lagrangian(), omega)
    force = sympy.diff(lagrangian(), theta) - sympy.diff(momentum, theta) * omega
    return force / sympy.diff(momentum, omega)


def action(theta, step, *, mass, length, gravity):
    """Hamilton's action of a sampled path: the integral of the Lagrangian over time.

    theta  : (n,) rad, n >= 2, the path at equal steps of time
    step   : s, > 0
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns J s; the error is of order step^2 or smaller.
    """
    omega = np.diff(theta) / step
    middle = (theta[:-1] + theta[1:]) / 2
    kinetic = mass * length**2 * omega**2 / 2
    potential = 2 * mass * gravity * length * np.sin(middle / 2) ** 2
    return step * np.sum(kinetic - potential)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    """Solution of the linearised equation theta'' + (gravity/length) theta = 0, theta0 and omega0 at t = 0.

    t      : (n,) s
    theta0 : rad
    omega0 : rad/s
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 2): theta in rad, omega in rad/s.
    """
    k = math.sqrt(gravity / length)
    c, s = np.cos(k * t), np.sin(k * t)
    s_over_k = s / k if k > 0 else t
    return np.column_stack([theta0 * c + omega0 * s_over_k, omega0 * c - theta0 * k * s])


def period(amplitude, *, length, gravity):
    """Exact period of the swing between -amplitude and amplitude.

    amplitude : rad, 0 < amplitude < pi
    length    : m
    gravity   : m/s^2, > 0
    Returns s.
    """
    # Gauss: K(sin(A/2)) = (pi/2)/agm(1, cos(A/2)). Next to pi that cosine keeps its digits; 1 - sin^2 does not.
    return 2 * math.pi * math.sqrt(length / gravity) / _agm(1.0, math.cos(amplitude / 2))


def simulate(t, theta0, omega0, *, length, gravity):
    """Motion by the full nonlinear equation, from theta0 and omega0 at t[0].

    t      : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    theta0 : rad
    omega0 : rad/s
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 2): theta in rad (never wrapped), omega in rad/s; row i is the state at t[i].
    """
    from tam570.integrate import solve

    # Turn by turn, if it goes over the top: the sine of an angle of a thousand turns has lost three digits.
    turn = _time_of_a_turn(theta0, omega0, length=length, gravity=gravity)
    turns, since = np.divmod(t - t[0], turn)
    times, rows = np.unique([*since, min(turn, t[-1] - t[0])], return_inverse=True)
    parameters = {"length": length, "gravity": gravity}
    states = solve(_state_derivative, times, (theta0, omega0), parameters=parameters, rtol=1e-13)[rows[:-1]]
    return states + np.outer(turns, (math.copysign(2 * math.pi, omega0), 0.0))


def _state_derivative(t, state, *, length, gravity):
    theta, omega = state
    return omega, -gravity / length * math.sin(theta)


def _time_of_a_turn(theta, omega, *, length, gravity):
    """Time of a full turn of a pendulum that goes over the top; else infinite."""
    bottom = omega**2 / 4 + gravity / length * math.sin(theta / 2) ** 2  # omega^2/4 there
    top = omega**2 / 4 - gravity / length * math.cos(theta / 2) ** 2
    return math.pi / _agm(math.sqrt(bottom), math.sqrt(top)) if top > 0 else math.inf


def _agm(a, b):
    """Arithmetic-geometric mean of a >= b > 0; scipy.special has it too, but takes longer to import than all else."""
    while a - b > 1e-8 * a:
        a, b = (a + b) / 2, math.sqrt(a) * math.sqrt(b)
    return (a + b) / 2  # the next step would change it by (a - b)^2/(16 a), below rounding
