"""Right functions of hw14 in terms of others, which a student's results follow where those are the student's own."""

import numpy as np

Z = np.array([0.0, 0.0, 1.0])


def matrix_state_derivative(t, state, *, radius, **disk):
    """omega' of omega = yaw' z + tilt' e1 + roll' e3, by the second derivatives of the angles."""
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
