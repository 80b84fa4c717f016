"""The heading is wrapped in the given array: work on a copy.

fails: equations_of_motion, mechanics_refuses_other_axles
names: state_derivative changes the arrays
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    state[2] %= 2 * math.pi
    return _right(t, state, locked, **car)
