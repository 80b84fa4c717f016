"""The frequencies are those of two compound pendulums.

fails: small_oscillations_have_two_frequencies
suspect: two bars that each hang from a ceiling
"""


def small_oscillation_frequencies(*, masses, lengths, gravity):
    return np.sort(np.sqrt(1.5 * gravity / np.asarray(lengths)))
