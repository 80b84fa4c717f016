"""A sum over the first ends of the steps, with an error of the order of the step.

fails: action_is_the_integral
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.diff(theta) / step
    return step * np.sum(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta[:-1])))
