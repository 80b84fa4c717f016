"""The launch is used at t = 0; it is at t[0].

fails: simulation_follows_the_motion
"""


def simulate(t, speed, angle, **known):
    return trajectory(t, speed, angle, **known)
