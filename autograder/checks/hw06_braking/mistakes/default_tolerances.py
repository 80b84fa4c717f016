"""The tolerances are solve_ivp's defaults.

fails: simulate_brakes, simulate_needs_no_dense_times, simulate_glides_without_friction, simulate_comes_to_rest_and_stays
numerics: solve_ivp's own rtol of 1e-3
names: tighten rtol and atol
"""


def simulate(t, state, locked, **car):
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda s, y: state_derivative(s, y, locked, **car), (t[0], t[-1]), state, t_eval=t).y.T
