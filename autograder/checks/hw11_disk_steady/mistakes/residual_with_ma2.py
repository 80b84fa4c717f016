"""The residual has C + m a^2 where C belongs; the moments are about G, and the force is given.

fails: moment_residual_is_moment_minus_rate
"""

_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    about_contact = (inertia[0], inertia[1] + mass * radius**2)
    return _residual(lean, precession, spin, inward, normal, mass=mass, radius=radius, inertia=about_contact)
