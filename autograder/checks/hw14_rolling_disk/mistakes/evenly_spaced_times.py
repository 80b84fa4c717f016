"""simulate_euler takes the times to be evenly spaced.

fails: euler_simulation_follows_the_motion
suspect: evenly spaced
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    return _simulate(np.linspace(t[0], t[-1], len(t)), state, **disk)
