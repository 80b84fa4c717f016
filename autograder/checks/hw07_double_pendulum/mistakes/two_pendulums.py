"""The frequencies belong to two bars that each hang from a ceiling.

fails: small_oscillations_have_two_frequencies
"""


def small_oscillation_frequencies(*, masses, lengths, gravity):
    return np.sort(np.sqrt(1.5 * gravity / np.asarray(lengths)))
