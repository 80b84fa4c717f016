"""The action by differences of second order at the ends, too, which ask for three samples.

fails: action_is_the_integral
names: a path of two samples
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step, edge_order=2)
    values = mass * length * (length * omega**2 / 2 - gravity * (1 - np.cos(theta)))
    return step * (values.sum() - (values[0] + values[-1]) / 2)
