"""The frequencies are in Hz; they should be in rad/s.

fails: small_oscillations_have_two_frequencies
"""

circular = small_oscillation_frequencies


def small_oscillation_frequencies(**known):
    return circular(**known) / (2 * math.pi)
