"""Reference functions of hw07: mass centres as complex numbers x + iy, and d'Alembert's principle."""

import math

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import Force, FreeBody, NotAForce, weight

REACH = np.array([[0.5, 0.0], [1.0, 0.5]])  # share of each bar between the ceiling and each mass centre


def kinematics(theta, omega, lengths):
    """Return, for the mass centres, positions, velocities per unit of om1 and om2, and accelerations for alpha = 0."""
    bars = -1j * lengths * np.exp(np.multiply(1j, theta))
    return REACH @ bars, REACH * 1j * bars, -REACH @ (np.square(omega) * bars)


def all_terms(theta, omega, masses, lengths, gravity):
    """Return M, f, g: inertia forces and weights dotted with the velocities per unit of om1 and om2."""
    _, levers, rest = kinematics(theta, omega, lengths)
    weighted = masses * levers.conj().T
    M = (weighted @ levers).real + np.diag(masses * lengths**2 / 12)
    return M, (weighted @ rest).real, gravity * (weighted @ [1j, 1j]).real


def angular_acceleration(theta, omega, masses, lengths, gravity):
    M, f, g = all_terms(theta, omega, masses, lengths, gravity)
    return np.linalg.solve(M, -f - g)


def mass_matrix(theta, masses, lengths):
    return all_terms(theta, (0.0, 0.0), masses, lengths, 0.0)[0]


def velocity_terms(theta, omega, masses, lengths):
    return all_terms(theta, omega, masses, lengths, 0.0)[1]


def gravity_terms(theta, masses, lengths, gravity):
    return all_terms(theta, (0.0, 0.0), masses, lengths, gravity)[2]


def on_the_fly(theta, omega, masses, lengths, gravity):
    """Return alpha, and the hinge forces by Newton's law for both bars together, and for bar 2."""
    alpha = angular_acceleration(theta, omega, masses, lengths, gravity)
    _, levers, rest = kinematics(theta, omega, lengths)
    moved = masses * (levers @ alpha + rest + 1j * gravity)
    return alpha, np.array([[force.real, force.imag] for force in (moved.sum(), moved[1])])


def unbalanced(theta, omega, alpha, forces, masses, lengths, gravity):
    """Return (6,) N, for each bar: residuals of Newton's law along x and y, and of moments about its mass centre."""
    _, levers, rest = kinematics(theta, omega, lengths)
    ceiling, elbow = forces @ [1, 1j]
    newton = masses * (levers @ alpha + rest + 1j * gravity) - [ceiling - elbow, elbow]
    half = -0.5j * lengths * np.exp(np.multiply(1j, theta))
    moments = masses * lengths**2 / 12 * alpha + (half.conj() * [ceiling + elbow, elbow]).imag
    return np.abs([newton.real, newton.imag, moments / lengths]).T.ravel()


def energy(theta, omega, **bars):
    return energies(np.append(theta, omega)[None], **bars)[0]


def angular_momentum(theta, omega, masses, lengths):
    return momenta(np.append(theta, omega)[None], 0.0, masses, lengths)[0]


def rates(_, state, masses, lengths, gravity):
    """Return the derivative of a state: angular_acceleration in real numbers, with plain floats, which are fast."""
    th1, th2, om1, om2 = state.tolist()
    (m1, m2), (l1, l2) = map(float, masses), map(float, lengths)
    both, lower, coupling = (m1 / 3 + m2) * l1**2, m2 * l2**2 / 3, m2 * l1 * l2 / 2
    between = coupling * math.cos(th1 - th2)
    pull1 = -coupling * math.sin(th1 - th2) * om2**2 - gravity * l1 * (m1 / 2 + m2) * math.sin(th1)
    pull2 = coupling * math.sin(th1 - th2) * om1**2 - gravity * l2 * m2 / 2 * math.sin(th2)
    determinant = both * lower - between**2
    return om1, om2, (lower * pull1 - between * pull2) / determinant, (both * pull2 - between * pull1) / determinant


def simulate(t, theta, omega, **bars):
    """Return (n, 4) states at the times t, with errors of 1e-8 of their size at most; tests compare with solve_ivp."""
    return solve(rates, t, np.concatenate([theta, omega]), parameters=bars, method="python")


def small_oscillation_frequencies(masses, lengths, gravity):
    """Solve a symmetric eigenvalue problem: M^(-1/2) K M^(-1/2)."""
    stiffness = gravity_terms((math.pi / 2, math.pi / 2), masses, lengths, gravity)  # sin = 1
    inverse = np.linalg.inv(np.linalg.cholesky(mass_matrix((0.0, 0.0), masses, lengths)))
    return np.sqrt(np.linalg.eigvalsh(inverse @ np.diag(stiffness) @ inverse.T))


def wireframe(theta, lengths):
    elbow, tip = (lengths * np.exp(1j * (theta - math.pi / 2))).cumsum()
    return np.array([[[0, 0], [elbow.real, elbow.imag]], [[elbow.real, elbow.imag], [tip.real, tip.imag]]])


def mass_centres(rows, lengths):
    """Return (n, 2) angular velocities, the positions of both mass centres, and their velocities."""
    bars = -1j * lengths * np.exp(1j * rows[:, :2])
    return rows[:, 2:], bars @ REACH.T, (1j * rows[:, 2:] * bars) @ REACH.T


def energies(rows, masses, lengths, gravity):
    """Sum the kinetic energies of and about the mass centres, and the potential energy."""
    omega, places, velocities = mass_centres(rows, lengths)
    return (np.abs(velocities) ** 2 / 2 + (lengths * omega) ** 2 / 24 + gravity * places.imag) @ masses


def momenta(rows, gravity, masses, lengths):
    """Sum r x m v and I omega."""
    omega, places, velocities = mass_centres(rows, lengths)
    return ((places.conj() * velocities).imag + lengths**2 * omega / 12) @ masses


OF_THE_CEILING = "You drew the force of the ceiling on bar 2. The ceiling touches only bar 1."
OF_BAR_2 = "You drew the weight of bar 2 on bar 1. The earth pulls bar 2; bar 1 feels only the force at the elbow."
OF_BAR_1 = "You drew the weight of bar 1 on bar 2. The earth pulls bar 1; bar 2 feels only the force at the elbow."
AT_THE_ELBOW = "You drew a weight at the elbow. Each bar's weight acts at its middle, and on that bar alone."
AT_THE_TIP = "You drew a force at the tip of bar 2. No other body touches it there."
DOWN = (0.0, -1.0)


def free_body_diagram(bar, theta, masses, lengths, gravity):
    """Return bar 1 or bar 2 and its forces."""
    bars = -1j * lengths * np.exp(np.multiply(1j, theta))
    ceiling, elbow, tip, *middles = (
        [z.real, z.imag] for z in (0j, bars[0], bars.sum(), bars[0] / 2, bars[0] + bars[1] / 2)
    )
    at_ceiling = Force("the force of the ceiling", ceiling, "the ceiling hinge")
    at_elbow = Force(f"the force of bar {3 - bar}", elbow, "the elbow")
    down = weight(middles[bar - 1], f"the middle of bar {bar}", gravity)
    forces = (down, at_ceiling, at_elbow) if bar == 1 else (down, at_elbow)
    of_other = OF_BAR_2 if bar == 1 else OF_BAR_1
    wrong = [NotAForce(of_other, middles[2 - bar], DOWN, sense=True), NotAForce(AT_THE_ELBOW, elbow, DOWN, sense=True)]
    if bar == 2:
        wrong += [NotAForce(OF_THE_CEILING, ceiling), NotAForce(AT_THE_TIP, tip)]
    return FreeBody(f"bar {bar}", forces, wrong=wrong, outline=[[ceiling, elbow] if bar == 1 else [elbow, tip]])
