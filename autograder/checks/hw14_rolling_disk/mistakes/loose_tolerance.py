"""solve_ivp runs at its default tolerances, which are too loose.

fails: euler_simulation_follows_the_motion
numerics: solve_ivp's own rtol of 1e-3
"""


def simulate_euler(t, state, **disk):
    from scipy.integrate import solve_ivp

    return solve_ivp(
        lambda time, y: euler_state_derivative(time, y, **disk), (t[0], t[-1]), state, t_eval=t
    ).y.T
