"""The lean has the wrong sign.

fails: steady_residual_is_the_tilt_acceleration
"""


_residual = steady_residual


def steady_residual(lean, precession, spin, **disk):
    return _residual(-lean, precession, spin, **disk)
