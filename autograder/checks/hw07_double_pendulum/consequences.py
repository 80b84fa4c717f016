"""Right functions of hw07 in terms of others, which a student's results follow where those are the student's own."""

import numpy as np

SMALL = 1e-4  # rad, of the angles between which the moments of the weights grow in proportion


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    """Solve [M]{alpha} + {f} + {g} = 0."""
    bars = {"masses": masses, "lengths": lengths}
    moments = np.add(velocity_terms(theta, omega, **bars), gravity_terms(theta, gravity=gravity, **bars))
    return np.linalg.solve(mass_matrix(theta, **bars), -moments)


def small_oscillation_frequencies(*, masses, lengths, gravity):
    """Square roots of the eigenvalues of M^-1 K, where K is the slope of the gravity terms."""
    bars = {"masses": masses, "lengths": lengths}
    ends = [[gravity_terms(sign * row, gravity=gravity, **bars) for sign in (-1, 1)] for row in SMALL * np.eye(2)]
    slopes = [np.subtract(after, before) / (2 * SMALL) for before, after in ends]
    squares = np.linalg.eigvals(np.linalg.solve(mass_matrix(np.zeros(2), **bars), np.transpose(slopes)))
    return np.sort(np.sqrt(squares.real))
