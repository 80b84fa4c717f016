"""The frequencies belong to equal bars of the first one's length.

fails: small_oscillations_have_two_frequencies
"""


def small_oscillation_frequencies(*, masses, lengths, gravity):
    return np.sqrt(gravity / lengths[0] * np.array([3 - 6 / math.sqrt(7), 3 + 6 / math.sqrt(7)]))
