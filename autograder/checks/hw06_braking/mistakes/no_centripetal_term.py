"""Speed changes by friction alone.

fails: equations_of_motion, simulate_brakes
suspect: square of the yaw rate
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    return forward / mass, (arm * left + mass * free * speed * yaw_rate) / inertia
