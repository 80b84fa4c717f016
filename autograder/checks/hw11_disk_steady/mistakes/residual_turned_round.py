"""The sign is wrong.

fails: moment_residual_is_moment_minus_rate
"""


_residual = moment_residual


def moment_residual(*args, **disk):
    return -_residual(*args, **disk)
