"""The times taken to be evenly spaced.

fails: simulate_swings
also: the times taken to be evenly spaced, the first step for all
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    return _right_simulate(np.linspace(t[0], t[-1], len(t)), theta0, omega0, length=length, gravity=gravity)
