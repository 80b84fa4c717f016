"""The start is used at t = 0; it is the state at t[0].

fails: simulate_swings
names: the start is taken at t = 0
"""


def simulate(t, theta0, omega0, *, length, gravity):
    from scipy.integrate import solve_ivp

    rates = lambda _, y: [y[1], -gravity / length * np.sin(y[0])]
    found = solve_ivp(rates, (0, t[-1]), [theta0, omega0], dense_output=True, rtol=1e-9, atol=1e-9)
    states = found.sol(t).T
    states[0] = theta0, omega0
    return states
