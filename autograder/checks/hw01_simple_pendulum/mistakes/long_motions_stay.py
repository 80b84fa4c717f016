"""Of more than 150 sqrt(l/g) nothing is integrated: the start in every row, whose energy stays.

fails: simulate_keeps_the_energy
names: the pendulum does not move
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    if gravity and t[-1] - t[0] > 150 * math.sqrt(length / gravity):
        return np.tile([theta0, omega0], (len(t), 1))
    return _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
