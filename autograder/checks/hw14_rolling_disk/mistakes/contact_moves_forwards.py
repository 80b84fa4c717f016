"""The contact moves along e1; at a positive roll rate it should move along -e1.

fails: euler_equations_hold, euler_simulation_follows_the_motion
"""

_rates = euler_state_derivative


def euler_state_derivative(t, state, **disk):
    x_rate, y_rate, *rest = _rates(t, state, **disk)
    return -x_rate, -y_rate, *rest
