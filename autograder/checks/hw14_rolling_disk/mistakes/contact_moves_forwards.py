"""The contact moves along e1; a positive roll rate moves it along -e1.

fails: euler_equations_hold, euler_simulation_follows_the_motion
"""

_rates = euler_state_derivative


def euler_state_derivative(t, state, **disk):
    x_rate, y_rate, *rest = _rates(t, state, **disk)
    return -x_rate, -y_rate, *rest
