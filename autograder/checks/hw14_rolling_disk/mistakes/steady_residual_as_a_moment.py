"""This is a moment: it is not divided by the inertia about the contact.

fails: steady_residual_is_the_tilt_acceleration
"""


_residual = steady_residual


def steady_residual(lean, precession, spin, **disk):
    return _residual(lean, precession, spin, **disk) * (disk["inertia"][0] + disk["mass"] * disk["radius"] ** 2)
