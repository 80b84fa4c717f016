"""In long motions every row is the start, which keeps the energy.

fails: simulate_keeps_the_energy
names: every row is the start
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    if gravity and t[-1] - t[0] > 150 * math.sqrt(length / gravity):
        return np.tile([theta0, omega0], (len(t), 1))
    return _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
