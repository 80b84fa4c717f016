"""The square of the yaw rate has one sign in the speed's rate, whichever axle is locked.

fails: equations_of_motion, simulate_brakes
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    turning = (arm * left + mass * free * speed * yaw_rate) / inertia
    return forward / mass - abs(free) * yaw_rate * yaw_rate, turning
