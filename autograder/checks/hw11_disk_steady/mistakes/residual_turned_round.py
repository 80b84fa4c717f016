"""The residual has the opposite sign; it is positive where the lean would grow.

fails: moment_residual_is_moment_minus_rate
"""


_residual = moment_residual


def moment_residual(*args, **disk):
    return -_residual(*args, **disk)
