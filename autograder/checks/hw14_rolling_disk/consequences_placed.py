"""Right functions of hw14 by the student's own matrix state and its rates."""

import numpy as np


def energy(state, *, mass, radius, inertia, gravity):
    placed = matrix_state(state, radius=radius)
    centre, R, omega = placed[:3], placed[3:12].reshape(3, 3), placed[12:]
    velocity = np.cross(omega, centre - np.array([state[0], state[1], 0.0]))
    turning = np.array([inertia[0], inertia[0], inertia[1]]) @ (omega @ R) ** 2
    return (mass * velocity @ velocity + turning) / 2 + mass * gravity * centre[2]


def contact_force(state, *, mass, radius, inertia, gravity):
    """Difference the velocity of the centre a moment before and after."""
    placed, disk = matrix_state(state, radius=radius), {"mass": mass, "inertia": inertia, "gravity": gravity}
    step = 1e-6 * np.asarray(matrix_state_derivative(0.0, placed, radius=radius, **disk))
    after = matrix_state_derivative(0.0, placed + step, radius=radius, **disk)
    before = matrix_state_derivative(0.0, placed - step, radius=radius, **disk)
    return mass * ((np.asarray(after[:3]) - before[:3]) / 2e-6 + np.array([0.0, 0.0, gravity]))
