"""The spin is relative to the turning frame; the total spin is asked for.

fails: contact_force_moves_the_centre, moment_residual_is_moment_minus_rate
"""


_force, _residual = contact_force, moment_residual


def contact_force(lean, precession, spin, **disk):
    return _force(lean, precession, spin - precession * math.sin(lean), **disk)


def moment_residual(lean, precession, spin, inward, normal, **disk):
    return _residual(lean, precession, spin - precession * math.sin(lean), inward, normal, **disk)
