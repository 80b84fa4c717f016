"""The arms of the two forces are exchanged: the normal force has the arm a sin(lean), the inward one a cos(lean).

fails: moment_residual_is_moment_minus_rate
"""

_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, **disk):
    return _residual(lean, precession, spin, -normal, -inward, **disk)
