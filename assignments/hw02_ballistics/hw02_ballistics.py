"""hw02: Ballistics with linear drag.

figure.svg, beside this file, shows the axes, the names and the positive senses.

The particle feels its weight, m g down, and the drag -c v. x is to the right, y up; it is launched from
the origin at `angle` above the horizontal. There is no ground: it goes on below y = 0. A state is
x, y, vx, vy in m and m/s.

Off limits inside `trajectory`: scipy.integrate and tam570.integrate. A closed form is asked for.
"""

import numpy as np

__all__ = [
    "best_angle",
    "flight_time",
    "free_body_diagram",
    "horizontal_range",
    "limit_shape",
    "plot_comparison",
    "simulate",
    "state_derivative",
    "trajectory",
]


def free_body_diagram(state, *, mass, drag, gravity):
    """The forces on the particle.

    state   : (4,) x, y, vx, vy; m and m/s
    mass    : kg
    drag    : c in the force -c v, kg/s, may be 0
    gravity : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    """
    raise NotImplementedError


def state_derivative(t, state, *, mass, drag, gravity):
    """Rate of change of the state: what solve and solve_ivp integrate.

    t       : s, not used
    state   : (4,) x, y, vx, vy; m and m/s
    mass    : kg
    drag    : c in the force -c v, kg/s, may be 0
    gravity : m/s^2, may be 0
    Returns (4,) vx, vy, ax, ay.
    """
    raise NotImplementedError


def simulate(t, speed, angle, *, mass, drag, gravity):
    """The motion by numerical integration, launched at t[0].

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    Returns (n, 4), the states at t.
    """
    raise NotImplementedError


def trajectory(t, speed, angle, *, mass, drag, gravity):
    """The motion in closed form, launched at t = 0.

    Good to all digits for any drag, zero included: no difference of nearly equal numbers may be left in it.

    t     : (n,) s
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    Returns (n, 4), the states at t.
    """
    raise NotImplementedError


def flight_time(speed, angle, *, mass, drag, gravity):
    """Time until the particle is back at launch height.

    speed : of the launch, m/s, positive
    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns s, positive.
    """
    raise NotImplementedError


def horizontal_range(speed, angle, *, mass, drag, gravity):
    """Distance from the launch at which the particle is back at launch height.

    speed : of the launch, m/s, positive
    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns m.
    """
    raise NotImplementedError


def best_angle(speed, *, mass, drag, gravity):
    """Launch angle of the largest range.

    speed : of the launch, m/s, positive
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns rad, to 1e-6 rad; at a huge speed, where it is small, to 1 % of itself.
    """
    raise NotImplementedError


def limit_shape(angle):
    """Corners of the path in the limit of infinite speed, from the launch back to launch height.

    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    Returns (3, 2), x and y of the corners from start to end, in units of mass * speed / drag.
    """
    raise NotImplementedError


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    """Draw the numerical and the closed-form path, from t[0] to t[-1], at the same scale.

    ax    : Matplotlib Axes to draw on; one line for each path, labelled
    t     : (n,) s, strictly increasing from the launch at t[0] = 0
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    """
    raise NotImplementedError
