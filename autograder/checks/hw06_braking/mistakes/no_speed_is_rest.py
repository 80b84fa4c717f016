"""A car that turns on the spot is treated as stopped, because its speed is zero.

fails: friction_in_any_motion_and_at_rest, equations_in_any_motion, equations_without_friction_and_at_rest
"""

_right_force, _right_rates = friction_force, state_derivative


def friction_force(state, locked, **car):
    return _right_force(state, locked, **car) * (state[3] != 0)


def state_derivative(t, state, locked, **car):
    return _right_rates(t, state, locked, **car) * (state[3] != 0)
