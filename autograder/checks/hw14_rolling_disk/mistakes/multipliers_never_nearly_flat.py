"""Axles next to the vertical are moved away from it, to avoid a division by zero.

fails: multiplier_equations_hold
names: No tilt but 0 and pi is singular
"""


def _away_from_flat(rates):
    def function(t, state, **disk):
        R, (x, y, z) = np.reshape(state[3:12], (3, 3)), state[12:]
        n = R[:, 2]
        s = math.hypot(n[0], n[1])
        if s > 1e-2:
            return rates(t, state, **disk)
        e1 = np.array([-n[1], n[0], 0.0]) / s
        axle = np.array([n[0] * 1e-2 / s, n[1] * 1e-2 / s, math.copysign(math.sqrt(1 - 1e-4), n[2])])
        seen = np.column_stack([e1, np.cross(axle, e1), axle])
        found = np.array(rates(t, np.concatenate([state[:3], seen.ravel(), state[12:]]), **disk))
        found[3:12] = (np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) @ R).ravel()
        return found

    return function


multiplier_state_derivative = _away_from_flat(multiplier_state_derivative)
