"""solve_ivp runs at its default tolerances, which are too loose.

fails: simulate_slides
numerics: solve_ivp's own rtol of 1e-3
"""

def simulate(t, x, v, *, curvature, gravity):
    from scipy.integrate import solve_ivp

    def rates(t, y):
        return y[1], acceleration_newton(y[0], y[1], curvature=curvature, gravity=gravity)

    return solve_ivp(rates, (t[0], t[-1]), (x, v), t_eval=t).y.T
