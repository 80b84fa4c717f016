"""The tilt in the multipliers' equations is found by an arcsine, which is never more than a quarter turn.

fails: multiplier_equations_hold
"""


_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, **disk):
    R, (x, y, z) = np.reshape(state[3:12], (3, 3)), state[12:]
    axle = R[:, 2] * [1.0, 1.0, np.sign(R[2, 2])]
    e1 = np.array([-axle[1], axle[0], 0.0]) / math.hypot(axle[0], axle[1])
    seen = np.column_stack([e1, np.cross(axle, e1), axle])
    rates = np.array(_rates(t, np.concatenate([state[:3], seen.ravel(), state[12:]]), **disk))
    rates[3:12] = (np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) @ R).ravel()
    return rates
