"""The yaw in the multipliers' equations is found by an arctan of a ratio: where cos(yaw) < 0, half a turn is lost.

fails: multiplier_equations_hold
"""


_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, **disk):
    R, (x, y, z) = np.reshape(state[3:12], (3, 3)), state[12:]
    turn = np.diag([-1.0, -1.0, 1.0]) if R[1, 2] > 0 else np.eye(3)
    rates = np.array(_rates(t, np.concatenate([state[:3], (turn @ R).ravel(), state[12:]]), **disk))
    rates[3:12] = (np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) @ R).ravel()
    return rates
