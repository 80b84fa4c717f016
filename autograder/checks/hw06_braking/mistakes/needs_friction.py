"""The rates are divided by friction, which may be zero.

fails: equations_without_friction_and_at_rest
names: state_derivative raised ZeroDivisionError
"""

_right = state_derivative


def state_derivative(t, state, locked, *, friction, **car):
    return _right(t, state, locked, friction=friction, **car) * (friction / friction)
