"""The Lagrangian is summed over the samples, but not multiplied by the step.

fails: action_is_stationary_on_motions
"""

_right_action = action


def action(theta, step, **pendulum):
    return _right_action(theta, step, **pendulum) / step
