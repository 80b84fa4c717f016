"""The weight's moment has sin(phi) where sin(phi + slope) belongs.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
"""

_right = acceleration


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    more = mass * gravity * offset * (math.sin(phi + slope) - math.sin(phi)) / contact_inertia(phi, **body)
    return _right(phi, phi_dot, slope=slope, gravity=gravity, **body) + more
