"""Hidden checks of hw11."""

from functools import partial

import numpy as np

from tam570_grader import Assignment, absolute, check, check_domain, compare_with, group, number

from . import cases, reference

# Formulas agree up to a few rounding errors, 1e-15; a root finder at its usual tolerance of 1e-12 loses two digits if
# the root is flat. The error of wrong physics is a tenth.
WITHIN = 1e-9
BALANCE = "With it, and inward = 0 and normal = m g, is your moment_residual zero?"
WHICH_ARE_ZERO = "Which of its terms are zero there?"
UPRIGHT = 1e-7  # the reference takes the limit at a lean of 1e-5, which enters by its square

compare = compare_with(reference, tolerance=WITHIN)


def spin_size(force, case, _=None):
    lean, precession = case.args
    return reference.spin_size(lean, precession, force, **case.kwargs)


def track_size(case, _):
    return case.kwargs["radius"] * (1 + spin_size(reference.contact_force, case) / abs(case.args[1]))


def force_size(case, _):
    _, precession, spin = case.args
    disk = case.kwargs
    return disk["mass"] * (disk["gravity"] + disk["radius"] * (abs(precession * spin) + precession**2))


def residual_size(case, _):
    _, precession, spin, inward, normal = case.args
    turning = sum(case.kwargs["inertia"]) * (precession**2 + spin**2)
    return case.kwargs["radius"] * (abs(inward) + abs(normal)) + turning


def weight_moment(case, _):
    return case.kwargs["mass"] * case.kwargs["gravity"] * case.kwargs["radius"]


def radius(case, _):
    return case.kwargs["radius"]


def wrong_force(case, result, expected):
    """Return which part of the force is wrong, and where it comes from."""
    inward, normal = np.isclose(result, expected)
    if normal and not inward:
        return "Only the inward force is wrong: G moves on a circle; what is its radius, and G's speed?"
    if inward and not normal:
        return "Only the normal force is wrong: how does the height of G change?"
    return "The results are (inward, normal): F = m a of G, which moves on a circle."


# The balance of moments and the force come first: many students solve these for the spins.


@check("moment_residual", points=0.75, part="c")
def moment_residual_is_moment_minus_rate(student, rng):
    """moment less rate of angular momentum about G, for any motion and force."""
    compare(student.moment_residual, cases.under_forces(rng), hint="What is the force's arm, and what of H turns?")


@check("contact_force", points=0.5, part="c")
def contact_force_moves_the_centre(student, rng):
    """contact_force gives the mass its centripetal acceleration and carries its weight."""
    compare(student.contact_force, cases.whirls(rng), hint=wrong_force)


@check("contact_force", points=0.25, part="c", after=contact_force_moves_the_centre)
def contact_force_of_straight_rolling(student, rng):
    """an upright disk without precession rolls straight on, its weight carried."""
    compare(student.contact_force, cases.straight_rolling(rng), hint="Nothing there goes round.")


# (a) Rolling


@check("rolling_spin", points=1.25)
def rolling_spin_balances_the_moments(student, rng):
    """rolling_spin is the total spin that keeps lean and precession steady, in- or outwards."""
    compare(student.rolling_spin, cases.members(rng), hint="The moment of the contact force about G is Omega z x H.")


@check("rolling_spin", points=0.25, after=rolling_spin_balances_the_moments)
def rolling_spin_holds_upright_and_without_gravity(student, rng):
    """rolling_spin holds for an upright disk and for no gravity."""
    compare(student.rolling_spin, cases.plain_members(rng), hint=WHICH_ARE_ZERO)


@check("rolling_track_radius", points=1)
def rolling_track_has_the_contact_at_rest(student, rng):
    """rolling_track_radius is the radius, with its sign, of the contact point's track."""
    hint = "The point of the disk on the ground has no velocity."
    compare(student.rolling_track_radius, [*cases.members(rng), *cases.plain_members(rng)], hint=hint)


@check("rolling_precession", points=1.25)
def rolling_precession_balances_the_moments(student, rng):
    """rolling_precession keeps the lean steady on the given track."""
    hint = "Put the rolling condition into the balance of moments about G."
    compare(student.rolling_precession, cases.tracks(rng), hint=hint)


@check("rolling_precession", points=0.5, after=rolling_precession_balances_the_moments)
def rolling_precession_holds_on_tracks_of_any_sign(student, rng):
    """the contact beyond the centre, a roller, a coin, an almost flat disk."""
    hint = "Which sign must the moment of the weight have?"
    compare(student.rolling_precession, cases.tracks_of_any_sign(rng), hint=hint)


@check("rolling_precession", points=0.5, after=rolling_precession_balances_the_moments)
def rolling_precession_is_zero_where_nothing_turns_it(student, rng):
    """rolling_precession is 0 without gravity, or upright on any track but a point; only then."""
    compare(student.rolling_precession, cases.straight_tracks(rng), scale=absolute)


@check("rolling_precession", points=0.75, after=rolling_precession_balances_the_moments, refusals=True)
def rolling_precession_refuses_what_does_not_exist(student, rng):
    """rolling_precession raises ValueError where no steady rolling exists, or any Omega does."""
    calls, hint = cases.impossible_tracks(rng), "What would Omega^2 be?"
    check_domain(student.rolling_precession, reference, calls, tolerance=WITHIN, allowed=0, hint=hint)


# (b) Sliding


@check("sliding_spin", points=0.75, part="b")
def sliding_spin_balances_the_moments(student, rng):
    """sliding_spin keeps lean and precession steady where only the normal force acts."""
    compare(student.sliding_spin, cases.members(rng), hint=BALANCE)
    compare(student.sliding_spin, cases.plain_members(rng), hint=WHICH_ARE_ZERO)


@check("sliding_track_radius", points=0.5, part="b")
def sliding_track_is_around_the_resting_centre(student, rng):
    """sliding_track_radius is the contact's distance from the vertical through G, signed as R is."""
    compare(student.sliding_track_radius, cases.sliding_tracks(rng), hint="Where is G?")


# (c) Both


@check("common_precession", points=0.75, part="c")
def common_precession_is_in_both_families(student, rng):
    """common_precession belongs to the motions that roll and slide at once."""
    hint = "Both tracks must be the same circle: what is the spin then?"
    compare(student.common_precession, cases.settled(rng), hint=hint)


@check("common_precession", points=0.25, part="c", after=common_precession_is_in_both_families)
def common_precession_has_a_limit_upright(student, rng):
    """common_precession at lean 0 is its limit, next to 0 near it; almost flat it holds."""
    compare(student.common_precession, cases.next_to_upright(rng), tolerance=UPRIGHT, hint="Cancel the sine first.")
    compare(student.common_precession, cases.steep(rng))


# (d) The shuddering coin


@check("settling_energy", points=0.75, part="d")
def settling_energy_adds_up(student, rng):
    """kinetic and potential energy of the motion that rolls and slides at once."""
    calls = [*cases.settled(rng), *cases.next_to_upright(rng), *cases.steep(rng)]
    hint = "G is at rest: about which axis does the disk turn, and how high is G?"
    compare(student.settling_energy, calls, hint=hint)


ASSIGNMENT = Assignment(
    returns={
        "rolling_precession": number.described("the precession", "rad/s"),
        "rolling_spin": number.described("the spin", "rad/s", partial(spin_size, reference.contact_force)),
        "rolling_track_radius": number.described("the radius of the track", "m", track_size),
        "sliding_spin": number.described("the spin", "rad/s", partial(spin_size, reference.sliding_force)),
        "sliding_track_radius": number.described("the radius of the track", "m", radius),
        "common_precession": number.described("the precession", "rad/s"),
        "contact_force": group(
            *(number.described(f"the {way} force", "N", force_size) for way in ("inward", "normal"))
        ),
        "moment_residual": number.described("the residual", "N m", residual_size),
        "settling_energy": number.described("the energy", "J", weight_moment),
    },
    forbidden={},
    needs=("numpy",),
)
