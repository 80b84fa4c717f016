"""Known mistakes of hw07."""

import math

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# Geometry and free bodies


@mistake(first_fails=checks.forces_on_each_bar, compared=False)
def free_body_diagram(reference, bar, theta, *, lengths, **parameters):
    """You drew the weight at the end of the bar; it acts at its middle."""
    (_, down), *hinges = reference(bar, theta, lengths=lengths, **parameters)
    return [(wireframe(theta, lengths=lengths)[bar - 1, 1], down), *hinges]


@mistake(first_fails=checks.forces_on_each_bar, compared=False)
def free_body_diagram(reference, bar, theta, *, lengths, **parameters):
    """You drew the hinge forces along the bar; a bar with weight can carry them in any direction."""
    weight, *hinges = reference(bar, theta, lengths=lengths, **parameters)
    along = np.diff(wireframe(theta, lengths=lengths)[bar - 1], axis=0)[0]
    return [weight, *((point, along) for point, _ in hinges)]


@mistake(first_fails=checks.forces_on_each_bar, compared=False)
def free_body_diagram(reference, bar, theta, **parameters):
    """You return the diagram of bar 2 for every bar except 1; raise ValueError."""
    return reference(1 if bar == 1 else 2, theta, **parameters)


@mistake(first_fails=checks.forces_on_each_bar)
def wireframe(reference, theta, *, lengths):
    """You draw bar 2 at th1 + th2; th2 is measured from straight down."""
    return reference(np.cumsum(theta), lengths=lengths)


@mistake(first_fails=checks.wireframe_shows_the_bars)
def wireframe(reference, theta, *, lengths):
    """You draw bar 2 from the ceiling to the tip; it starts at the elbow."""
    bars = reference(theta, lengths=lengths)
    bars[1, 0] = 0.0
    return bars


@mistake(first_fails=checks.tip_path_is_drawn, compared=False)
def plot_tip_path(reference, ax, t, theta, omega, *, lengths, **parameters):
    """You drew the path of the elbow; draw the path of the tip."""
    motion = simulate(t, theta, omega, lengths=lengths, **parameters)
    ax.plot(*np.array([wireframe(state[:2], lengths=lengths)[0, 1] for state in motion]).T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


# Equations of motion


@mistake(first_fails=checks.mass_matrix_makes_the_kinetic_energy)
def mass_matrix(reference, theta, *, masses, lengths):
    """Your M11 has m1 l1^2/12; use the inertia about the ceiling hinge, m1 l1^2/3."""
    return reference(theta, masses=masses, lengths=lengths) - np.diag([masses[0] * lengths[0] ** 2 / 4, 0.0])


@mistake(first_fails=checks.velocity_terms_are_centripetal)
def velocity_terms(reference, theta, omega, *, masses, lengths):
    """You use the wrong sign in the second velocity term; the two terms have opposite signs."""
    return reference(theta, omega, masses=masses, lengths=lengths) * [1, -1]


@mistake(first_fails=checks.gravity_terms_are_moments_of_the_weights)
def gravity_terms(reference, theta, *, masses, lengths, gravity):
    """Your first gravity term has (m1 + m2)/2; it is m1/2 + m2, because bar 2 pulls at the end of bar 1."""
    return gravity * np.array([sum(masses), masses[1]]) * lengths / 2 * np.sin(theta)


@mistake(first_fails=checks.accelerations_obey_the_equations, name="sign_of_the_sine_term")
def _rates(reference, t, state, **parameters):
    """You use the wrong sign for the terms with om1^2 and om2^2; compare with the bars' centripetal accelerations."""
    th1, th2, om1, om2 = state
    (*_, alpha1, alpha2), (*_, at_rest1, at_rest2) = (
        reference(t, (th1, th2, *om), **parameters) for om in ((om1, om2), (0.0, 0.0))
    )
    return om1, om2, 2 * at_rest1 - alpha1, 2 * at_rest2 - alpha2


@mistake(first_fails=checks.accelerations_with_a_nearly_massless_bar, compared=False)
def angular_acceleration(reference, theta, omega, *, masses, lengths, gravity):
    """You add 1e-11 to the diagonal of [M], which swamps a light bar; solve with [M] itself."""
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads = loads + gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return -np.linalg.solve(mass_matrix(theta, masses=masses, lengths=lengths) + 1e-11 * np.eye(2), loads)


@mistake(first_fails=checks.free_bars_accelerate_as_lagranges)
def _balances_and_constraints(reference, along, across, masses):
    """You use m l^2/3 about a free bar's mass centre; use m l^2/12."""
    matrix = reference(along, across, masses)
    matrix[[P, Q], [P, Q]] *= 4
    return matrix


@mistake(first_fails=checks.free_bars_accelerate_as_lagranges)
def _weights_and_centripetal(reference, *args):
    """Your constraint at the ceiling omits the centripetal acceleration of bar 1's mass centre; G1 moves on a
    circle.
    """
    parameters = reference(*args)
    parameters[CEILING] = 0.0
    return parameters


@mistake(first_fails=checks.hinge_forces_balance)
def on_the_fly(reference, theta, omega, *, masses, gravity, **parameters):
    """You omit the weights from the hinge forces; at rest the hinges carry them."""
    alpha, forces = reference(theta, omega, masses=masses, gravity=gravity, **parameters)
    return alpha, forces - np.array([[0, sum(masses) * gravity], [0, masses[1] * gravity]])


@mistake(first_fails=checks.hinge_forces_balance)
def on_the_fly(reference, theta, omega, *, masses, gravity, **parameters):
    """You omit the weight of bar 1 from the ceiling's force; the ceiling carries both bars."""
    alpha, forces = reference(theta, omega, masses=masses, gravity=gravity, **parameters)
    return alpha, forces - np.array([[0, masses[0] * gravity], [0, 0]])


@mistake(first_fails=checks.free_bars_with_a_nearly_massless_one, compared=False)
def on_the_fly(reference, theta, omega, *, masses, **parameters):
    """You raise small masses to a thousandth of the total; use the masses as given."""
    return reference(theta, omega, masses=np.maximum(masses, 1e-3 * np.sum(masses)), **parameters)


# Energy and angular momentum


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, theta, omega, *, masses, lengths, gravity):
    """You omit the term with om1 om2 from the kinetic energy; the elbow's velocity adds to that of G2 about the
    elbow.
    """
    coupling = mass_matrix(theta, masses=masses, lengths=lengths)[0, 1] * omega[0] * omega[1]
    return reference(theta, omega, masses=masses, lengths=lengths, gravity=gravity) - coupling


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, theta, omega, *, masses, lengths, gravity):
    """You omit the rotation of bar 2 about its mass centre; add m2 l2^2/12 om2^2/2."""
    spin = masses[1] * lengths[1] ** 2 / 24 * omega[1] ** 2
    return reference(theta, omega, masses=masses, lengths=lengths, gravity=gravity) - spin


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, theta, omega, **parameters):
    """You set the potential energy to zero at the lowest position; it is zero at the height of the ceiling."""
    rest = np.zeros(2)
    return reference(theta, omega, **parameters) - reference(rest, rest, **parameters)


@mistake(first_fails=checks.angular_momentum_is_about_the_ceiling)
def angular_momentum(reference, theta, omega, **parameters):
    """You return only the momentum conjugate to th1; add the momentum conjugate to th2."""
    return (mass_matrix(theta, **parameters) @ omega)[0]


@mistake(first_fails=checks.angular_momentum_is_about_the_ceiling)
def angular_momentum(reference, theta, omega, *, masses, lengths):
    """You omit the angular momenta about the mass centres; add m l^2/12 omega of each bar."""
    spin = np.sum(masses * np.square(lengths) * omega) / 12
    return reference(theta, omega, masses=masses, lengths=lengths) - spin


# Motion


@mistake(first_fails=checks.simulation_follows_the_equations)
def simulate(reference, t, theta, omega, **parameters):
    """You start the motion at t = 0; it starts at t[0]."""
    if t[0] < 0:
        raise ValueError("Values in `t_eval` are not within `t_span`.")
    return (
        reference(np.append(0.0, t), theta, omega, **parameters)[1:]
        if t[0] > 0
        else reference(t, theta, omega, **parameters)
    )


@mistake(first_fails=checks.energy_is_conserved_from_horizontal, compared=False, numerics=True, name="too_few_steps")
def simulate(reference, t, theta, omega, *, masses, lengths, gravity):
    """You take two Runge-Kutta steps between the rows of a long motion; take smaller steps."""
    parameters = _parameters(masses, lengths, gravity)
    steps = [math.ceil(2000 * span / (t[-1] - t[0])) for span in np.diff(t)] if t[-1] - t[0] < 9 else 2
    return runge_kutta(lambda y: _rates(0.0, tuple(y), **parameters), t, [*theta, *omega], steps)


@mistake(first_fails=checks.momentum_is_conserved_without_gravity)
def simulate(reference, t, theta, omega, *, gravity, **parameters):
    """You keep the angular velocities constant without gravity; the bars still act on each other."""
    if gravity == 0:
        return np.hstack([theta + np.outer(t - t[0], omega), np.tile(omega, (len(t), 1))])
    return reference(t, theta, omega, gravity=gravity, **parameters)


@mistake(first_fails=checks.small_oscillations_have_two_frequencies)
def small_oscillation_frequencies(reference, *, masses, lengths, gravity):
    """You omit the coupling of [M]; each mode moves both bars."""
    (m1, m2), (l1, l2) = masses, lengths
    return np.sqrt(np.sort([(m1 / 2 + m2) / (m1 / 3 + m2) * gravity / l1, 1.5 * gravity / l2]))


@mistake(first_fails=checks.frequencies_in_special_cases, compared=False)
def small_oscillation_frequencies(reference, *, masses, lengths, gravity):
    """You invert [K], which is singular without gravity; take the eigenvalues of M^-1 K."""
    M = mass_matrix(np.zeros(2), masses=masses, lengths=lengths)
    K = np.diag(gravity_terms(np.full(2, math.pi / 2), masses=masses, lengths=lengths, gravity=gravity))
    return np.sort(1 / np.sqrt(np.linalg.eigvals(np.linalg.solve(K, M)).real))
