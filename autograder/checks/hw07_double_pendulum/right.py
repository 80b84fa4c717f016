"""What is right in hw07, by another route than the solution's: the motion of the two mass centres as complex numbers,
x + iy, and d'Alembert's principle.
"""

import cmath
import math

import numpy as np

from tam570.integrate import solve


def kinematics(theta, omega, lengths):
    """Of each mass centre: its place, the velocities per unit of om1 and om2, the acceleration without alpha."""
    (l1, l2), (om1, om2) = lengths, omega
    bar1, bar2 = -1j * l1 * cmath.exp(1j * theta[0]), -1j * l2 * cmath.exp(1j * theta[1])
    places = bar1 / 2, bar1 + bar2 / 2
    levers = (1j * bar1 / 2, 0j), (1j * bar1, 1j * bar2 / 2)
    rest = -(om1**2) * bar1 / 2, -(om1**2) * bar1 - om2**2 * bar2 / 2
    return places, levers, rest


def dot(a, b):
    return (a.conjugate() * b).real


def terms(theta, omega, masses, lengths, gravity):
    """M, f, g: inertia forces and weights dotted with the velocities per unit of om1 and om2."""
    _, (one, two), rest = kinematics(theta, omega, lengths)
    (m1, m2), (l1, l2) = masses, lengths
    coupling = m1 * dot(one[0], one[1]) + m2 * dot(two[0], two[1])
    M = [
        [m1 * dot(one[0], one[0]) + m2 * dot(two[0], two[0]) + m1 * l1**2 / 12, coupling],
        [coupling, m1 * dot(one[1], one[1]) + m2 * dot(two[1], two[1]) + m2 * l2**2 / 12],
    ]
    f = [m1 * dot(a, rest[0]) + m2 * dot(b, rest[1]) for a, b in zip(one, two, strict=True)]
    g = [gravity * (m1 * a.imag + m2 * b.imag) for a, b in zip(one, two, strict=True)]
    return M, f, g


def angular_acceleration(theta, omega, masses, lengths, gravity):
    M, f, g = terms(theta, omega, masses, lengths, gravity)
    pull1, pull2 = -f[0] - g[0], -f[1] - g[1]
    determinant = M[0][0] * M[1][1] - M[0][1] * M[1][0]
    return (M[1][1] * pull1 - M[0][1] * pull2) / determinant, (M[0][0] * pull2 - M[1][0] * pull1) / determinant


def mass_matrix(theta, masses, lengths):
    return np.array(terms(theta, (0.0, 0.0), masses, lengths, 0.0)[0])


def velocity_terms(theta, omega, masses, lengths):
    return np.array(terms(theta, omega, masses, lengths, 0.0)[1])


def gravity_terms(theta, masses, lengths, gravity):
    return np.array(terms(theta, (0.0, 0.0), masses, lengths, gravity)[2])


def on_the_fly(theta, omega, masses, lengths, gravity):
    """The hinge forces by Newton's law for bar 2, and for both bars together."""
    al1, al2 = angular_acceleration(theta, omega, masses, lengths, gravity)
    _, levers, rest = kinematics(theta, omega, lengths)
    moved = [
        m * (lever[0] * al1 + lever[1] * al2 + a + 1j * gravity)
        for m, lever, a in zip(masses, levers, rest, strict=True)
    ]
    return np.array([al1, al2]), np.array([[sum(moved).real, sum(moved).imag], [moved[1].real, moved[1].imag]])


def energy(theta, omega, masses, lengths, gravity):
    places, M = kinematics(theta, omega, lengths)[0], mass_matrix(theta, masses, lengths)
    return omega @ M @ omega / 2 + gravity * (masses[0] * places[0].imag + masses[1] * places[1].imag)


def angular_momentum(theta, omega, masses, lengths):
    """Sum of r x m v and I omega."""
    places, levers, _ = kinematics(theta, omega, lengths)
    velocities = [lever[0] * omega[0] + lever[1] * omega[1] for lever in levers]
    orbital = [m * (r.conjugate() * v).imag for m, r, v in zip(masses, places, velocities, strict=True)]
    return sum(orbital) + np.sum(masses * lengths**2 * omega) / 12


def rates(_, state, masses, lengths, gravity):
    """The derivative of a state: angular_acceleration in real numbers, of which the integrator makes a fast program."""
    th1, th2, om1, om2 = state
    (m1, m2), (l1, l2) = masses, lengths
    both, lower, coupling = (m1 / 3 + m2) * l1**2, m2 * l2**2 / 3, m2 * l1 * l2 / 2
    between = coupling * np.cos(th1 - th2)
    pull1 = -coupling * np.sin(th1 - th2) * om2**2 - gravity * l1 * (m1 / 2 + m2) * np.sin(th1)
    pull2 = coupling * np.sin(th1 - th2) * om1**2 - gravity * l2 * m2 / 2 * np.sin(th2)
    determinant = both * lower - between**2
    return om1, om2, (lower * pull1 - between * pull2) / determinant, (both * pull2 - between * pull1) / determinant


def simulate(t, theta, omega, **known):
    """(n, 4) states at the times t; tests hold it to angular_acceleration, and to solve_ivp."""
    return solve(rates, t, np.concatenate([theta, omega]), parameters=known, rtol=1e-12, method="python")


def small_oscillation_frequencies(masses, lengths, gravity):
    """By a symmetric eigenvalue problem: M^(-1/2) K M^(-1/2)."""
    stiffness = gravity_terms((math.pi / 2, math.pi / 2), masses, lengths, gravity)  # sin = 1
    inverse = np.linalg.inv(np.linalg.cholesky(mass_matrix((0.0, 0.0), masses, lengths)))
    return np.sqrt(np.linalg.eigvalsh(inverse @ np.diag(stiffness) @ inverse.T))


def wireframe(theta, lengths):
    elbow, tip = (lengths * np.exp(1j * (theta - math.pi / 2))).cumsum()
    return np.array([[[0, 0], [elbow.real, elbow.imag]], [[elbow.real, elbow.imag], [tip.real, tip.imag]]])


def energies(rows, **known):
    return np.array([energy(row[:2], row[2:], **known) for row in rows])


def momenta(rows, gravity, **bars):
    return np.array([angular_momentum(row[:2], row[2:], **bars) for row in rows])
