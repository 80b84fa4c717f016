"""simulate_matrix joins the steps of an integrator with a tight tolerance by straight lines.

fails: matrix_simulation_follows_the_motion, both_simulations_agree
numerics: interpolation of the first order
names: do you interpolate linearly
"""


def simulate_matrix(t, state, **disk):
    from scipy.integrate import solve_ivp

    found = solve_ivp(
        lambda time, y: matrix_state_derivative(time, y, **disk), (t[0], t[-1]), state, rtol=1e-9, atol=1e-9
    )
    return np.column_stack([np.interp(t, found.t, row) for row in found.y])
