"""The moment of the inward force has the sign of an outward one.

fails: moment_residual_is_moment_minus_rate
suspect: the moment of the inward force turned round
"""

_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, **disk):
    return _residual(lean, precession, spin, -inward, normal, **disk)
