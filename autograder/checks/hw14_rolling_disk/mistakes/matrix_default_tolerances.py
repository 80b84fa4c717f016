"""simulate_matrix uses the default tolerances of solve_ivp, which are too loose.

fails: matrix_simulation_follows_the_motion
numerics: solve_ivp's own rtol of 1e-3
names: tighten rtol and atol
"""


def simulate_matrix(t, state, **disk):
    from scipy.integrate import solve_ivp

    def rates(time, y):
        return matrix_state_derivative(time, y, **disk)

    return solve_ivp(rates, (t[0], t[-1]), state, t_eval=t).y.T
