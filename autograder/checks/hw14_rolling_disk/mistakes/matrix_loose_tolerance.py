"""simulate_matrix uses tolerances of 1e-5.

fails: matrix_simulation_follows_the_motion, both_simulations_agree
numerics: tolerances of 1e-5
names: tighten rtol and atol
"""


def simulate_matrix(t, state, **disk):
    from scipy.integrate import solve_ivp

    def rates(time, y):
        return matrix_state_derivative(time, y, **disk)

    return solve_ivp(rates, (t[0], t[-1]), state, t_eval=t, rtol=1e-5, atol=1e-5).y.T
