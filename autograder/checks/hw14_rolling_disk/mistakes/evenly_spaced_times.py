"""The times are treated as evenly spaced.

fails: euler_simulation_follows_the_motion
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    return _simulate(np.linspace(t[0], t[-1], len(t)), state, **disk)
