"""The angular momentum has only the spin; Omega turns the disk about its diameter, too.

fails: moment_residual_is_moment_minus_rate
"""


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    moment = radius * (normal * math.sin(lean) - inward * math.cos(lean))
    return moment - precession * inertia[1] * spin * math.cos(lean)
