"""The inward force is the one of steady rolling, not the one given.

fails: moment_residual_is_moment_minus_rate
"""


_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    rolling = mass * radius * precession * spin
    return _residual(lean, precession, spin, rolling, normal, mass=mass, radius=radius, inertia=inertia)
