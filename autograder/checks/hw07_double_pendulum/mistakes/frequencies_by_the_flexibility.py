"""The frequencies come from K^-1 M, which does not exist without gravity.

fails: frequencies_in_special_cases
names: raised ValueError for a random pendulum, no gravity
"""


def small_oscillation_frequencies(*, masses, lengths, gravity):
    M = mass_matrix(np.zeros(2), masses=masses, lengths=lengths)
    K = np.diag(gravity_terms(np.full(2, math.pi / 2), masses=masses, lengths=lengths, gravity=gravity))
    return np.sort(1 / np.sqrt(np.linalg.eigvals(np.linalg.solve(K, M)).real))
