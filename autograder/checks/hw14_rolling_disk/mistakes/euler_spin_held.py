"""The spin about the axle is kept, as if friction had no moment about it.

fails: euler_equations_hold, euler_simulation_follows_the_motion, contact_force_moves_the_centre
"""

_right_derivative = euler_state_derivative


def euler_state_derivative(t, state, **disk):
    rates = np.array(_right_derivative(t, state, **disk))
    tilt, (yaw_rate, tilt_rate) = state[3], state[5:7]
    rates[7] = yaw_rate * tilt_rate * math.sin(tilt) - rates[5] * math.cos(tilt)
    return rates
