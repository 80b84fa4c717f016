"""An upright disk is given no inward force and no moment, as if it rolled straight on.

fails: contact_force_moves_the_centre, moment_residual_is_moment_minus_rate
"""

_force, _residual = contact_force, moment_residual


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    inward, normal = _force(lean, precession, spin, mass=mass, radius=radius, gravity=gravity)
    return (inward if lean else 0.0), normal


def moment_residual(lean, *motion, mass, radius, inertia):
    return _residual(lean, *motion, mass=mass, radius=radius, inertia=inertia) if lean else 0.0
