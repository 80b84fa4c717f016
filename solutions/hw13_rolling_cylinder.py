"""hw13: A cylinder rolls down a ramp; its centre of mass G need not be at its centre.

figure.svg, beside this file, shows the axes, the names and the positive senses.

x points down the ramp, y off it. The ramp goes down at the angle `slope` and the cylinder does not slip: phi is its
rotation, rolling down positive, and its centre is at x = radius * phi, y = radius. G is at `offset` from the centre, at
phi = 0 towards the contact: offset (-sin phi, -cos phi). `inertia` is the moment of inertia about G. C is the contact.
"""

import math

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
    G, contact = (-offset * math.sin(phi), -offset * math.cos(phi)), (0.0, -radius)
    down = math.sin(slope), -math.cos(slope)
    return [(G, down), (contact, (0.0, 1.0)), (contact, (1.0, 0.0))]


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
    # I phi'' = e sin(phi) (-N) + (r - e cos(phi)) (-F), and F = m x'' - m g sin(slope), N = m y'' + m g cos(slope),
    # with x'' and y'' of G as in `contact_force`: the terms in phi'' make the inertia about C.
    turned = inertia + mass * _distance_squared(phi, radius, offset)
    return (
        _weight_moment(phi, mass, radius, offset, slope, gravity) - mass * radius * offset * math.sin(phi) * phi_dot**2
    ) / turned


def contact_inertia(phi, *, mass, radius, offset, inertia):
    """Moment of inertia about the contact point C.

    phi     : rad
    mass    : kg
    radius  : m
    offset  : m, >= 0
    inertia : kg m^2, about G
    Returns kg m^2.
    """
    return inertia + mass * _distance_squared(phi, radius, offset)


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
    about_contact = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    return _weight_moment(phi, mass, radius, offset, slope, gravity) / about_contact


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    """The term that M_C = I^C phi'' lacks: I^C phi'' + missing_moment = M_C is right.

    phi, phi_dot : rad, rad/s
    mass         : kg
    radius       : m
    offset       : m, >= 0
    Returns N m.
    """
    # The material point at C has the acceleration r phi'^2 towards the centre: r_{G/C} x m a of it.
    return mass * radius * offset * math.sin(phi) * phi_dot**2


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
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    phi_ddot = acceleration(phi, phi_dot, slope=slope, gravity=gravity, **body)
    c, s = math.cos(phi), math.sin(phi)
    x_ddot = (radius - offset * c) * phi_ddot + offset * s * phi_dot**2
    y_ddot = offset * (s * phi_ddot + c * phi_dot**2)
    return mass * (x_ddot - gravity * math.sin(slope)), mass * (y_ddot + gravity * math.cos(slope))


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
    kinetic = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia) * phi_dot**2 / 2
    height = -radius * phi * math.sin(slope) - offset * math.cos(phi + slope)
    return kinetic + mass * gravity * height


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
    from tam570.integrate import solve

    cylinder = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    parameters = {**cylinder, "slope": slope, "gravity": gravity}
    return solve(_state_derivative, t, (phi, phi_dot), parameters=parameters, rtol=1e-13)


def _state_derivative(t, state, **parameters):
    phi, phi_dot = state
    return phi_dot, acceleration(phi, phi_dot, **parameters)


def _distance_squared(phi, radius, offset):
    """From C to G, squared; so written that an offset near the radius costs no digits."""
    return (radius - offset) ** 2 + 4 * radius * offset * math.sin(phi / 2) ** 2


def _weight_moment(phi, mass, radius, offset, slope, gravity):
    """M_C, the moment of gravity about C, positive where it rolls the cylinder down."""
    return mass * gravity * (radius * math.sin(slope) - offset * math.sin(phi + slope))
