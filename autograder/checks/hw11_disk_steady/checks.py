"""Hidden checks of hw11."""

from functools import partial

import numpy as np

from tam570_grader import agree, check, group, number, refuse

from . import cases, right

RESULTS = {
    "rolling_precession": number,
    "rolling_spin": number,
    "rolling_track_radius": number,
    "sliding_spin": number,
    "sliding_track_radius": number,
    "common_precession": number,
    "contact_force": group(number, number),
    "moment_residual": number,
    "settling_energy": number,
}
NEEDS = ("numpy",)
MANUAL = {"d": (2, "which of these motions a shuddering coin follows, and why")}

# Formulas agree to a few roundings, 1e-15; a root finder at its usual tolerance of 1e-12 loses two digits
# where the root is flat. Wrong physics is off by a tenth.
WITHIN = 1e-9
UPRIGHT = 1e-7  # the limit is taken at a lean of 1e-5, which enters by its square


def spin_size(force, case, _=None):
    lean, precession = case.args
    return right.spin_size(lean, precession, force, **case.kwargs)


def track_size(case, _):
    return case.kwargs["radius"] * (1 + spin_size(right.contact_force, case) / abs(case.args[1]))


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


ROLLING_SPIN = {"of": "the spin", "unit": "rad/s", "scale": partial(spin_size, right.contact_force)}
SLIDING_SPIN = {**ROLLING_SPIN, "scale": partial(spin_size, right.sliding_force)}
TRACK = {"of": "the radius of the track", "unit": "m"}
PRECESSION = {"of": "the precession", "unit": "rad/s"}
BOTH_FORCES = {"of": ("the inward force", "the normal force"), "unit": "N", "scale": force_size}
WHICH_ARE_ZERO = "Which of its terms are zero there?"


@check(points=1.25, part="a")
def rolling_spin_balances_the_moments(student, draw):
    """rolling_spin is the total spin that keeps lean and precession steady, leaning inwards or outwards."""
    hint = "The moment of the contact force about G is Omega z x H."
    agree(student.rolling_spin, right.rolling_spin, cases.members(draw), within=WITHIN, hint=hint, **ROLLING_SPIN)


@check(points=0.25, part="a", after=rolling_spin_balances_the_moments)
def rolling_spin_holds_upright_and_without_gravity(student, draw):
    """rolling_spin holds for an upright disk and for no gravity."""
    calls = cases.plain_members(draw)
    agree(student.rolling_spin, right.rolling_spin, calls, within=WITHIN, hint=WHICH_ARE_ZERO, **ROLLING_SPIN)


@check(points=1, part="a")
def rolling_track_has_the_contact_at_rest(student, draw):
    """rolling_track_radius is the radius, with its sign, of the contact point's track."""
    known = {
        "within": WITHIN,
        "scale": track_size,
        "hint": "The point of the disk on the ground has no velocity.",
        **TRACK,
    }
    for calls in (cases.members(draw), cases.plain_members(draw)):
        agree(student.rolling_track_radius, right.rolling_track_radius, calls, **known)


@check(points=1.25, part="a")
def rolling_precession_balances_the_moments(student, draw):
    """rolling_precession keeps the lean steady on the given track."""
    known = {"within": WITHIN, "hint": "Put the rolling condition into the balance of moments about G.", **PRECESSION}
    agree(student.rolling_precession, right.rolling_precession, cases.tracks(draw), **known)


@check(points=0.5, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_holds_on_tracks_of_any_sign(student, draw):
    """rolling_precession holds with the contact beyond the centre, for a roller, for a coin, and almost flat."""
    known = {"within": WITHIN, "hint": "Which sign must the moment of the weight have?", **PRECESSION}
    agree(student.rolling_precession, right.rolling_precession, cases.tracks_of_any_sign(draw), **known)


def one(*_):
    return 1.0


@check(points=0.5, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_is_zero_where_nothing_turns_it(student, draw):
    """rolling_precession is 0 without gravity, or for an upright disk unless its track is a point, and only then."""
    calls = cases.straight_tracks(draw)
    agree(student.rolling_precession, right.rolling_precession, calls, within=WITHIN, scale=one, **PRECESSION)


@check(points=0.75, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_refuses_what_does_not_exist(student, draw):
    """rolling_precession raises ValueError where no steady rolling exists, or every Omega would do."""
    calls, hint = cases.impossible_tracks(draw), "What would Omega^2 be?"
    refuse(student.rolling_precession, calls, accepts=(), within=WITHIN, hint=hint)


# (b) Sliding


@check(points=0.75, part="b")
def sliding_spin_balances_the_moments(student, draw):
    """sliding_spin is the total spin that keeps lean and precession steady where only the normal force acts."""
    hints = "Which part of the contact force is gone?", WHICH_ARE_ZERO
    for calls, hint in zip((cases.members(draw), cases.plain_members(draw)), hints, strict=True):
        agree(student.sliding_spin, right.sliding_spin, calls, within=WITHIN, hint=hint, **SLIDING_SPIN)


@check(points=0.5, part="b")
def sliding_track_is_around_the_resting_centre(student, draw):
    """sliding_track_radius is the contact's distance from the vertical through G, signed as R is."""
    known = {"within": WITHIN, "scale": radius, "hint": "Where is G?", **TRACK}
    agree(student.sliding_track_radius, right.sliding_track_radius, cases.sliding_tracks(draw), **known)


# (c) Both


@check(points=0.75, part="c")
def common_precession_is_in_both_families(student, draw):
    """common_precession belongs to the motions that roll and slide at once."""
    hint = "Both tracks must be the same circle: what is the spin then?"
    agree(
        student.common_precession, right.common_precession, cases.settled(draw), within=WITHIN, hint=hint, **PRECESSION
    )


@check(points=0.25, part="c", after=common_precession_is_in_both_families)
def common_precession_has_a_limit_upright(student, draw):
    """common_precession at lean 0 is its limit, next to 0 it is near, and almost flat it holds."""
    known = {"hint": "Cancel the sine first.", **PRECESSION}
    agree(student.common_precession, right.common_precession, cases.next_to_upright(draw), within=UPRIGHT, **known)
    agree(student.common_precession, right.common_precession, cases.steep(draw), within=WITHIN, **PRECESSION)


def wrong_force(case, found, expected):
    """Which part of the force is wrong, and where it comes from."""
    inward, normal = np.isclose(found, expected)
    if normal and not inward:
        return "Only the inward force is: G moves on a circle; what is its radius, and G's speed?"
    if inward and not normal:
        return "Only the normal force is: how does the height of G change?"
    return "The results are (inward, normal): F = m a of G, which moves on a circle."


@check(points=0.5, part="c")
def contact_force_moves_the_centre(student, draw):
    """contact_force gives the mass its centripetal acceleration and carries its weight."""
    calls = [cases.without(case, "inertia") for case in cases.whirls(draw)]
    agree(student.contact_force, right.contact_force, calls, within=WITHIN, hint=wrong_force, **BOTH_FORCES)


@check(points=0.25, part="c", after=contact_force_moves_the_centre)
def contact_force_of_straight_rolling(student, draw):
    """contact_force: an upright disk without precession rolls straight on, and the ground carries its weight."""
    calls, hint = cases.straight_rolling(draw), "Nothing there goes round."
    agree(student.contact_force, right.contact_force, calls, within=WITHIN, hint=hint, **BOTH_FORCES)


@check(points=0.75, part="c")
def moment_residual_is_moment_minus_rate(student, draw):
    """moment_residual is the moment about G less the rate of angular momentum, for any motion and force."""
    known = {
        "of": "the residual",
        "unit": "N m",
        "scale": residual_size,
        "hint": "Omega z x H: which parts of H go round?",
    }
    agree(student.moment_residual, right.moment_residual, cases.under_forces(draw), within=WITHIN, **known)


# (d) The shuddering coin


@check(points=0.75, part="d")
def settling_energy_adds_up(student, draw):
    """settling_energy is the kinetic and potential energy of the motion that rolls and slides at once."""
    calls = cases.settled(draw) + cases.next_to_upright(draw)[:1] + cases.steep(draw)
    known = {"of": "the energy", "unit": "J", "scale": weight_moment}
    hint = "G is at rest; about which axis does the disk turn?"
    agree(student.settling_energy, right.settling_energy, calls, within=WITHIN, hint=hint, **known)
