"""About G the friction has the lever r; it should be r - e cos(phi).

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
"""


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    s, c = math.sin(phi), math.cos(phi)
    whole = inertia + mass * (offset * s) ** 2 + mass * radius * (radius - offset * c)
    moment = -mass * offset * s * (offset * c * phi_dot**2 + gravity * math.cos(slope))
    return (moment - mass * radius * (offset * s * phi_dot**2 - gravity * math.sin(slope))) / whole
