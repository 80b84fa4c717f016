"""hw14: The rolling disk, three ways.

figure.svg, beside this file, shows the axes, the names and the positive senses.

The ground is z = 0, z up; `gravity` is a magnitude (m/s^2). The disk has `mass` (kg), `radius` a (m)
and an array inertia = (A, C) (kg m^2): about a diameter and about the axle, both through the centre, 0 < C <= 2 A.

R = Rz(yaw) Rx(tilt) Rz(roll) takes body to space components. The axle is e3 = R z, and
    e1 = (cos yaw, sin yaw, 0)   along the ground, the direction of the track
    e2 = axle x e1               up along the disk, from the contact to the centre: centre = contact + a e2.
0 < tilt < pi, pi/2 upright; hw11's lean is tilt - pi/2. A positive spin, omega . axle, moves the centre along
-e1. The disk rolls: the point of the disk that touches the ground has no velocity.

Euler state (8)   : x, y (m, of the contact), yaw, tilt, roll (rad, never wrapped), yaw', tilt', roll' (rad/s)
Matrix state (15) : centre (3, m), R row by row (9), omega (3, rad/s, space axes)
"""

import numpy as np

__all__ = [
    "contact_force",
    "critical_speed",
    "energy",
    "euler_state_derivative",
    "free_body_diagram",
    "growth_rate_squared",
    "matrix_state",
    "matrix_state_derivative",
    "multiplier_state_derivative",
    "simulate_euler",
    "simulate_matrix",
    "steady_residual",
    "wireframe",
]


def free_body_diagram(state, *, mass, radius, gravity):
    """The forces on the disk, cut free from the ground, in space axes.

    state : (8,) Euler state
    Returns a list of pairs (point, direction), one for each force: where it acts, (3,) in m, and a vector (3,) of any
    length along which it acts, or None where no component is known. The order is free.
    """
    raise NotImplementedError


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the Euler state: Euler angles, momentum balances in the frame e1, e2, e3.

    t     : s, not used
    state : (8,) Euler state
    Returns (8,).
    """
    raise NotImplementedError


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the matrix state: no angles, momentum balances in space axes with the rolling constraint.

    t     : s, not used
    state : (15,) matrix state that satisfies the constraints
    Returns (15,).
    """
    raise NotImplementedError


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the matrix state: a free body, the contact force as Lagrange multipliers of the constraint.

    t     : s, not used
    state : (15,) matrix state that satisfies the constraints
    Returns (15,).
    """
    raise NotImplementedError


def matrix_state(state, *, radius):
    """The matrix state of an Euler state.

    state : (8,) Euler state
    Returns (15,).
    """
    raise NotImplementedError


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    """Euler states of the rolling disk at the times `t`; row 0 is the given state.

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state : (8,) Euler state at t[0]
    Returns (n, 8).
    """
    raise NotImplementedError


def simulate_matrix(t, state, *, mass, radius, inertia, gravity):
    """Matrix states of the rolling disk at the times `t`; row 0 is the given state.

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state : (15,) matrix state at t[0]
    Returns (n, 15).
    """
    raise NotImplementedError


def energy(state, *, mass, radius, inertia, gravity):
    """Kinetic plus potential energy of the rolling disk.

    state : (8,) Euler state
    Returns J; the potential is 0 with the centre on the ground.
    """
    raise NotImplementedError


def contact_force(state, *, mass, radius, inertia, gravity):
    """Force of the ground on the rolling disk.

    state : (8,) Euler state
    Returns (3,) N, space axes.
    """
    raise NotImplementedError


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    """tilt'' of a disk that rolls at this lean, precession and spin without tilt'; 0 if the motion is steady.

    lean       : rad, tilt - pi/2
    precession : rad/s, yaw'
    spin       : rad/s, total, along the axle
    Returns rad/s^2.
    """
    raise NotImplementedError


def critical_speed(*, mass, radius, inertia, gravity):
    """Speed of the centre above which straight upright rolling is stable.

    Returns m/s.
    """
    raise NotImplementedError


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    """Square of the rate at which a small lean grows in straight upright rolling.

    speed : m/s, of the centre
    Returns 1/s^2: positive where the motion is unstable; -(frequency^2) in (rad/s)^2 where it is stable.
    """
    raise NotImplementedError


def wireframe(state, *, radius, sides):
    """The disk as line segments in space: a polygon on its rim, and two diameters fixed in it.

    state : (8,) Euler state
    sides : number of the polygon's sides
    Returns (sides + 2, 2, 3) m: the closed regular polygon, then two perpendicular diameters.
    """
    raise NotImplementedError
