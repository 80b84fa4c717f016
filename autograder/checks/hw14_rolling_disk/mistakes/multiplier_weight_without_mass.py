"""The weight stands in the balance of momentum as g, beside the mass times the acceleration.

fails: multiplier_equations_hold
suspect: the weight without the mass
"""

_rates = multiplier_state_derivative


def multiplier_state_derivative(t, state, *, mass, gravity, **disk):
    return _rates(t, state, mass=mass, gravity=gravity / mass, **disk)
