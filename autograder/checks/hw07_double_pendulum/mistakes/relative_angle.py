"""th2 is measured from bar 1; it should be from straight down.

fails: mass_matrix_makes_the_kinetic_energy, velocity_terms_are_centripetal, gravity_terms_are_moments_of_the_weights, accelerations_obey_the_equations, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling, simulation_follows_the_equations, wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
also: th2 is measured from bar 1, so that bar 2 is drawn at th1 + th2
"""

absolute = dict(globals())
B = np.array([[1.0, 0.0], [1.0, 1.0]])


def mass_matrix(theta, **known):
    return B.T @ absolute["mass_matrix"](B @ theta, **known) @ B


def velocity_terms(theta, omega, **known):
    return B.T @ absolute["velocity_terms"](B @ theta, B @ omega, **known)


def gravity_terms(theta, **known):
    return B.T @ absolute["gravity_terms"](B @ theta, **known)


def angular_acceleration(theta, omega, **known):
    return np.linalg.solve(B, absolute["angular_acceleration"](B @ theta, B @ omega, **known))


def energy(theta, omega, *, masses, lengths, gravity):
    th1, th2 = B @ theta
    heights = (masses[0] / 2 + masses[1]) * lengths[0] * np.cos(th1) + masses[1] * lengths[1] / 2 * np.cos(
        th2
    )
    return omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2 - gravity * heights


def angular_momentum(theta, omega, **known):
    return (mass_matrix(theta, **known) @ omega)[0]


def wireframe(theta, *, lengths):
    return absolute["wireframe"](B @ theta, lengths=lengths)


def simulate(t, theta, omega, **known):
    states = absolute["simulate"](t, B @ theta, B @ omega, **known)
    return states @ np.kron(np.eye(2), np.linalg.inv(B).T)
