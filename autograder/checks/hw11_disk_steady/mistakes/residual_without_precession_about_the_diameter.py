"""The angular momentum is that of the spin alone.

fails: moment_residual_is_moment_minus_rate
suspect: the angular momentum of the spin alone
"""


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    moment = radius * (normal * math.sin(lean) - inward * math.cos(lean))
    return moment - precession * inertia[1] * spin * math.cos(lean)
