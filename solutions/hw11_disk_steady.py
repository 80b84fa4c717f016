"""hw11: A disk on a level floor in steady circles: rolling, sliding, and both at once.

figure.svg, beside this file, shows the axes, the names and the positive senses.

The disk has `mass` (kg), `radius` a (m) and an array inertia = (A, C) (kg m^2): about a diameter and about the axle,
both through the centre G, with 0 < C <= 2 A. The ground is level; `gravity` is a magnitude (m/s^2).

lean          : rad, of the disk's plane from the vertical, -pi/2 < lean < pi/2; 0 upright, positive towards
                the centre of the circle
precession    : rad/s, Omega, rate of the whole picture about the upward vertical
axle          : unit vector, cos(lean) towards the centre of the circle and sin(lean) downwards
spin          : rad/s, component of the disk's total angular velocity along the axle
track_radius  : m, R, of the circle that the contact point traces on the ground; negative where the contact
                lies beyond the centre of the circle

Rolling means that the point of the disk on the ground has no velocity: a spin = Omega (R - a sin(lean)).
"""

import math

__all__ = [
    "common_precession",
    "contact_force",
    "moment_residual",
    "rolling_precession",
    "rolling_spin",
    "rolling_track_radius",
    "settling_energy",
    "sliding_spin",
    "sliding_track_radius",
]


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    """Precession Omega >= 0 of a disk that rolls steadily on a ground track of this radius.

    lean         : rad
    track_radius : m, signed
    Returns rad/s; 0 without gravity, and 0 upright on a track that is no point.
    Raises ValueError where no steady rolling exists, or where every Omega will do, as with gravity upright on a point.
    """
    A, C = inertia
    rolling = C + mass * radius**2
    resistance = math.cos(lean) * (rolling * (track_radius / radius - math.sin(lean)) + A * math.sin(lean))
    weight = mass * gravity * radius * math.sin(lean)  # resistance Omega^2 = weight, both as moments
    if resistance == 0.0 and weight == 0.0:
        raise ValueError("an upright disk that spins on a point may do so at any rate")
    if weight == 0.0:
        return 0.0
    if resistance * weight <= 0.0:
        raise ValueError(f"no steady rolling at lean {lean} rad on a track of radius {track_radius} m")
    return math.sqrt(weight / resistance)


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    """Spin of a disk that rolls steadily at this lean and precession.

    lean       : rad
    precession : rad/s, nonzero, either sign
    Returns rad/s.
    """
    _, C = inertia
    return _spin_angular_momentum(lean, precession, mass, radius, inertia, gravity) / (C + mass * radius**2)


def rolling_track_radius(lean, precession, *, mass, radius, inertia, gravity):
    """Radius of the ground track of a disk that rolls steadily at this lean and precession.

    lean       : rad
    precession : rad/s, nonzero, either sign
    Returns m, signed.
    """
    spin = rolling_spin(lean, precession, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return radius * (math.sin(lean) + spin / precession)


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    """Spin of a disk that slides steadily without friction, its centre G at rest.

    lean       : rad
    precession : rad/s, nonzero, either sign
    Returns rad/s.
    """
    _, C = inertia
    return _spin_angular_momentum(lean, precession, mass, radius, inertia, gravity) / C


def sliding_track_radius(lean, *, radius):
    """Radius of the ground track of a disk that slides steadily without friction, its centre G at rest.

    lean : rad
    Returns m, signed.
    """
    return radius * math.sin(lean)


def common_precession(lean, *, mass, radius, inertia, gravity):
    """Precession Omega > 0 of the motions that are steady rolling and steady sliding at once.

    lean    : rad; at 0 the limit lean -> 0
    gravity : m/s^2, > 0
    Returns rad/s.
    """
    A, _ = inertia
    return math.sqrt(mass * gravity * radius / (A * math.cos(lean)))


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    """Force of the ground on a disk that rolls steadily.

    lean       : rad
    precession : rad/s
    spin       : rad/s
    Returns (inward, normal) in N: towards the centre of the circle, and upwards.
    """
    return mass * radius * precession * spin, mass * gravity


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    """Moment of a contact force about G minus the rate of angular momentum about G in steady precession.

    lean       : rad
    precession : rad/s
    spin       : rad/s
    inward     : N, contact force towards the centre of the circle
    normal     : N, contact force upwards
    Returns N m, about the horizontal line through G across the axle: positive where the lean would grow, 0 in
    steady motion.
    """
    A, C = inertia
    cos, sin = math.cos(lean), math.sin(lean)
    moment = radius * (normal * sin - inward * cos)
    angular_momentum = C * spin * cos + A * precession * cos * sin  # its horizontal part, which precesses
    return moment - precession * angular_momentum


def settling_energy(lean, *, mass, radius, inertia, gravity):
    """Kinetic plus potential energy of the motions that are steady rolling and steady sliding at once.

    lean : rad
    Returns J; the potential is 0 with G on the ground.
    """
    # G is at rest, and the disk turns about e2 alone; the kinetic energy is half of the potential.
    precession = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return inertia[0] * (precession * math.cos(lean)) ** 2 / 2 + mass * gravity * radius * math.cos(lean)


def _spin_angular_momentum(lean, precession, mass, radius, inertia, gravity):
    """Angular momentum along the axle that steady motion needs, kg m^2/s.

    It is C spin about G when the disk slides, (C + m a^2) spin about the contact when it rolls: either way the moment
    of the weight, m g a sin(lean), is Omega cos(lean) (this + A Omega sin(lean)).
    Routh, Advanced Rigid Dynamics; O'Reilly, Nonlinear Dynamics 10 (1996) 287.
    """
    A, _ = inertia
    weight = mass * gravity * radius * math.tan(lean)
    return weight / precession - A * precession * math.sin(lean)
