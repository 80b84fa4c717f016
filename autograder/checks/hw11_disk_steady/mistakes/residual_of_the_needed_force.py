"""The forces given are ignored for those of steady rolling on a floor.

fails: moment_residual_is_moment_minus_rate
suspect: the inward force of steady rolling
"""


_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    rolling = mass * radius * precession * spin
    return _residual(lean, precession, spin, rolling, normal, mass=mass, radius=radius, inertia=inertia)
