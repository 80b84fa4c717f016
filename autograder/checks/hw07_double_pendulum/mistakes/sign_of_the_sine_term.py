"""The velocity terms, sine times om^2, have the wrong sign.

fails: velocity_terms_are_centripetal, accelerations_obey_the_equations, simulation_follows_the_equations, tip_path_is_drawn
"""


def velocity_terms(theta, omega, *, masses, lengths):
    lever = masses[1] * lengths[0] * lengths[1] / 2 * math.sin(theta[1] - theta[0])
    return np.array([lever * omega[1] ** 2, -lever * omega[0] ** 2])


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads = loads + gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return -np.linalg.solve(mass_matrix(theta, masses=masses, lengths=lengths), loads)


def simulate(t, theta, omega, **known):
    from scipy.integrate import solve_ivp

    rates = lambda _, y: [*y[2:], *angular_acceleration(y[:2], y[2:], **known)]
    return solve_ivp(rates, (t[0], t[-1]), [*theta, *omega], t_eval=t, rtol=1e-9, atol=1e-9).y.T
