"""Known mistakes of hw11."""

import math

from tam570_grader.diagnosis.mistakes import mistake

from .checks import (
    common_precession_has_a_limit_upright,
    common_precession_is_in_both_families,
    contact_force_moves_the_centre,
    contact_force_of_straight_rolling,
    moment_residual_is_moment_minus_rate,
    rolling_precession_balances_the_moments,
    rolling_precession_holds_on_tracks_of_any_sign,
    rolling_precession_is_zero_where_nothing_turns_it,
    rolling_precession_refuses_what_does_not_exist,
    rolling_spin_balances_the_moments,
    rolling_spin_holds_upright_and_without_gravity,
    rolling_track_has_the_contact_at_rest,
    settling_energy_adds_up,
    sliding_spin_balances_the_moments,
    sliding_track_is_around_the_resting_centre,
)


def factor(lean, track_radius, mass, radius, inertia):
    """What multiplies Omega^2 cos(lean) in the balance of moments."""
    A, C = inertia
    return A * math.sin(lean) + (C + mass * radius**2) * (track_radius / radius - math.sin(lean))


# Rolling


@mistake(
    "You return the spin relative to the turning frame; return the total spin.",
    first_fails=rolling_spin_balances_the_moments,
    label="thin",
)
def rolling_spin(reference, lean, precession, **disk):
    return reference(lean, precession, **disk) + precession * math.sin(lean)


@mistake("You drop the sign of the precession; keep it.", first_fails=rolling_spin_balances_the_moments)
def rolling_spin(reference, lean, precession, **disk):
    return reference(lean, abs(precession), **disk)


@mistake(
    "You return no spin without gravity; a disk that precesses still spins.",
    first_fails=rolling_spin_holds_upright_and_without_gravity,
)
def rolling_spin(reference, lean, precession, **disk):
    return reference(lean, precession, **disk) if disk["gravity"] else 0.0


@mistake(
    "You return the radius of the circle of G; return that of the contact point.",
    first_fails=rolling_track_has_the_contact_at_rest,
)
def rolling_track_radius(reference, lean, precession, **disk):
    return reference(lean, precession, **disk) - disk["radius"] * math.sin(lean)


@mistake("You use C/2 for A; A = C/2 only for a thin disk.", first_fails=rolling_precession_balances_the_moments)
def rolling_precession(reference, lean, track_radius, *, inertia, **disk):
    return reference(lean, track_radius, inertia=(inertia[1] / 2, inertia[1]), **disk)


@mistake(
    "You use Omega R/a as the spin in the angular momentum; the total spin is Omega (R/a - sin(lean)).",
    first_fails=rolling_precession_balances_the_moments,
)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia  # C R/a for C (R/a - sin(lean)) is C more in A
    return reference(lean, track_radius, mass=mass, radius=radius, inertia=(A + C, C), gravity=gravity)


@mistake(
    "You give Omega the sign of the lean; return Omega >= 0.",
    first_fails=rolling_precession_holds_on_tracks_of_any_sign,
)
def rolling_precession(reference, lean, track_radius, **disk):
    return math.copysign(1.0, lean) * reference(lean, track_radius, **disk)


@mistake(
    "You refuse a lean and a track radius of different signs; a long roller can roll so.",
    first_fails=rolling_precession_holds_on_tracks_of_any_sign,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, **disk):
    if lean * track_radius < 0.0 < disk["gravity"]:
        raise ValueError("leans away")
    return reference(lean, track_radius, **disk)


@mistake(
    "You refuse a track radius that is not positive; it has a sign.",
    first_fails=rolling_precession_holds_on_tracks_of_any_sign,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, **disk):
    if track_radius <= 0.0:
        raise ValueError("no such circle")
    return reference(lean, track_radius, **disk)


@mistake(
    "You treat the factor of Omega^2 as zero below 1e-6 kg m^2; for a coin it is that small.",
    first_fails=rolling_precession_holds_on_tracks_of_any_sign,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    if lean and gravity and abs(factor(lean, track_radius, mass, radius, inertia)) < 1e-6:
        raise ValueError("no Omega")
    return reference(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)


@mistake(
    "You treat a lean below 1e-4 as upright; only lean = 0 is.",
    first_fails=rolling_precession_is_zero_where_nothing_turns_it,
)
def rolling_precession(reference, lean, track_radius, **disk):
    return reference(lean if abs(lean) >= 1e-4 else 0.0, track_radius, **disk)


@mistake(
    "You raise ValueError without gravity; a disk at rest, Omega = 0, is a solution.",
    first_fails=rolling_precession_is_zero_where_nothing_turns_it,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, **disk):
    if disk["gravity"] == 0.0:
        raise ValueError("nothing makes it turn")
    return reference(lean, track_radius, **disk)


@mistake(
    "You take the root of |Omega^2|; raise ValueError where Omega^2 is negative.",
    first_fails=rolling_precession_refuses_what_does_not_exist,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    weight = mass * gravity * radius * math.tan(lean)
    return math.sqrt(abs(weight / factor(lean, track_radius, mass, radius, inertia))) if weight else 0.0


@mistake(
    "You return Omega = 0 for every upright disk; raise ValueError on a point, where every Omega will do.",
    first_fails=rolling_precession_refuses_what_does_not_exist,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, **disk):
    return reference(lean, track_radius, **disk) if lean else 0.0


@mistake(
    "You divide by the factor of Omega^2, which may be zero; raise ValueError there.",
    first_fails=rolling_precession_refuses_what_does_not_exist,
    compared=False,
)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    weight = mass * gravity * radius * math.tan(lean)
    if weight == 0.0:
        return reference(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    square = weight / factor(lean, track_radius, mass, radius, inertia)
    if square < 0.0:
        raise ValueError("no Omega")
    return math.sqrt(square)


# Sliding, and both


@mistake(
    "You return the spin of the rolling disk; without friction only the normal force has a moment about G.",
    first_fails=sliding_spin_balances_the_moments,
)
def sliding_spin(reference, lean, precession, **disk):
    return rolling_spin(lean, precession, **disk)


@mistake(
    "You use cos(lean); the lean is measured from the vertical.", first_fails=sliding_track_is_around_the_resting_centre
)
def sliding_track_radius(reference, lean, *, radius):
    return radius * math.cos(lean)


@mistake("You use A + m a^2; G is at rest, so use A.", first_fails=common_precession_is_in_both_families)
def common_precession(reference, lean, *, mass, radius, inertia, gravity):
    about_contact = inertia[0] + mass * radius**2, inertia[1]
    return reference(lean, mass=mass, radius=radius, inertia=about_contact, gravity=gravity)


@mistake(
    "You divide by sin(lean), which is 0 upright; cancel it.",
    first_fails=common_precession_has_a_limit_upright,
    compared=False,
)
def common_precession(reference, lean, **disk):
    return reference(lean, **disk) * math.sin(lean) / math.sin(lean)


@mistake("You multiply the inward force by cos(lean); it is horizontal.", first_fails=contact_force_moves_the_centre)
def contact_force(reference, lean, precession, spin, **disk):
    inward, normal = reference(lean, precession, spin, **disk)
    return inward * math.cos(lean), normal


@mistake(
    "You move G on the contact's circle of radius R; the circle of G has the radius R - a sin(lean).",
    first_fails=contact_force_moves_the_centre,
)
def contact_force(reference, lean, precession, spin, **disk):
    return reference(lean, precession, spin + precession * math.sin(lean), **disk)


@mistake(
    "You use the spin as relative to the turning frame; it is the total spin.",
    first_fails=contact_force_moves_the_centre,
)
def contact_force(reference, lean, precession, spin, **disk):
    return reference(lean, precession, spin - precession * math.sin(lean), **disk)


@mistake(
    "You divide by Omega for the circle of G; straight rolling has Omega = 0.",
    first_fails=contact_force_of_straight_rolling,
    compared=False,
)
def contact_force(reference, lean, precession, spin, *, mass, radius, gravity):
    circle = radius * spin / precession
    return mass * precession**2 * circle, mass * gravity


@mistake(
    "You use the inward force of steady rolling; use the given one.", first_fails=moment_residual_is_moment_minus_rate
)
def moment_residual(reference, lean, precession, spin, inward, normal, *, mass, radius, inertia):
    rolling, _ = contact_force(lean, precession, spin, mass=mass, radius=radius, gravity=0.0)
    return reference(lean, precession, spin, rolling, normal, mass=mass, radius=radius, inertia=inertia)


@mistake(
    "You exchange the arms; the normal force has the arm a sin(lean), the inward one a cos(lean).",
    first_fails=moment_residual_is_moment_minus_rate,
)
def moment_residual(reference, lean, precession, spin, inward, normal, **disk):
    return reference(lean, precession, spin, -normal, -inward, **disk)


@mistake("You use C/2 for A in the kinetic energy; A = C/2 only for a thin disk.", first_fails=settling_energy_adds_up)
def settling_energy(reference, lean, *, mass, radius, inertia, gravity):
    A, C = inertia
    height = mass * gravity * radius * math.cos(lean)
    return height * (1 + C / (4 * A))


@mistake(
    "You set the potential to zero with the disk upright; it is zero with G on the ground.",
    first_fails=settling_energy_adds_up,
)
def settling_energy(reference, lean, **disk):
    return reference(lean, **disk) - disk["mass"] * disk["gravity"] * disk["radius"]


@mistake("You use Omega for the rate about the diameter; it is Omega cos(lean).", first_fails=settling_energy_adds_up)
def settling_energy(reference, lean, **disk):
    kinetic = disk["inertia"][0] * common_precession(lean, **disk) ** 2 / 2
    return kinetic + disk["mass"] * disk["gravity"] * disk["radius"] * math.cos(lean)
