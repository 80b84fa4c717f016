"""The action as a sum over the left ends: an error of the order of the step.

fails: action_is_the_integral
suspect: a sum over the first ends
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.diff(theta) / step
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta[:-1])))
