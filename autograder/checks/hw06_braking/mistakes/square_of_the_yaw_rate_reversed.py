"""In your rate of the speed the term with yaw_rate^2 has one sign; it changes sign with the locked axle.

fails: equations_of_motion, simulate_brakes
"""


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    forward, left = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    turning = (arm * left + mass * free * speed * yaw_rate) / inertia
    return forward / mass - abs(free) * yaw_rate * yaw_rate, turning
