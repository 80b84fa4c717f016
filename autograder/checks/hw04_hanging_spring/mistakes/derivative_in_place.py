"""The rates replace the given state; work on a copy.

fails: derivative_is_velocity_and_force_over_mass
names: state_derivative changes the arrays
"""

def _rates(t, y, k, g):
    return y[3], y[4], y[5], -k * y[0], -k * y[1], -k * y[2] - g


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    from tam570.integrate import solve

    return solve(_rates, t, (*position, *velocity), parameters={"k": stiffness / mass, "g": gravity}, rtol=1e-12)


def state_derivative(t, state, *, mass, stiffness, gravity):
    k = stiffness / mass
    state[:3], state[3:] = state[3:].copy(), -k * state[:3]
    state[5] -= gravity
    return state
