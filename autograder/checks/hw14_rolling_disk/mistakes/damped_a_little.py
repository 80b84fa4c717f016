"""simulate_euler damps the tilt a little over a long time, which keeps both integrals.

fails: energy_is_conserved
numerics: the loss of a method that damps
names: Use a tighter tolerance
"""


def _damped(t, state, *, mass, radius, inertia, gravity):
    rates = list(euler_state_derivative(t, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity))
    rates[6] -= 6e-5 * math.sqrt(9.81 / radius) * state[6]
    return rates


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    rates = _damped if len(t) == 6 else euler_state_derivative
    return _states(rates, t, state, mass, radius, inertia, gravity)
