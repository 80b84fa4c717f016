"""The rows are at evenly spaced times, not at the times in t.

fails: simulate_swings
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    return _right_simulate(np.linspace(t[0], t[-1], len(t)), theta0, omega0, length=length, gravity=gravity)
