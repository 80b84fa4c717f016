"""The equations with multipliers have C/2 where A belongs, as for a thin disk.

fails: multiplier_equations_hold
"""

_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, *, inertia, **disk):
    return _rates(t, state, inertia=(inertia[1] / 2, inertia[1]), **disk)
