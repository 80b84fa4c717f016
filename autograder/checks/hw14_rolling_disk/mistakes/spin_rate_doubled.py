"""The rate of the spin is twice the right one, so that only roll'' is off.

fails: euler_equations_hold, contact_force_moves_the_centre, euler_simulation_follows_the_motion
"""

_rates = euler_state_derivative


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    rates = np.array(_rates(t, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity))
    m = mass * radius**2
    rates[7] += m / (inertia[1] + m) * state[6] * state[5] * math.sin(state[3])
    return rates
