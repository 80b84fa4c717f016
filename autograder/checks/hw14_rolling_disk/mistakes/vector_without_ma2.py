"""m a^2 is missing: the force that moves the centre has a moment about it too.

fails: multiplier_equations_hold, matrix_equations_hold, matrix_simulation_follows_the_motion
"""


def _rates(t, state, *, mass, radius, inertia, gravity):
    R, omega = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    across = _cross_matrix(omega)
    A, C = inertia
    n, z = R[:, 2], np.array([0.0, 0.0, 1.0])
    up = (z - n[2] * n) / math.hypot(n[0], n[1])
    tensor = A * np.eye(3) + (C - A) * np.outer(n, n)
    about_contact = tensor
    turning = omega - n * (omega @ n - n[2] * (omega @ up) / up[2])
    moment = -across @ tensor @ omega - mass * radius * gravity * _cross_matrix(up) @ z
    omega_rate = np.linalg.solve(about_contact, moment)
    return np.concatenate([radius * across @ up, (across @ R).ravel(), omega_rate])


multiplier_state_derivative = matrix_state_derivative = _rates
