"""The action sums the first ends of the steps, which is of first order in the step.

fails: action_is_the_integral
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.diff(theta) / step
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta[:-1])))
