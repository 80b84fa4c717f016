"""Right functions of hw14 by vectors in space, in terms of others; diagnosis tries mistakes in these, too."""

import numpy as np

Z = np.array([0.0, 0.0, 1.0])


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    """Use rates of omega = yaw' z + tilt' e1 + roll' e3, and the velocity of the contact, by roll'."""
    e1, e2, e3 = _axes(state)
    omega, _ = _turning(state)
    omega_rate, _ = _balances(state, mass, radius, inertia, gravity)
    turning = state[5] * state[6] * np.cross(Z, e1) + state[7] * np.cross(omega, e3)
    velocity = radius * state[7] * np.cross(e3, e2)
    angles = np.linalg.solve(np.column_stack([Z, e1, e3]), omega_rate - turning)
    return np.concatenate([velocity[:2], state[5:], angles])


def matrix_state(state, *, radius):
    e1, e2, e3 = _axes(state)
    omega, _ = _turning(state)
    c, s = np.cos(state[4]), np.sin(state[4])
    R = np.column_stack([c * e1 + s * e2, c * e2 - s * e1, e3])
    return np.concatenate([np.array([state[0], state[1], 0.0]) + radius * e2, R.ravel(), omega])


def energy(state, *, mass, radius, inertia, gravity):
    _, e2, e3 = _axes(state)
    omega, _ = _turning(state)
    velocity = np.cross(omega, radius * e2)
    angular_momentum = _about_centre(e3, inertia) @ omega
    return mass * velocity @ velocity / 2 + omega @ angular_momentum / 2 + mass * gravity * radius * e2[2]


def contact_force(state, *, mass, radius, inertia, gravity):
    return _balances(state, mass, radius, inertia, gravity)[1]


def matrix_state_derivative(t, state, *, radius, **disk):
    """Compute omega' of omega = yaw' z + tilt' e1 + roll' e3 by the second derivatives of the angles."""
    R, omega = state[3:12].reshape(3, 3), state[12:]
    e3, s = R[:, 2], np.hypot(R[0, 2], R[1, 2])
    e1 = np.array([-e3[1], e3[0], 0.0]) / s
    e2 = np.cross(e3, e1)
    angles = np.arctan2(e1[1], e1[0]), np.arctan2(s, e3[2]), np.arctan2(R[2, 0], R[2, 1])
    yaw_rate, tilt_rate = omega @ e2 / s, omega @ e1
    roll_rate = omega @ e3 - yaw_rate * e3[2]
    angular = np.array([0.0, 0.0, *angles, yaw_rate, tilt_rate, roll_rate])
    second = euler_state_derivative(t, angular, radius=radius, **disk)[5:]
    turning = tilt_rate * yaw_rate * np.cross(Z, e1) + roll_rate * np.cross(omega, e3)
    omega_rate = second[0] * Z + second[1] * e1 + second[2] * e3 + turning
    return np.concatenate([np.cross(omega, radius * e2), np.cross(omega, R.T).T.ravel(), omega_rate])


def multiplier_state_derivative(t, state, **disk):
    return matrix_state_derivative(t, state, **disk)


def steady_residual(lean, precession, spin, **disk):
    tilt = lean + np.pi / 2
    steady = np.array([0.0, 0.0, 0.0, tilt, 0.0, precession, 0.0, spin - precession * np.cos(tilt)])
    return euler_state_derivative(0.0, steady, **disk)[6]


def _axes(state):
    e1 = np.array([np.cos(state[2]), np.sin(state[2]), 0.0])
    across, c, s = np.cross(Z, e1), np.cos(state[3]), np.sin(state[3])
    return e1, c * across + s * Z, c * Z - s * across


def _turning(state):
    """Return omega of the disk, and of the frame e1, e2, e3."""
    _, _, _, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    e1, e2, e3 = _axes(state)
    level = tilt_rate * e1 + yaw_rate * np.sin(tilt) * e2
    spin = roll_rate + yaw_rate * np.cos(tilt)
    return level + spin * e3, level + yaw_rate * np.cos(tilt) * e3


def _about_centre(e3, inertia):
    A, C = inertia
    return A * np.eye(3) + (C - A) * np.outer(e3, e3)


def _balances(state, mass, radius, inertia, gravity):
    """Return omega' and the force, by the moment of the force and the rate of angular momentum about the centre."""
    _, e2, e3 = _axes(state)
    omega, frame_rate = _turning(state)
    arm, about_centre = radius * e2, _about_centre(e3, inertia)
    at_rest = mass * np.cross(omega, radius * np.cross(frame_rate, e2)) + mass * gravity * Z  # force without omega'
    moment = np.cross(omega, about_centre @ omega) + np.cross(arm, at_rest)
    about_contact = about_centre + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    omega_rate = -np.linalg.solve(about_contact, moment)
    return omega_rate, mass * np.cross(omega_rate, arm) + at_rest
