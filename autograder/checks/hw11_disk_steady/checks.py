"""Hidden checks of hw11."""

from functools import partial

import numpy as np

from tam570_grader import Assignment, absolute, by_kind, group, law, number

from . import cases, reference

# Formulas agree to a few roundings, 1e-15; a root finder at its usual tolerance of 1e-12 loses two digits
# where the root is flat. Wrong physics is off by a tenth.
WITHIN = 1e-9
UPRIGHT = 1e-7  # the limit is taken at a lean of 1e-5, which enters by its square


def spin_size(force, case, _=None):
    lean, precession = case.args
    return reference.spin_size(lean, precession, force, **case.kwargs)


def track_size(case, _):
    return case.kwargs["radius"] * (1 + spin_size(reference.contact_force, case) / abs(case.args[1]))


def force_size(case, _):
    _, precession, spin = case.args
    known = case.kwargs
    return known["mass"] * (known["gravity"] + known["radius"] * (abs(precession * spin) + precession**2))


def residual_size(case, _):
    _, precession, spin, inward, normal = case.args
    turning = sum(case.kwargs["inertia"]) * (precession**2 + spin**2)
    return case.kwargs["radius"] * (abs(inward) + abs(normal)) + turning


def weight_moment(case, _):
    return case.kwargs["mass"] * case.kwargs["gravity"] * case.kwargs["radius"]


def radius(case, _):
    return case.kwargs["radius"]


WHICH_ARE_ZERO = "Which of its terms are zero there?"
BOTH_CONDITIONS = "Put the rolling condition into the balance of moments about G."
SAME_CIRCLE = "Both tracks must be the same circle: what is the spin then?"


def wrong_force(case, found, expected):
    """Which part of the force is wrong, and where it comes from."""
    inward, normal = np.isclose(found, expected)
    if normal and not inward:
        return "Only the inward force is wrong: G moves on a circle; what is its radius, and G's speed?"
    if inward and not normal:
        return "Only the normal force is wrong: how does the height of G change?"
    return "The results are (inward, normal): F = m a of G, which moves on a circle."


MOMENTS = by_kind({"before": "Is a result kept?"}, "The moment of the contact force about G is Omega z x H.")
WHICH_SIGN = "Which sign must the moment of the weight have?"
AT_REST = "The point of the disk on the ground has no velocity."
ABOUT_WHICH = "G is at rest: about which axis does the disk turn, and how high is G?"

# (a) Rolling

rolling_spin_balances_the_moments = law(
    "rolling_spin is the total spin that keeps lean and precession steady, in- or outwards.", points=1.25, part="a"
).agrees(reference.rolling_spin, cases.members, tolerance=WITHIN, hint=MOMENTS)
rolling_spin_holds_upright_and_without_gravity = rolling_spin_balances_the_moments.then(
    "rolling_spin holds for an upright disk and for no gravity.", points=0.25, part="a"
).agrees(reference.rolling_spin, cases.plain_members, tolerance=WITHIN, hint=WHICH_ARE_ZERO)
rolling_track_has_the_contact_at_rest = law(
    "rolling_track_radius is the radius, with its sign, of the contact point's track.", points=1, part="a"
).agrees(reference.rolling_track_radius, cases.members, cases.plain_members, tolerance=WITHIN, hint=AT_REST)
rolling_precession_balances_the_moments = law(
    "rolling_precession keeps the lean steady on the given track.", points=1.25, part="a"
).agrees(reference.rolling_precession, cases.tracks, tolerance=WITHIN, hint=BOTH_CONDITIONS)
rolling_precession_holds_on_tracks_of_any_sign = rolling_precession_balances_the_moments.then(
    "rolling_precession: the contact beyond the centre, a roller, a coin, an almost flat disk.", points=0.5, part="a"
).agrees(reference.rolling_precession, cases.tracks_of_any_sign, tolerance=WITHIN, hint=WHICH_SIGN)
rolling_precession_is_zero_where_nothing_turns_it = rolling_precession_balances_the_moments.then(
    "rolling_precession is 0 without gravity, or upright on any track but a point; only then.", points=0.5, part="a"
).agrees(reference.rolling_precession, cases.straight_tracks, tolerance=WITHIN, scale=absolute)
rolling_precession_refuses_what_does_not_exist = rolling_precession_balances_the_moments.then(
    "rolling_precession raises ValueError where no steady rolling exists, or any Omega does.", points=0.75, part="a"
).refuses(
    reference.rolling_precession, cases.impossible_tracks, tolerance=WITHIN, allowed=0, hint="What would Omega^2 be?"
)

# (b) Sliding

sliding_spin_balances_the_moments = (
    law("sliding_spin keeps lean and precession steady where only the normal force acts.", points=0.75, part="b")
    .agrees(reference.sliding_spin, cases.members, tolerance=WITHIN, hint="Which part of the contact force is gone?")
    .also.agrees(reference.sliding_spin, cases.plain_members, tolerance=WITHIN, hint=WHICH_ARE_ZERO)
)
sliding_track_is_around_the_resting_centre = law(
    "sliding_track_radius is the contact's distance from the vertical through G, signed as R is.", points=0.5, part="b"
).agrees(reference.sliding_track_radius, cases.sliding_tracks, tolerance=WITHIN, hint="Where is G?")

# (c) Both

common_precession_is_in_both_families = law(
    "common_precession belongs to the motions that roll and slide at once.", points=0.75, part="c"
).agrees(reference.common_precession, cases.settled, tolerance=WITHIN, hint=SAME_CIRCLE)
common_precession_has_a_limit_upright = (
    common_precession_is_in_both_families.then(
        "common_precession at lean 0 is its limit, next to 0 near it; almost flat it holds.", points=0.25, part="c"
    )
    .agrees(reference.common_precession, cases.next_to_upright, tolerance=UPRIGHT, hint="Cancel the sine first.")
    .also.agrees(reference.common_precession, cases.steep, tolerance=WITHIN)
)
contact_force_moves_the_centre = law(
    "contact_force gives the mass its centripetal acceleration and carries its weight.", points=0.5, part="c"
).agrees(reference.contact_force, cases.whirls, tolerance=WITHIN, hint=wrong_force)
contact_force_of_straight_rolling = contact_force_moves_the_centre.then(
    "contact_force: an upright disk without precession rolls straight on, its weight carried.", points=0.25, part="c"
).agrees(reference.contact_force, cases.straight_rolling, tolerance=WITHIN, hint="Nothing there goes round.")
moment_residual_is_moment_minus_rate = law(
    "moment_residual: moment less rate of angular momentum about G, for any motion and force.", points=0.75, part="c"
).agrees(
    reference.moment_residual,
    cases.under_forces,
    tolerance=WITHIN,
    hint="What is the force's arm, and what of H turns?",
)

# (d) The shuddering coin

settling_energy_adds_up = law(
    "settling_energy: kinetic and potential energy of the motion that rolls and slides at once.", points=0.75, part="d"
).agrees(
    reference.settling_energy, cases.settled, cases.next_to_upright, cases.steep, tolerance=WITHIN, hint=ABOUT_WHICH
)


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
