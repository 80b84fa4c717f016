"""The times are taken for evenly spaced.

fails: simulation_follows_the_equations
suspect: the times taken to be evenly spaced
"""

at_the_times = simulate


def simulate(t, theta, omega, **known):
    return at_the_times(np.linspace(t[0], t[-1], len(t)), theta, omega, **known)
