"""Fewer than four samples give no action.

fails: action_is_the_integral
names: without gravity, two samples
"""

_right_action = action


def action(theta, step, **pendulum):
    return _right_action(theta, step, **pendulum) if len(theta) > 3 else 0.0
