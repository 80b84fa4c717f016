"""The centripetal term is missing: the derivative of r . v = 0 is v . v + r . a = 0.

fails: force_keeps_the_particle_on_the_circle, without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, _, _ = state
    return mass * gravity * y / length**2 * np.array([x, y])


def simulate(t, state, *, mass, length, gravity):
    from scipy.integrate import solve_ivp

    def rates(t, s):
        pull = gravity * s[1] / (s[0] ** 2 + s[1] ** 2)
        return [s[2], s[3], pull * s[0], pull * s[1] - gravity]

    rows = solve_ivp(rates, (t[0], t[-1]), state, t_eval=t, rtol=1e-9, atol=1e-9).y.T
    return np.array([rows[0], *(consistent_state(row, length=length) for row in rows[1:])])
