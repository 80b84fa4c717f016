"""The rate of angular momentum minus the moment.

fails: moment_residual_is_moment_minus_rate
suspect: the sign turned round
"""


_residual = moment_residual


def moment_residual(*args, **disk):
    return -_residual(*args, **disk)
