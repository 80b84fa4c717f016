"""The weight lacks the mass.

fails: multiplier_equations_hold
"""

_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, *, mass, gravity, **disk):
    return _rates(t, state, mass=mass, gravity=gravity / mass, **disk)
