"""This is the integral of T + V; it should be the integral of T - V.

fails: action_is_stationary_on_motions
within: 1e-3
"""

def action(theta, step, *, mass, length, gravity):
    omega, middle = np.diff(theta) / step, (theta[:-1] + theta[1:]) / 2
    kinetic = mass * length**2 * omega**2 / 2
    return step * np.sum(kinetic + mass * gravity * length * (1 - np.cos(middle)))
