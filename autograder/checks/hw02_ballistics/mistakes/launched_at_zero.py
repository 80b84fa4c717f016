"""The simulation is launched at t = 0 instead of t[0].

fails: simulation_follows_the_motion
suspect: the given state taken for that at t = 0
"""


def simulate(t, speed, angle, **known):
    return trajectory(t, speed, angle, **known)
