"""The rows are at evenly spaced times, not at the times in t.

fails: simulation_follows_the_motion
"""


def simulate(t, speed, angle, **known):
    return trajectory(np.linspace(0, t[-1] - t[0], len(t)), speed, angle, **known)
