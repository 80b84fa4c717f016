"""The action of fewer than four samples is 0; two samples have one, too.

fails: action_is_the_integral
"""

_right_action = action


def action(theta, step, **pendulum):
    return _right_action(theta, step, **pendulum) if len(theta) > 3 else 0.0
