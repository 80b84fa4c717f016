"""At rest the rates are zero over zero.

fails: equations_without_friction_and_at_rest
names: state_derivative returned NaN or infinity
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    return _right(t, state, locked, **car) / (1.0 if any(state[3:]) else math.nan)
