"""The action without its last step, by trapezoids.

fails: action_is_stationary_on_motions
suspect: leaves the last step out
"""

_right_action = action


def action(theta, step, **pendulum):
    return _right_action(theta[:-1], step, **pendulum)
