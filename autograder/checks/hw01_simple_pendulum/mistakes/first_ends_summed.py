"""The action leaves the last sample out of the sum.

fails: action_is_stationary_on_motions
numerics: an error of the order of the step
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step)
    energies = mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta))
    return step * np.sum(energies[:-1])
