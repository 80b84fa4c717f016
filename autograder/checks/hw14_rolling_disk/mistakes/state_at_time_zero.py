"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: euler_simulation_follows_the_motion
"""

_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    from scipy.integrate import solve_ivp

    def rates(time, y):
        return euler_state_derivative(time, y, **disk)

    there = solve_ivp(rates, (0.0, t[0]), state, method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    return _simulate(t, there, **disk)
