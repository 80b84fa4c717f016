"""alpha x r, by which G turns about the centre, is missing in the acceleration of G.

fails: contact_force_accelerates_G
"""


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    alpha = acceleration(phi, phi_dot, slope=slope, gravity=gravity, **body)
    a_x = radius * alpha + offset * phi_dot**2 * math.sin(phi)
    a_y = offset * phi_dot**2 * math.cos(phi)
    return mass * (a_x - gravity * math.sin(slope)), mass * (a_y + gravity * math.cos(slope))
