"""The residual is a moment instead of an angular acceleration.

fails: steady_residual_is_the_tilt_acceleration
suspect: not divided by the inertia
"""


_residual = steady_residual


def steady_residual(lean, precession, spin, **disk):
    return _residual(lean, precession, spin, **disk) * (disk["inertia"][0] + disk["mass"] * disk["radius"] ** 2)
