"""The rows lie on straight lines between the steps of the integrator.

fails: simulate_rolls_and_rocks
numerics: interpolation of the first order
names: do you interpolate linearly
"""


def simulate(t, phi, phi_dot, **cylinder):
    import numpy as np
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return state[1], acceleration(*state, **cylinder)

    found = solve_ivp(rates, (t[0], t[-1]), [phi, phi_dot], rtol=1e-7, atol=1e-7)
    return np.column_stack([np.interp(t, found.t, row) for row in found.y])
