"""The action is right, but the path that it was given is changed.

fails: action_is_stationary_on_motions
names: action changes the arrays
"""

def action(theta, step, *, mass, length, gravity):
    omega = np.diff(theta) / step
    kinetic = np.sum(mass * length**2 * omega**2 / 2)
    theta += np.append(np.diff(theta) / 2, 0.0)
    return step * (kinetic - np.sum(mass * gravity * length * (1 - np.cos(theta[:-1]))))
