"""A disk without tilt rate and roll rate is said to be at rest.

fails: euler_equations_hold_next_to_flat_and_upright
"""


_derivative = euler_state_derivative


def euler_state_derivative(t, state, **disk):
    if state[6] == state[7] == 0.0:
        return [0.0] * 8
    return _derivative(t, state, **disk)
