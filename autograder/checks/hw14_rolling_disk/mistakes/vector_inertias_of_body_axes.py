"""The inertias of body axes are used along the axes of space: I is R diag(A, A, C) R^T.

fails: multiplier_equations_hold, matrix_equations_hold, matrix_simulation_follows_the_motion
"""


def _rates(t, state, *, mass, radius, inertia, gravity):
    R, omega = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    arm, arm_rate = _contact_arm(R[:, 2], omega, radius)
    lever, tensor = _cross_matrix(arm), np.diag([inertia[0], inertia[0], inertia[1]])
    system = np.block([
        [np.eye(3), np.zeros((3, 3)), -np.eye(3)],
        [np.zeros((3, 3)), tensor / mass, -lever],
        [np.eye(3), -lever, np.zeros((3, 3))],
    ])
    known = np.concatenate([[0.0, 0.0, -gravity], -np.cross(omega, tensor @ omega) / mass, -np.cross(omega, arm_rate)])
    omega_rate = np.linalg.solve(system, known)[3:6]
    return np.concatenate([-np.cross(omega, arm), (_cross_matrix(omega) @ R).ravel(), omega_rate])


multiplier_state_derivative = matrix_state_derivative = _rates
