"""The times are treated as evenly spaced.

fails: simulation_follows_the_equations
"""

at_the_times = simulate


def simulate(t, theta, omega, **known):
    return at_the_times(np.linspace(t[0], t[-1], len(t)), theta, omega, **known)
