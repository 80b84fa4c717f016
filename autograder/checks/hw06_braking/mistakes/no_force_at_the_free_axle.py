"""Only friction turns the car about G; the free axle's force should turn it, too.

fails: growth_rate_is_the_slope
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    arm = front if locked == "front" else rear
    return -drag * arm * (front + rear) / (speed * yaw_inertia)
