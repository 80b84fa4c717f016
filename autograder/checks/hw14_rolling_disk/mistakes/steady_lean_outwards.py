"""The lean has the other sign.

fails: steady_residual_is_the_tilt_acceleration
suspect: the lean to the other side
"""


_residual = steady_residual


def steady_residual(lean, precession, spin, **disk):
    return _residual(-lean, precession, spin, **disk)
