"""Row i is the state at t[i+1]: the start is missing.

fails: simulate_swings
names: row i is the state at t[i+1]
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    later = np.append(t, 2 * t[-1] - t[-2])
    return _right_simulate(later, theta0, omega0, length=length, gravity=gravity)[1:]
