"""Both simulations damp the tilt by a millionth per unit of time, which keeps both integrals.

fails: energy_is_conserved
numerics: the loss of a method that damps
names: nearly right: is the tolerance tight
"""


def _damped(t, state, *, mass, radius, inertia, gravity):
    rates = list(euler_state_derivative(t, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity))
    rates[6] -= 1.3e-6 * math.sqrt(9.81 / radius) * state[6]
    return rates


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    return _states(_damped, t, state, mass, radius, inertia, gravity)


def _damped_matrix(t, state, *, mass, radius, inertia, gravity):
    rates = list(matrix_state_derivative(t, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity))
    sine = math.hypot(state[5], state[8])
    e1x, e1y = -state[8] / sine, state[5] / sine
    damping = 1.3e-6 * math.sqrt(9.81 / radius) * (state[12] * e1x + state[13] * e1y)
    rates[12] -= damping * e1x
    rates[13] -= damping * e1y
    return rates


def simulate_matrix(t, state, *, mass, radius, inertia, gravity):
    return _states(_damped_matrix, t, state, mass, radius, inertia, gravity)
