"""The masses are points at the ends of the bars; here the bars are uniform.

fails: mass_matrix_makes_the_kinetic_energy, velocity_terms_are_centripetal, gravity_terms_are_moments_of_the_weights, accelerations_obey_the_equations, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling, simulation_follows_the_equations, small_oscillations_have_two_frequencies, tip_path_is_drawn
"""


def mass_matrix(theta, *, masses, lengths):
    m1, m2 = masses
    l1, l2 = lengths
    coupling = m2 * l1 * l2 * math.cos(theta[0] - theta[1])
    return np.array([[(m1 + m2) * l1**2, coupling], [coupling, m2 * l2**2]])


def velocity_terms(theta, omega, *, masses, lengths):
    lever = masses[1] * lengths[0] * lengths[1] * math.sin(theta[0] - theta[1])
    return np.array([lever * omega[1] ** 2, -lever * omega[0] ** 2])


def gravity_terms(theta, *, masses, lengths, gravity):
    return gravity * np.array([sum(masses), masses[1]]) * lengths * np.sin(theta)


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads = loads + gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return -np.linalg.solve(mass_matrix(theta, masses=masses, lengths=lengths), loads)


def energy(theta, omega, *, masses, lengths, gravity):
    y = np.cumsum(-np.asarray(lengths) * np.cos(theta))
    return omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2 + gravity * (masses @ y)


def simulate(t, theta, omega, **known):
    from scipy.integrate import solve_ivp

    rates = lambda _, y: [*y[2:], *angular_acceleration(y[:2], y[2:], **known)]
    return solve_ivp(rates, (t[0], t[-1]), [*theta, *omega], t_eval=t, rtol=1e-9, atol=1e-9).y.T


def small_oscillation_frequencies(*, masses, lengths, gravity):
    from scipy.linalg import eigh

    K = np.diag(gravity_terms(np.full(2, math.pi / 2), masses=masses, lengths=lengths, gravity=gravity))
    return np.sqrt(eigh(K, mass_matrix(np.zeros(2), masses=masses, lengths=lengths), eigvals_only=True))
