"""The rate of angular momentum has C + m a^2, as if about the contact.

fails: moment_residual_is_moment_minus_rate
suspect: C + m a^2 for C
"""

_residual = moment_residual


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    about_contact = (inertia[0], inertia[1] + mass * radius**2)
    return _residual(lean, precession, spin, inward, normal, mass=mass, radius=radius, inertia=about_contact)
