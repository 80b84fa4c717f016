"""The action as a sum over all samples, where a trapezoid takes half of the first and of the last.

fails: action_is_stationary_on_motions
suspect: counted whole
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step)
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta)))
