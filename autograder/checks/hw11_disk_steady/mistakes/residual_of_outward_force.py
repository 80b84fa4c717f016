"""The moment of the inward force has the wrong sign.

fails: moment_residual_is_moment_minus_rate
"""

_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, **disk):
    return _residual(lean, precession, spin, -inward, normal, **disk)
