"""Known mistakes of hw11."""

import math

from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def factor(lean, track_radius, mass, radius, inertia):
    """What multiplies Omega^2 cos(lean) in the balance of moments."""
    A, C = inertia
    return A * math.sin(lean) + (C + mass * radius**2) * (track_radius / radius - math.sin(lean))


# Rolling


@mistake(first_fails=checks.rolling_spin_balances_the_moments, label="thin")
def rolling_spin(reference, lean, precession, **disk):
    """You return the spin relative to the turning frame; return the total spin."""
    return reference(lean, precession, **disk) + precession * math.sin(lean)


@mistake(first_fails=checks.rolling_spin_balances_the_moments)
def rolling_spin(reference, lean, precession, **disk):
    """You subtract Omega sin(lean) from the total spin; the total spin has this part already."""
    return reference(lean, precession, **disk) - precession * math.sin(lean)


@mistake(first_fails=checks.rolling_spin_holds_upright_and_without_gravity)
def rolling_spin(reference, lean, precession, **disk):
    """You return no spin without gravity; a disk that precesses still spins."""
    return reference(lean, precession, **disk) if disk["gravity"] else 0.0


@mistake(first_fails=checks.rolling_track_has_the_contact_at_rest)
def rolling_track_radius(reference, lean, precession, **disk):
    """You return the radius of the circle of G; return that of the contact point."""
    return reference(lean, precession, **disk) - disk["radius"] * math.sin(lean)


@mistake(first_fails=checks.rolling_precession_balances_the_moments)
def rolling_precession(reference, lean, track_radius, *, inertia, **disk):
    """You use C/2 for A; A = C/2 only for a thin disk."""
    return reference(lean, track_radius, inertia=(inertia[1] / 2, inertia[1]), **disk)


@mistake(first_fails=checks.rolling_precession_balances_the_moments)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    """You use Omega R/a as the spin in the angular momentum; the total spin is Omega (R/a - sin(lean))."""
    A, C = inertia  # C R/a in place of C (R/a - sin(lean)) amounts to A + C in place of A
    return reference(lean, track_radius, mass=mass, radius=radius, inertia=(A + C, C), gravity=gravity)


@mistake(first_fails=checks.rolling_precession_holds_on_tracks_of_any_sign)
def rolling_precession(reference, lean, track_radius, **disk):
    """You give Omega the sign of the lean; return Omega >= 0."""
    return math.copysign(1.0, lean) * reference(lean, track_radius, **disk)


@mistake(first_fails=checks.rolling_precession_holds_on_tracks_of_any_sign, compared=False)
def rolling_precession(reference, lean, track_radius, **disk):
    """You refuse a lean and a track radius of different signs; a long roller can roll so."""
    if lean * track_radius < 0.0 < disk["gravity"]:
        raise ValueError("leans away")
    return reference(lean, track_radius, **disk)


@mistake(first_fails=checks.rolling_precession_holds_on_tracks_of_any_sign, compared=False)
def rolling_precession(reference, lean, track_radius, **disk):
    """You refuse a track radius that is not positive; it has a sign."""
    if track_radius <= 0.0:
        raise ValueError("no such circle")
    return reference(lean, track_radius, **disk)


@mistake(first_fails=checks.rolling_precession_holds_on_tracks_of_any_sign, compared=False)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    """You treat the factor of Omega^2 as zero below 1e-6 kg m^2; for a coin it is that small."""
    if lean and gravity and abs(factor(lean, track_radius, mass, radius, inertia)) < 1e-6:
        raise ValueError("no Omega")
    return reference(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)


@mistake(first_fails=checks.rolling_precession_is_zero_where_nothing_turns_it)
def rolling_precession(reference, lean, track_radius, **disk):
    """You treat a small lean as upright; only lean = 0 is."""
    return reference(lean if abs(lean) >= 1e-4 else 0.0, track_radius, **disk)


@mistake(first_fails=checks.rolling_precession_is_zero_where_nothing_turns_it, compared=False)
def rolling_precession(reference, lean, track_radius, **disk):
    """You raise ValueError without gravity; a disk at rest, Omega = 0, is a solution."""
    if disk["gravity"] == 0.0:
        raise ValueError("nothing makes it turn")
    return reference(lean, track_radius, **disk)


@mistake(first_fails=checks.rolling_precession_refuses_what_does_not_exist, compared=False)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    """You take the root of |Omega^2|; raise ValueError where Omega^2 is negative."""
    weight = mass * gravity * radius * math.tan(lean)
    return math.sqrt(abs(weight / factor(lean, track_radius, mass, radius, inertia))) if weight else 0.0


@mistake(first_fails=checks.rolling_precession_refuses_what_does_not_exist, compared=False)
def rolling_precession(reference, lean, track_radius, **disk):
    """You return Omega = 0 for every upright disk; raise ValueError on a point, where every Omega will do."""
    return reference(lean, track_radius, **disk) if lean else 0.0


@mistake(first_fails=checks.rolling_precession_refuses_what_does_not_exist, compared=False)
def rolling_precession(reference, lean, track_radius, *, mass, radius, inertia, gravity):
    """You divide by the factor of Omega^2, which may be zero; raise ValueError there."""
    weight = mass * gravity * radius * math.tan(lean)
    if weight == 0.0:
        return reference(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    square = weight / factor(lean, track_radius, mass, radius, inertia)
    if square < 0.0:
        raise ValueError("no Omega")
    return math.sqrt(square)


# Sliding, and both


@mistake(first_fails=checks.sliding_spin_balances_the_moments)
def sliding_spin(reference, lean, precession, **disk):
    """You return the spin of the rolling disk; without friction only the normal force has a moment about G."""
    return rolling_spin(lean, precession, **disk)


@mistake(first_fails=checks.sliding_spin_balances_the_moments)
def sliding_spin(reference, lean, precession, **disk):
    """You return the spin relative to the turning frame; return the total spin."""
    return reference(lean, precession, **disk) + precession * math.sin(lean)


@mistake(first_fails=checks.sliding_spin_balances_the_moments)
def sliding_spin(reference, lean, precession, **disk):
    """You subtract Omega sin(lean) from the total spin; the total spin has this part already."""
    return reference(lean, precession, **disk) - precession * math.sin(lean)


@mistake(first_fails=checks.sliding_track_is_around_the_resting_centre)
def sliding_track_radius(reference, lean, *, radius):
    """You use cos(lean); the lean is measured from the vertical."""
    return radius * math.cos(lean)


@mistake(first_fails=checks.common_precession_is_in_both_families)
def common_precession(reference, lean, *, mass, radius, inertia, gravity):
    """You use A + m a^2; G is at rest, so use A."""
    about_contact = inertia[0] + mass * radius**2, inertia[1]
    return reference(lean, mass=mass, radius=radius, inertia=about_contact, gravity=gravity)


@mistake(first_fails=checks.common_precession_has_a_limit_upright, compared=False)
def common_precession(reference, lean, **disk):
    """You divide by sin(lean), which is 0 upright; cancel it."""
    return reference(lean, **disk) * math.sin(lean) / math.sin(lean)


@mistake(first_fails=checks.contact_force_moves_the_centre)
def contact_force(reference, lean, precession, spin, **disk):
    """You move G on the contact's circle of radius R; the circle of G has the radius R - a sin(lean)."""
    return reference(lean, precession, spin + precession * math.sin(lean), **disk)


@mistake(first_fails=checks.contact_force_moves_the_centre)
def contact_force(reference, lean, precession, spin, **disk):
    """You use the spin as relative to the turning frame; it is the total spin."""
    return reference(lean, precession, spin - precession * math.sin(lean), **disk)


@mistake(first_fails=checks.contact_force_of_straight_rolling, compared=False)
def contact_force(reference, lean, precession, spin, *, mass, radius, gravity):
    """You divide by Omega for the circle of G; straight rolling has Omega = 0."""
    circle = radius * spin / precession
    return mass * precession**2 * circle, mass * gravity


@mistake(first_fails=checks.moment_residual_is_moment_minus_rate)
def moment_residual(reference, lean, precession, spin, inward, normal, *, mass, radius, inertia):
    """You use the inward force of steady rolling; use the given one."""
    rolling, _ = contact_force(lean, precession, spin, mass=mass, radius=radius, gravity=0.0)
    return reference(lean, precession, spin, rolling, normal, mass=mass, radius=radius, inertia=inertia)


@mistake(first_fails=checks.moment_residual_is_moment_minus_rate)
def moment_residual(reference, lean, precession, spin, inward, normal, **disk):
    """You use the spin as relative to the turning frame; it is the total spin."""
    return reference(lean, precession, spin - precession * math.sin(lean), inward, normal, **disk)


@mistake(first_fails=checks.moment_residual_is_moment_minus_rate)
def moment_residual(reference, lean, precession, spin, inward, normal, **disk):
    """You exchange the arms; the normal force has the arm a sin(lean), the inward one a cos(lean)."""
    return reference(lean, precession, spin, -normal, -inward, **disk)


@mistake(first_fails=checks.settling_energy_adds_up)
def settling_energy(reference, lean, *, mass, radius, inertia, gravity):
    """You use C/2 for A in the kinetic energy; A = C/2 only for a thin disk."""
    A, C = inertia
    height = mass * gravity * radius * math.cos(lean)
    return height * (1 + C / (4 * A))


@mistake(first_fails=checks.settling_energy_adds_up)
def settling_energy(reference, lean, **disk):
    """You set the potential to zero with the disk upright; it is zero with G on the ground."""
    return reference(lean, **disk) - disk["mass"] * disk["gravity"] * disk["radius"]


@mistake(first_fails=checks.settling_energy_adds_up)
def settling_energy(reference, lean, **disk):
    """You let the disk turn about the vertical with Omega; its total spin is zero, so omega is along a diameter."""
    turning = (common_precession(lean, **disk) * math.sin(lean)) ** 2
    return reference(lean, **disk) + disk["inertia"][1] * turning / 2
