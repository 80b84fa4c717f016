"""The term with the square of the yaw rate is missing from the speed's rate.

fails: equations_of_motion, simulate_brakes
also: The square of the yaw rate has one sign in the speed's rate, whichever axle is locked
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    return forward / mass, (arm * left + mass * free * speed * yaw_rate) / inertia
