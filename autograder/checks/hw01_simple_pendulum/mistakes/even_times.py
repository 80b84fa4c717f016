"""As many even times in place of the times asked for.

fails: simulate_swings
suspect: the times taken to be evenly spaced
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    return _right_simulate(np.linspace(t[0], t[-1], len(t)), theta0, omega0, length=length, gravity=gravity)
