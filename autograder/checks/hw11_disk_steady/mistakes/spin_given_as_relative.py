"""The spin given is taken for the one relative to the turning frame.

fails: contact_force_moves_the_centre, moment_residual_is_moment_minus_rate
suspect: the spin relative to the turning frame
"""


_force, _residual = contact_force, moment_residual


def contact_force(lean, precession, spin, **disk):
    return _force(lean, precession, spin - precession * math.sin(lean), **disk)


def moment_residual(lean, precession, spin, inward, normal, **disk):
    return _residual(lean, precession, spin - precession * math.sin(lean), inward, normal, **disk)
