"""multiplier_state_derivative calls matrix_state_derivative: this is one derivation, not two.

fails: multiplier_equations_hold
names: matrix_state_derivative
"""


def multiplier_state_derivative(t, state, **disk):
    return matrix_state_derivative(t, state, **disk)
