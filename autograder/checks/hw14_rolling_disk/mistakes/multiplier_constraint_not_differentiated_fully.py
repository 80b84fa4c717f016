"""The constraint's derivative leaves out the rate of the arm to the contact.

fails: multiplier_equations_hold
"""


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    R, omega = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    across = _cross_matrix(omega)
    A, C = inertia
    n, z = R[:, 2], np.array([0.0, 0.0, 1.0])
    up = (z - n[2] * n) / math.hypot(n[0], n[1])
    tensor = A * np.eye(3) + (C - A) * np.outer(n, n)
    about_contact = tensor + mass * radius**2 * (np.eye(3) - np.outer(up, up))
    turning = 0 * omega
    moment = -across @ tensor @ omega - mass * radius * _cross_matrix(up) @ (radius * across @ _cross_matrix(turning) @ up + gravity * z)
    omega_rate = np.linalg.solve(about_contact, moment)
    return np.concatenate([radius * across @ up, (across @ R).ravel(), omega_rate])
