"""The inertia about G stands where the inertia about the free axle belongs.

fails: equations_of_motion, simulate_brakes, growth_rate_is_the_slope, small_yaw_rate_is_the_linear_solution
also: Friction's part has the inertia about G where the inertia about the free axle belongs
"""

_right = _car


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    return {**_right(locked, mass, yaw_inertia, front, rear, friction, gravity), "inertia": yaw_inertia}
