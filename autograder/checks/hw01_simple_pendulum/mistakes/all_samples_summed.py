"""The first and last samples count whole; they should count half.

fails: action_is_stationary_on_motions
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step)
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta)))
