"""The moments about the free axle turn the inertia about G.

fails: equations_of_motion, simulate_brakes, growth_rate_is_the_slope, small_yaw_rate_is_the_linear_solution
suspect: inertia about G
"""

_right = _car


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    return {**_right(locked, mass, yaw_inertia, front, rear, friction, gravity), "inertia": yaw_inertia}
