"""hw13: A cylinder rolls down a ramp; its centre of mass G need not be at its centre.

figure.svg, beside this file, shows the axes, the names and the positive senses.

x points down the ramp, y off it. The ramp goes down at the angle `slope` and the cylinder does not slip: phi is its
rotation, rolling down positive, and its centre is at x = radius * phi, y = radius. G is at `offset` from the centre, at
phi = 0 towards the contact: offset (-sin phi, -cos phi). `inertia` is the moment of inertia about G. C is the contact.
"""

__all__ = [
    "acceleration",
    "contact_force",
    "contact_inertia",
    "energy",
    "free_body_diagram",
    "missing_moment",
    "naive_contact_acceleration",
    "simulate",
]


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    """The forces on the cylinder, cut free from the ramp.

    phi     : rad
    mass    : kg
    radius  : m
    offset  : m, >= 0
    slope   : rad
    gravity : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m from the centre of the
    cylinder, and a vector (2,) of any length along which it acts, or None where neither component is known; x down
    the ramp, y off it. The order is free.
    """
    raise NotImplementedError


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """The angular acceleration, by the balance of angular momentum about G.

    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    inertia      : kg m^2, about G
    slope        : rad
    gravity      : m/s^2, may be 0
    Returns rad/s^2.
    """
    raise NotImplementedError


def contact_inertia(phi, *, mass, radius, offset, inertia):
    """Moment of inertia about the contact point C.

    phi     : rad
    mass    : kg
    radius  : m
    offset  : m, >= 0
    inertia : kg m^2, about G
    Returns kg m^2.
    """
    raise NotImplementedError


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    """What M_C = I^C phi'' would give: right only where G is at the centre, or nothing turns.

    phi     : rad
    mass    : kg
    radius  : m
    offset  : m, >= 0
    inertia : kg m^2, about G
    slope   : rad
    gravity : m/s^2, may be 0
    Returns rad/s^2.
    """
    raise NotImplementedError


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    """The term that M_C = I^C phi'' lacks: I^C phi'' + missing_moment = M_C is right.

    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    Returns N m.
    """
    raise NotImplementedError


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """Force of the ramp on the cylinder, by the balance of linear momentum.

    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    inertia      : kg m^2, about G
    slope        : rad
    gravity      : m/s^2, may be 0
    Returns (along, normal), N: along is positive down the ramp; normal may be negative, contact is kept.
    """
    raise NotImplementedError


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """Kinetic plus potential energy; the potential is 0 with G where the centre is at phi = 0.

    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    inertia      : kg m^2, about G
    slope        : rad
    gravity      : m/s^2, may be 0
    Returns J.
    """
    raise NotImplementedError


def simulate(t, phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """Rolling from phi and phi_dot at t[0].

    t            : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    inertia      : kg m^2, about G
    slope        : rad
    gravity      : m/s^2, may be 0
    Returns (n, 2): phi in rad, never wrapped, and phi_dot in rad/s; row i is the state at t[i].
    """
    raise NotImplementedError
