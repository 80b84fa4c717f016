"""The rates are divided by friction: none without.

fails: equations_without_friction_and_at_rest
"""

_right = state_derivative


def state_derivative(t, state, locked, *, friction, **car):
    return _right(t, state, locked, friction=friction, **car) * (friction / friction)
