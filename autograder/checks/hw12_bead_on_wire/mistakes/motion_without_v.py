"""The motion lacks the term 4 c^2 x v^2 in x''.

fails: simulate_slides
"""


def simulate(t, x, v, *, curvature, gravity):
    from scipy.integrate import solve_ivp

    def rates(t, y):
        return y[1], -2 * curvature * gravity * y[0] / (1 + 4 * curvature**2 * y[0] ** 2)

    return solve_ivp(rates, (t[0], t[-1]), (x, v), t_eval=t, rtol=1e-9, atol=1e-9).y.T
