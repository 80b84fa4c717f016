"""Every launch counts as one upwards.

fails: simulation_follows_the_motion
"""

_right_simulate = simulate


def simulate(t, speed, angle, *, mass, drag, gravity):
    return _right_simulate(t, speed, abs(angle), mass=mass, drag=drag, gravity=gravity)
