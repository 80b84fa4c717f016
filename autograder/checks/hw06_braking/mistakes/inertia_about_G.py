"""The inertia about G where that about the free axle belongs.

fails: equations_of_motion, simulate_brakes, growth_rate_is_the_slope, small_yaw_rate_is_the_linear_solution
also: the inertia about G in friction's part, where that about the free axle belongs
"""

_right = _car


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    return {**_right(locked, mass, yaw_inertia, front, rear, friction, gravity), "inertia": yaw_inertia}
