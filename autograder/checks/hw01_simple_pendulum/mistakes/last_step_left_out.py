"""The action leaves the last step out of the sum.

fails: action_is_stationary_on_motions
within: 5e-05
"""

_right_action = action


def action(theta, step, **pendulum):
    return _right_action(theta[:-1], step, **pendulum)
