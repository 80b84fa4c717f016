"""The moment is divided by A; it should be divided by A + m a^2, the inertia about the contact.

fails: steady_residual_is_the_tilt_acceleration
"""

_residual = steady_residual


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    return _residual(lean, precession, spin, **disk) * (1 + mass * radius**2 / inertia[0])
