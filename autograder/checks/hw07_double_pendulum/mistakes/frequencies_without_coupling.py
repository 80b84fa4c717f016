"""The frequencies leave out the coupling of [M].

fails: small_oscillations_have_two_frequencies
"""


def small_oscillation_frequencies(*, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    squares = (m1 / 2 + m2) / (m1 / 3 + m2) * gravity / l1, 1.5 * gravity / l2
    return np.sqrt(np.sort(squares))
