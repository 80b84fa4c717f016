"""The action as a sum over the samples but the last, with omega by central differences.

fails: action_is_stationary_on_motions
names: is the quadrature of second order
numerics: an error of the order of the step
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step)
    energies = mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta))
    return step * np.sum(energies[:-1])
