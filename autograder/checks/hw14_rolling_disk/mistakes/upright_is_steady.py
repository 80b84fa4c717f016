"""A disk without tilt rate and roll rate is treated as at rest.

fails: euler_equations_hold, euler_simulation_follows_the_motion, contact_force_moves_the_centre
"""


_derivative = euler_state_derivative


def euler_state_derivative(t, state, **disk):
    if state[6] == state[7] == 0.0:
        return [0.0] * 8
    return _derivative(t, state, **disk)
