"""This has half the term that M_C = I^C phi'' lacks.

fails: missing_moment_makes_it_right, acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sin(phi) * phi_dot**2 / 2


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    body = {"mass": mass, "radius": radius, "offset": offset}
    M = mass * gravity * (radius * math.sin(slope) - offset * math.sin(phi + slope))
    return (M - missing_moment(phi, phi_dot, **body)) / contact_inertia(phi, inertia=inertia, **body)
