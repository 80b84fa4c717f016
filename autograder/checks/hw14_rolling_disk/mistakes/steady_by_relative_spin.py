"""The spin of the steady motion is taken for the rate relative to the turning frame.

fails: steady_residual_is_the_tilt_acceleration
suspect: relative to the turning frame
"""


_residual = steady_residual


def steady_residual(lean, precession, spin, **disk):
    return _residual(lean, precession, spin - precession * math.sin(lean), **disk)
