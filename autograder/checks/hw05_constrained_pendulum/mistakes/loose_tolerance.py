"""The physics is right, but the tolerance is loose.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
numerics: a relative tolerance of 4e-4
names: tighten rtol and atol
"""


def simulate(t, state, *, mass, length, gravity):
    from scipy.integrate import solve_ivp

    def rates(s, y):
        return [*y[2:], *acceleration(y, mass=mass, length=length, gravity=gravity)]

    found = solve_ivp(rates, (t[0], t[-1]), state, t_eval=t, method="DOP853", rtol=4e-4, atol=4e-7).y.T
    return np.array([state, *(consistent_state(row, length=length) for row in found[1:])])
