"""solve_ivp runs at its default tolerances, which are too loose.

fails: simulate_swings
numerics: solve_ivp's own rtol of 1e-3
"""

def simulate(t, theta0, omega0, *, length, gravity):
    from scipy.integrate import solve_ivp

    def rates(_, y):
        return [y[1], -gravity * math.sin(y[0]) / length]

    return solve_ivp(rates, (t[0], t[-1]), [theta0, omega0], t_eval=t).y.T
