"""The launch is used at t = 0; it is at t[0].

fails: simulation_follows_the_motion
"""


def simulate(t, speed, angle, **known):
    from scipy.integrate import solve_ivp

    start = [0, 0, speed * math.cos(angle), speed * math.sin(angle)]
    rates = lambda t, y: state_derivative(t, y, **known)
    return solve_ivp(rates, (0, t[-1]), start, dense_output=True, rtol=1e-9, atol=1e-9).sol(t).T
