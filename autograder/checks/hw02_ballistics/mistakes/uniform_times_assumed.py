"""The simulation takes the times for evenly spaced.

fails: simulation_follows_the_motion
suspect: the times taken to be evenly spaced
"""


def simulate(t, speed, angle, **known):
    return trajectory(np.linspace(0, t[-1] - t[0], len(t)), speed, angle, **known)
