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

import math

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
    x, y, yaw, tilt, _, _, _, _ = state
    contact = np.array([x, y, 0.0])
    up_the_disk = np.array([-math.sin(yaw) * math.cos(tilt), math.cos(yaw) * math.cos(tilt), math.sin(tilt)])
    return [(contact + radius * up_the_disk, (0.0, 0.0, -1.0)), (contact, None)]


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the Euler state: Euler angles, momentum balances in the frame e1, e2, e3.

    t     : s, not used
    state : (8,) Euler state
    Returns (8,).
    """
    x, y, yaw, tilt, roll, yaw_rate, tilt_rate, roll_rate = state
    A, C = inertia
    c, s = math.cos(tilt), math.sin(tilt)
    rolling = mass * radius * radius
    spin = roll_rate + yaw_rate * c
    # The frame turns with e1 and not with the disk: its rate along the axle is yaw' cos(tilt), not the spin.
    tilt_acceleration = (yaw_rate * s * (A * yaw_rate * c - (C + rolling) * spin) - mass * gravity * radius * c) / (
        A + rolling
    )
    yaw_acceleration = tilt_rate * (C / A * spin - 2.0 * yaw_rate * c) / s
    spin_acceleration = rolling / (C + rolling) * tilt_rate * yaw_rate * s
    roll_acceleration = spin_acceleration - yaw_acceleration * c + yaw_rate * tilt_rate * s
    return (
        -radius * roll_rate * math.cos(yaw),
        -radius * roll_rate * math.sin(yaw),
        yaw_rate,
        tilt_rate,
        roll_rate,
        yaw_acceleration,
        tilt_acceleration,
        roll_acceleration,
    )


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the matrix state: no angles, momentum balances in space axes with the rolling constraint.

    t     : s, not used
    state : (15,) matrix state that satisfies the constraints
    Returns (15,).
    """
    x, y, z, xx, xy, nx, yx, yy, ny, zx, zy, nz, wx, wy, wz = state  # n: the axle, third column of R
    A, C = inertia
    s = math.sqrt(nx * nx + ny * ny)
    e1x, e1y = -ny / s, nx / s
    e2x, e2y = -nz * e1y, nz * e1x  # and s is its z component
    vx, vy, vz = wy * s - wz * e2y, wz * e2x - wx * s, wx * e2y - wy * e2x  # omega x e2, velocity / a
    w1, w2 = wx * e1x + wy * e1y, wx * e2x + wy * e2y + wz * s
    spin = wx * nx + wy * ny + wz * nz
    turn = w2 * nz / s  # along the axle, of the frame: e2' = w1 axle - turn e1
    # F/m = a (omega' x e2 + omega x e2') + g z has the moment -a e2 x F, and the change of H = A omega + (C - A) spin
    # axle is A omega' + (C - A) (spin' axle + spin omega x axle): omega' is p, q, r along e1, e2 and the axle.
    rolling, k = mass * radius * radius, (C - A) * spin
    p = -(w2 * (k + rolling * turn) + mass * gravity * radius * nz) / (A + rolling)
    q = k * w1 / A
    r = rolling * w1 * w2 / (C + rolling)
    return (
        radius * vx,
        radius * vy,
        radius * vz,
        *(wy * z - wz * y for y, z in ((yx, zx), (yy, zy), (ny, nz))),  # R' = omega x R, row by row
        *(wz * x - wx * z for x, z in ((xx, zx), (xy, zy), (nx, nz))),
        *(wx * y - wy * x for x, y in ((xx, yx), (xy, yy), (nx, ny))),
        p * e1x + q * e2x + r * nx,
        p * e1y + q * e2y + r * ny,
        q * s + r * nz,
    )


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Rates of the matrix state: a free body, the contact force as Lagrange multipliers of the constraint.

    t     : s, not used
    state : (15,) matrix state that satisfies the constraints
    Returns (15,).
    """
    R, omega = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    turning = _cross_matrix(omega)
    arm, arm_rate = _contact_arm(R[:, 2], omega, radius)
    lever = _cross_matrix(arm)
    about_centre = R @ np.diag([inertia[0], inertia[0], inertia[1]]) @ R.T
    # Unknown are the acceleration of the centre, omega' and the force; the rows are the two balances and the
    # derivative of the constraint v + omega x arm = 0. All in units of the mass, for the sake of the numbers.
    system = np.block(
        [
            [np.eye(3), np.zeros((3, 3)), -np.eye(3)],
            [np.zeros((3, 3)), about_centre / mass, -lever],
            [np.eye(3), -lever, np.zeros((3, 3))],
        ]
    )
    weight = np.array([0.0, 0.0, -gravity])
    gyroscopic = turning @ about_centre @ omega / mass
    right_side = np.concatenate([weight, -gyroscopic, -turning @ arm_rate])
    _, omega_rate, _ = np.linalg.solve(system, right_side).reshape(3, 3)
    return np.concatenate([-turning @ arm, (turning @ R).ravel(), omega_rate])


def matrix_state(state, *, radius):
    """The matrix state of an Euler state.

    state : (8,) Euler state
    Returns (15,).
    """
    x, y, _, tilt, roll, yaw_rate, tilt_rate, _ = state
    e1, e2, e3 = _frame(state)
    omega = tilt_rate * e1 + yaw_rate * math.sin(tilt) * e2 + _spin(state) * e3
    c, s = math.cos(roll), math.sin(roll)
    R = np.column_stack([c * e1 + s * e2, c * e2 - s * e1, e3])
    return np.concatenate([np.array([x, y, 0.0]) + radius * e2, R.ravel(), omega])


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    """Euler states of the rolling disk at the times `t`; row 0 is the given state.

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state : (8,) Euler state at t[0]
    Returns (n, 8).
    """
    return _states(euler_state_derivative, t, state, mass, radius, inertia, gravity)


def simulate_matrix(t, state, *, mass, radius, inertia, gravity):
    """Matrix states of the rolling disk at the times `t`; row 0 is the given state.

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state : (15,) matrix state at t[0]
    Returns (n, 15).
    """
    return _states(matrix_state_derivative, t, state, mass, radius, inertia, gravity)


def energy(state, *, mass, radius, inertia, gravity):
    """Kinetic plus potential energy of the rolling disk.

    state : (8,) Euler state
    Returns J; the potential is 0 with the centre on the ground.
    """
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    A, C = inertia
    rolling = mass * radius**2
    about_diameter = (A + rolling) * tilt_rate**2 + A * (yaw_rate * math.sin(tilt)) ** 2
    about_axle = (C + rolling) * _spin(state) ** 2
    return 0.5 * (about_diameter + about_axle) + mass * gravity * radius * math.sin(tilt)


def contact_force(state, *, mass, radius, inertia, gravity):
    """Force of the ground on the rolling disk.

    state : (8,) Euler state
    Returns (3,) N, space axes.
    """
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    *_, yaw_acceleration, tilt_acceleration, roll_acceleration = euler_state_derivative(0.0, state, **disk)
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    c, s, spin = math.cos(tilt), math.sin(tilt), _spin(state)
    spin_acceleration = roll_acceleration + yaw_acceleration * c - yaw_rate * tilt_rate * s
    # The centre moves at a (tilt' e3 - spin e1); the frame turns at tilt' e1 + yaw' z.
    along_e1 = yaw_rate * tilt_rate * s - spin_acceleration
    along_e2 = -yaw_rate * spin * c - tilt_rate**2
    along_e3 = tilt_acceleration + yaw_rate * spin * s
    acceleration = radius * (np.array([along_e1, along_e2, along_e3]) @ _frame(state))
    return mass * (acceleration + np.array([0.0, 0.0, gravity]))


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    """tilt'' of a disk that rolls at this lean, precession and spin without tilt'; 0 if the motion is steady.

    lean       : rad, tilt - pi/2
    precession : rad/s, yaw'
    spin       : rad/s, total, along the axle
    Returns rad/s^2.
    """
    A, C = inertia
    c, s, rolling = math.cos(lean), math.sin(lean), mass * radius**2
    gyroscopic = precession * c * (A * precession * s + (C + rolling) * spin)
    return (mass * gravity * radius * s - gyroscopic) / (A + rolling)


def critical_speed(*, mass, radius, inertia, gravity):
    """Speed of the centre above which straight upright rolling is stable.

    Returns m/s.
    """
    A, C = inertia
    rolling = C + mass * radius**2
    return radius * math.sqrt(mass * gravity * radius / rolling * (A / C))


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    """Square of the rate at which a small lean grows in straight upright rolling.

    speed : m/s, of the centre
    Returns 1/s^2: positive where the motion is unstable; -(frequency^2) in (rad/s)^2 where it is stable.
    """
    A, C = inertia
    rolling = mass * radius**2
    gyroscopic = (C / A) * (C + rolling) * (speed / radius) ** 2
    return (mass * gravity * radius - gyroscopic) / (A + rolling)


def wireframe(state, *, radius, sides):
    """The disk as line segments in space: a polygon on its rim, and two diameters fixed in it.

    state : (8,) Euler state
    sides : number of the polygon's sides
    Returns (sides + 2, 2, 3) m: the closed regular polygon, then two perpendicular diameters.
    """
    placed = matrix_state(state, radius=radius)
    centre, R = placed[:3], placed[3:12].reshape(3, 3)
    angles = 2.0 * np.pi * np.arange(sides) / sides
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(sides)])
    polygon = np.stack([rim, np.roll(rim, -1, axis=0)], axis=1)
    ends = radius * np.eye(3)[:2]
    diameters = np.stack([-ends, ends], axis=1)
    return centre + np.concatenate([polygon, diameters]) @ R.T


def _spin(state):
    """Total angular velocity along the axle, rad/s."""
    _, _, _, tilt, _, yaw_rate, _, roll_rate = state
    return roll_rate + yaw_rate * math.cos(tilt)


def _frame(state):
    """(3, 3) with the rows e1, e2, e3."""
    _, _, yaw, tilt, *_ = state
    cy, sy, ct, st = math.cos(yaw), math.sin(yaw), math.cos(tilt), math.sin(tilt)
    return np.array([[cy, sy, 0.0], [-sy * ct, cy * ct, st], [sy * st, -cy * st, ct]])


def _states(derivative, t, state, mass, radius, inertia, gravity):
    from tam570.integrate import solve

    disk = {"mass": mass, "radius": radius, "inertia": tuple(inertia), "gravity": gravity}
    return solve(derivative, t, state, parameters=disk, rtol=TOLERANCE)


TOLERANCE = 1e-13  # keeps the energy to 1e-11 over 1e3 s; R^T R = I is kept by the same accuracy


def _contact_arm(axle, omega, radius):
    """From the centre to the contact, and the rate of that: the lowest place, no point of the disk.

    It is -a (z - cos(tilt) axle) / sin(tilt), with cos(tilt) = axle . z and axle' = omega x axle.
    """
    vertical = np.array([0.0, 0.0, 1.0])
    axle_rate = _cross_matrix(omega) @ axle
    c, c_rate, s = axle[2], axle_rate[2], np.hypot(axle[0], axle[1])
    s_rate = (axle[0] * axle_rate[0] + axle[1] * axle_rate[1]) / s
    upwards = (s * s * vertical - c * np.array([axle[0], axle[1], 0.0])) / s
    upwards_rate = -(c_rate * axle + c * axle_rate + s_rate * upwards) / s
    return -radius * upwards, -radius * upwards_rate


def _cross_matrix(v):
    """(3, 3) with _cross_matrix(v) @ r = v x r."""
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
