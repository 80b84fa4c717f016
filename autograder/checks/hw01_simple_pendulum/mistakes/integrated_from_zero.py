"""The integration begins at t = 0, wherever the times do.

fails: simulate_swings
names: The start is taken at t = 0
"""

def simulate(t, theta0, omega0, *, length, gravity):
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return state[1], -gravity / length * math.sin(state[0])

    return solve_ivp(rates, (0, t[-1]), [theta0, omega0], t_eval=t, rtol=1e-9, atol=1e-9).y.T
