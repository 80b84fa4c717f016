"""The tensor of inertia has C/2 for A, as that of a thin disk.

fails: multiplier_equations_hold
suspect: C/2 for A
"""

_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, *, inertia, **disk):
    return _rates(t, state, inertia=(inertia[1] / 2, inertia[1]), **disk)
