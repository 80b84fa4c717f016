"""The term with mass, speed and yaw rate (m d v omega) is missing from the turning.

fails: equations_of_motion, simulate_brakes
also: The yaw rate has only friction's part, a power of the speed; the exponential is missing
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    return forward / mass - free * yaw_rate * yaw_rate, arm * left / inertia
