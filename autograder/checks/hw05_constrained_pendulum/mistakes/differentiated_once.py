"""The centripetal term is missing: the derivative of r . v = 0 is v . v + r . a = 0.

fails: force_keeps_the_particle_on_the_circle, acceleration_is_that_of_both_forces, without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, _, _ = state
    return mass * gravity * y / length**2 * np.array([x, y])


def acceleration(state, *, mass, length, gravity):
    return constraint_force(state, mass=mass, length=length, gravity=gravity) / mass - np.array([0, gravity])


def simulate(t, state, *, mass, length, gravity):
    from scipy.integrate import solve_ivp

    def f(s, y):
        return [*y[2:], *acceleration(y, mass=mass, length=length, gravity=gravity)]

    return solve_ivp(f, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=1e-10, atol=1e-10).y.T
