"""Right functions of hw07 in terms of others, as students write them; diagnosis tries mistakes in these, too."""

import numpy as np

SMALL = 1e-4  # rad; between these angles the moments of the weights grow in proportion


def mass_matrix(theta, *, masses, lengths):
    """Use the velocities of the mass centres, and of the bars about these."""
    (m1, m2), (first, second) = masses, _centres(theta, lengths)
    return m1 * first @ first.T + m2 * second @ second.T + np.diag(np.multiply(masses, np.square(lengths)) / 12)


def gravity_terms(theta, *, masses, lengths, gravity):
    """Project the weights on these velocities."""
    return gravity * np.tensordot(masses, _centres(theta, lengths)[:, :, 1], 1)


def velocity_terms(theta, omega, *, masses, lengths):
    """Subtract the slopes of the kinetic energy from d/dt of [M]{omega}, where both come from [M] alone."""
    step, units = 1e-2, np.eye(2)

    def slope(k):
        matrices = [mass_matrix(theta + n * step * units[k], masses=masses, lengths=lengths) for n in (-2, -1, 1, 2)]
        return np.tensordot([1, -8, 8, -1], matrices, 1) / (12 * step)

    slopes = np.array([slope(0), slope(1)])
    return np.tensordot(omega, slopes, 1) @ omega - slopes @ omega @ omega / 2


def energy(theta, omega, *, masses, lengths, gravity):
    """Use [M], and the weights, whose moments are largest where both bars are level."""
    bars = {"masses": masses, "lengths": lengths}
    kinetic = omega @ mass_matrix(theta, **bars) @ omega / 2
    return kinetic - np.cos(theta) @ gravity_terms(np.full(2, np.pi / 2), gravity=gravity, **bars)


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    """Solve [M]{alpha} + {f} + {g} = 0."""
    bars = {"masses": masses, "lengths": lengths}
    moments = np.add(velocity_terms(theta, omega, **bars), gravity_terms(theta, gravity=gravity, **bars))
    return np.linalg.solve(mass_matrix(theta, **bars), -moments)


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """Use the same accelerations; then each hinge carries, and accelerates, what hangs below it."""
    alpha = angular_acceleration(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    (m1, m2), (along, across) = masses, _directions(theta)
    turning = (across.T * np.multiply(lengths, alpha) - along.T * np.multiply(lengths, np.square(omega))).T
    up = np.array([0.0, gravity])
    on_bar2 = m2 * (turning[0] + turning[1] / 2 + up)
    on_bar1 = m1 * (turning[0] / 2 + up) + on_bar2
    return alpha, np.array([on_bar1, on_bar2])


def angular_momentum(theta, omega, *, masses, lengths):
    """Add the angular momenta of the mass centres, and of the bars about these."""
    m1, m2 = masses
    (along, across), (om1, om2) = np.reshape(lengths, (2, 1)) * _directions(theta), omega
    r1, v1 = along[0] / 2, om1 * across[0] / 2
    r2, v2 = along[0] + along[1] / 2, om1 * across[0] + om2 * across[1] / 2
    orbital = m1 * (r1[0] * v1[1] - r1[1] * v1[0]) + m2 * (r2[0] * v2[1] - r2[1] * v2[0])
    return orbital + m1 * lengths[0] ** 2 / 12 * om1 + m2 * lengths[1] ** 2 / 12 * om2


def small_oscillation_frequencies(*, masses, lengths, gravity):
    """Take square roots of the eigenvalues of M^-1 K, where K is the slope of the gravity terms."""
    bars = {"masses": masses, "lengths": lengths}
    ends = [[gravity_terms(sign * row, gravity=gravity, **bars) for sign in (-1, 1)] for row in SMALL * np.eye(2)]
    slopes = [np.subtract(after, before) / (2 * SMALL) for before, after in ends]
    squares = np.linalg.eigvals(np.linalg.solve(mass_matrix(np.zeros(2), **bars), np.transpose(slopes)))
    return np.sort(np.sqrt(squares.real))


def _centres(theta, lengths):
    """Return (2, 2, 2) velocities of the mass centres for each angular velocity of 1."""
    across, (l1, l2) = _directions(theta)[1], lengths
    return np.array([[0.5 * l1 * across[0], 0 * across[1]], [l1 * across[0], 0.5 * l2 * across[1]]])
