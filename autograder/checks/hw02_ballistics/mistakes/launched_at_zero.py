"""The given state taken for that at t = 0, where it is that at t[0].

fails: simulation_follows_the_motion
also: the given state taken for that at t = 0, where it is that at t[0], and no times before 0
"""


def simulate(t, speed, angle, **known):
    return trajectory(t, speed, angle, **known)
