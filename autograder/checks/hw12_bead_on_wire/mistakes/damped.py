"""A small friction slows the bead.

fails: simulate_slides
names: x'' as in part (a)
"""


def simulate(t, x, v, *, curvature, gravity):
    from scipy.integrate import solve_ivp

    def rates(t, y):
        return y[1], acceleration_newton(y[0], y[1], curvature=curvature, gravity=gravity) - 0.003 * y[1]

    return solve_ivp(rates, (t[0], t[-1]), (x, v), t_eval=t, rtol=1e-9, atol=1e-9).y.T
