"""The tolerances that solve_ivp has when none are given.

fails: simulate_brakes
numerics: solve_ivp's own rtol of 1e-3
"""


def simulate(t, state, locked, **car):
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda s, y: state_derivative(s, y, locked, **car), (t[0], t[-1]), state, t_eval=t).y.T
