"""The times taken to be evenly spaced.

fails: simulation_follows_the_motion
also: the times taken to be evenly spaced, the first step for all
"""


def simulate(t, speed, angle, **known):
    return trajectory(np.linspace(0, t[-1] - t[0], len(t)), speed, angle, **known)
