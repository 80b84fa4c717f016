"""The angle is treated as degrees; it is in radians.

fails: simulate_swings
"""

def simulate(t, theta0, omega0, *, length, gravity):
    from scipy.integrate import solve_ivp

    def rates(_, y):
        return [y[1], -gravity / length * math.sin(math.radians(y[0]))]

    return solve_ivp(rates, (t[0], t[-1]), [theta0, omega0], t_eval=t, rtol=1e-10, atol=1e-10).y.T
