"""A coefficient of friction above 1 is replaced by 1.

fails: friction_in_any_motion_and_at_rest, equations_without_friction_and_at_rest, simulate_needs_no_dense_times, growth_rate_is_the_slope, critical_speed_is_where_growth_begins, small_yaw_rate_is_the_linear_solution
"""

_right_force, _right_car, _right_critical = friction_force, _car, critical_speed


def friction_force(state, locked, *, friction, **car):
    return _right_force(state, locked, friction=min(friction, 1.0), **car)


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    return _right_car(locked, mass, yaw_inertia, front, rear, min(friction, 1.0), gravity)


def critical_speed(locked, *, friction, **car):
    return _right_critical(locked, friction=min(friction, 1.0), **car)
