"""The action takes differences of second order at the ends, which fail for two samples.

fails: action_is_the_integral
names: ValueError for a pendulum that turns evenly, without gravity, two samples
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step, edge_order=2)
    values = mass * length**2 * omega**2 / 2 - 2 * mass * gravity * length * np.sin(theta / 2) ** 2
    return step * (np.sum(values) - (values[0] + values[-1]) / 2)
