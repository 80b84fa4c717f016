"""The sign of the term with the square of the yaw rate, for one of the axles.

fails: equations_of_motion, simulate_brakes
suspect: with one sign, whichever axle is locked
names: in axes that turn
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    turning = (arm * left + mass * free * speed * yaw_rate) / inertia
    return forward / mass - abs(free) * yaw_rate * yaw_rate, turning
