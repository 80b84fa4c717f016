"""G's velocity to the side has the wrong sign in the rate of y.

fails: equations_of_motion, simulate_brakes
"""


def _rates(t, state, *, free, **car):
    x, y, heading, speed, yaw_rate = state
    sideways = -free * yaw_rate
    c, s = math.cos(heading), math.sin(heading)
    rates = _accelerations(speed, yaw_rate, free=free, **car)
    return speed * c - sideways * s, speed * s - sideways * c, yaw_rate, *rates
