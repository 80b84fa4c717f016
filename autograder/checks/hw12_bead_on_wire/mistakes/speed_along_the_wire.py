"""The state holds the speed along the wire; v is the rate of x.

fails: simulate_slides
"""


def simulate(t, x, v, *, curvature, gravity):
    from scipy.integrate import solve_ivp

    def rates(t, state):
        slope = 2 * curvature * state[0]
        root = math.sqrt(1 + slope**2)
        return [state[1] / root, -gravity * slope / root]

    return solve_ivp(rates, (t[0], t[-1]), [x, v], t_eval=t, rtol=1e-10, atol=1e-10).y.T
