"""Reference functions of hw11: the balance of moments in vectors, solved for the unknown.

Axes: x towards the centre of the circle, z up, y such that z turns towards x about +y, as the lean grows.
"""

import math

import numpy as np

X, Y, Z = np.eye(3)
NEXT_TO_UPRIGHT = 1e-5  # rad; the lean changes the common precession by its square


def axle(lean):
    return math.cos(lean) * X - math.sin(lean) * Z


def rim(lean, radius):
    """Return G from the contact."""
    return radius * (math.sin(lean) * X + math.cos(lean) * Z)


def angular_velocity(lean, precession, spin):
    """Return omega: the precession about z, and the rest of the total spin about the axle."""
    n = axle(lean)
    return precession * Z + (spin - precession * n @ Z) * n


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    """Return the moment of the contact force about G minus Omega z x H."""
    A, C = inertia
    n, omega = axle(lean), angular_velocity(lean, precession, spin)
    H = A * omega + (C - A) * (omega @ n) * n
    moment = np.cross(-rim(lean, radius), inward * X + normal * Z)
    return float((moment - precession * np.cross(Z, H)) @ Y)


def contact_force(lean, precession, spin, mass, radius, gravity):
    """Return the force inwards and upwards: G moves at omega x (contact to G), and Omega turns that velocity."""
    velocity = np.cross(angular_velocity(lean, precession, spin), rim(lean, radius))
    force = mass * (precession * np.cross(Z, velocity) + gravity * Z)
    return float(force @ X), float(force @ Z)


def sliding_force(lean, precession, spin, mass, radius, gravity):
    return 0.0, mass * gravity


def unbalanced(lean, precession, spin, force, *, mass, radius, inertia, gravity):
    """Return the residual under the force that the motion needs."""
    needed = force(lean, precession, spin, mass, radius, gravity)
    return moment_residual(lean, precession, spin, *needed, mass=mass, radius=radius, inertia=inertia)


def balanced_spin(lean, precession, force, **disk):
    """Return the spin for which the residual, linear in it, is zero."""
    at_rest, turning = (unbalanced(lean, precession, spin, force, **disk) for spin in (0.0, 1.0))
    return at_rest / (at_rest - turning)


def spin_size(lean, precession, force, **disk):
    """Return the size of the two terms that add up to the spin."""
    at_rest, turning = (unbalanced(lean, precession, spin, force, **disk) for spin in (0.0, 1.0))
    factor = disk["mass"] * disk["gravity"] * disk["radius"] + disk["inertia"][0] * precession**2
    return factor / abs(turning - at_rest)


def balanced_precession(lean, spin, force, **disk):
    """Return Omega with weight - resistance Omega^2 = 0; `spin` is that for Omega = 1."""
    weight = disk["mass"] * disk["gravity"] * disk["radius"] * math.sin(lean)
    resistance = -unbalanced(lean, 1.0, spin, force, **{**disk, "gravity": 0.0})
    return math.sqrt(weight / resistance)


def rolling_spin(lean, precession, **disk):
    return balanced_spin(lean, precession, contact_force, **disk)


def sliding_spin(lean, precession, **disk):
    return balanced_spin(lean, precession, sliding_force, **disk)


def rolling_track_radius(lean, precession, **disk):
    """Equate the velocity omega x (contact to G) to that of a point that goes round with Omega."""
    arm, spin = rim(lean, disk["radius"]), rolling_spin(lean, precession, **disk)
    velocity = np.cross(angular_velocity(lean, precession, spin), arm) @ Y
    return arm @ X - velocity / precession


def rolling_precession(lean, track_radius, **disk):
    spin = track_radius / disk["radius"] - math.sin(lean)  # over Omega: the point on the ground has no velocity
    return balanced_precession(lean, spin, contact_force, **disk)


def smallest_track(lean, *, mass, radius, inertia, gravity):
    """Return the track radius at which Omega would be infinite."""
    return radius * math.sin(lean) * (1 - inertia[0] / (inertia[1] + mass * radius**2))


def sliding_track_radius(lean, radius):
    return rim(lean, radius) @ X


def common_precession(lean, **disk):
    """Balance the weight's moment alone, without spin; upright it is a limit."""
    return balanced_precession(max(abs(lean), NEXT_TO_UPRIGHT), 0.0, sliding_force, **disk)


def settling_energy(lean, **disk):
    """Return the energy of a disk whose centre is at rest and that has no spin."""
    A, C = disk["inertia"]
    n, omega = axle(lean), angular_velocity(lean, common_precession(lean, **disk), 0.0)
    kinetic = 0.5 * (A * omega @ omega + (C - A) * (omega @ n) ** 2)
    return kinetic + disk["mass"] * disk["gravity"] * rim(lean, disk["radius"]) @ Z
