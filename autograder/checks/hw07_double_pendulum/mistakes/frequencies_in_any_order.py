"""The frequencies come in the order of some matrix's eigenvalues; the lower one should come first.

fails: small_oscillations_have_two_frequencies
names: not in ascending order
"""

ascending = small_oscillation_frequencies


def small_oscillation_frequencies(*, masses, lengths, gravity):
    return ascending(masses=masses, lengths=lengths, gravity=gravity)[:: -1 if lengths[0] > lengths[1] else 1]
