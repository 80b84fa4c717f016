"""The action has the potential energy of small angles, which holds only there.

fails: action_is_stationary_on_motions
within: 1e-3
"""

def action(theta, step, *, mass, length, gravity):
    omega, middle = np.diff(theta) / step, (theta[:-1] + theta[1:]) / 2
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * middle**2 / 2)
