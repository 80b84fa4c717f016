"""Hidden checks of hw07."""

import math

import numpy as np

from tam570_grader import (
    Column,
    Invariant,
    agree,
    array,
    check,
    curves_seen,
    drawing,
    follow,
    given,
    group,
    judge_axes_of_lengths,
    number,
    path_drawn,
    rows,
    stays,
)

from . import cases, right

RESULTS = {
    "mass_matrix": array(2, 2),
    "velocity_terms": array(2),
    "gravity_terms": array(2),
    "angular_acceleration": array(2),
    "on_the_fly": group(array(2), array(2, 2)),
    "energy": number,
    "angular_momentum": number,
    "simulate": rows(4),
    "small_oscillation_frequencies": array(2),
    "wireframe": array(2, 2, 2),
    "plot_tip_path": drawing,
}
NEEDS = ("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg")
MANUAL = {"c": (2, "the special cases checked, and what they showed")}

FORMULA = 1e-8  # a few roundings make 1e-15, derivatives of energies by central differences 1e-9
# Ten equations for unscaled unknowns, one bar 1e-9 of the other, are solved to 1e-14 by LU, to 6e-6 by least squares
# or a pseudoinverse (the largest of 5000 draws); by the Schur complement of the constraints to 2e-6.
MASSLESS = 5e-5
FREQUENCY = 1e-6  # an eigenvalue of a matrix that is not symmetric, next to another: 1e-9
FOLLOWED = 1e-4  # RK45, DOP853 and LSODA at rtol 1e-9, atol 1e-9 are off by 1e-5 at most, sensitive starts included
ENERGY = 1e-5  # of m g l; the same solvers lose 5e-8 of it in ten seconds, a symplectic method of fixed steps 1e-6
DRAWN = 1e-3  # of the length; the path between 400 points bends by 2e-4 of it


def inertia(case, _=None):
    return np.sum(case.kwargs["masses"]) * np.max(case.kwargs["lengths"]) ** 2


def rate2(case, _=None):
    """Square of the angular velocities, or of sqrt(g/l)."""
    omega = case.args[-1] if len(case.args) > 1 else np.zeros(2)
    return np.max(omega**2) + case.kwargs.get("gravity", 0.0) / np.min(case.kwargs["lengths"])


def moment(case, _=None):
    return inertia(case) * rate2(case)


def force(case, _=None):
    return moment(case) / np.max(case.kwargs["lengths"])


def spin(case, _=None):
    return inertia(case) * math.sqrt(rate2(case))


MOTION = (Column("an angle", "rad", [0, 1], turns=True), Column("an angular velocity", "rad/s", [2, 3]))
KEPT_ENERGY = Invariant("the energy", "of m g l", right.along(right.energy), moment, ENERGY)
KEPT_MOMENTUM = Invariant(
    "the angular momentum",
    "of m l^2 omega",
    lambda rows, gravity, **bars: right.along(right.angular_momentum)(rows, **bars),
    spin,
    ENERGY,
)


@check(points=1, part="a")
def mass_matrix_makes_the_kinetic_energy(student, draw):
    """mass_matrix: half of omega . M omega is the kinetic energy of the two bars."""
    calls = cases.with_plain(cases.resting(draw, 8, "masses", "lengths"))
    hint = "write the velocities of both mass centres by the absolute angular velocities"
    agree(
        student.mass_matrix, right.mass_matrix, calls, within=FORMULA, of="[M]", unit="kg m^2", scale=inertia, hint=hint
    )


@check(points=1, part="a")
def velocity_terms_are_centripetal(student, draw):
    """velocity_terms: {f} of Lagrange's equations."""
    calls = cases.with_plain(cases.moving(draw, 8, "masses", "lengths"))
    hint = "which way does each mass centre accelerate when alpha is zero?"
    agree(
        student.velocity_terms,
        right.velocity_terms,
        calls,
        within=FORMULA,
        of="{f}",
        unit="N m",
        scale=moment,
        hint=hint,
    )


@check(points=0.75, part="a")
def gravity_terms_are_moments_of_the_weights(student, draw):
    """gravity_terms: {g}, the derivatives of the potential energy by th1 and th2."""
    calls = cases.with_plain(cases.resting(draw, 8, "masses", "lengths", "gravity"))
    hint = "how does the height of each mass centre change with each angle?"
    agree(
        student.gravity_terms, right.gravity_terms, calls, within=FORMULA, of="{g}", unit="N m", scale=moment, hint=hint
    )


STILL_COUPLED = "without gravity the bars still act on each other: why does neither accelerate?"


def in_equations(case, found, _):
    if not np.any(found) and case.kwargs["gravity"] == 0:
        return STILL_COUPLED
    return "put alpha back into [M]{alpha} + {f} + {g}: is it zero?"


@check(points=0.75, part="a")
def accelerations_obey_the_equations(student, draw):
    """angular_acceleration: [M]{alpha} + {f} + {g} = 0, without gravity too."""
    calls = cases.with_plain(cases.moving(draw, 8) + cases.moving(draw, 3, gravity=0.0))
    known = {"of": "alpha", "unit": "rad/s^2", "scale": rate2, "hint": in_equations}
    agree(student.angular_acceleration, right.angular_acceleration, calls, within=FORMULA, **known)


SCALED = "do rows of your linear system differ in size by 1e-9?"


@check(points=0.25, part="a", after=accelerations_obey_the_equations)
def accelerations_with_a_nearly_massless_bar(student, draw):
    """angular_acceleration keeps its digits when one bar has 1e-9 of the other's mass."""
    known = {"of": "alpha", "unit": "rad/s^2", "scale": rate2, "hint": SCALED}
    agree(
        student.angular_acceleration, right.angular_acceleration, cases.nearly_massless(draw), within=MASSLESS, **known
    )


FLY = {"of": ("alpha", "a hinge force"), "unit": ("rad/s^2", "N"), "scale": (rate2, force)}


def flown(draw):
    return cases.with_plain(cases.moving(draw, 7) + cases.moving(draw, 3, gravity=0.0))


@check(points=0.5, part="a")
def free_bars_accelerate_as_lagranges(student, draw):
    """on_the_fly: alpha from two free bars and two hinge constraints."""
    hint = "two bars have three equations each, two hinges two constraints each: do you solve all ten?"
    agree(student.on_the_fly, right.on_the_fly, flown(draw), within=FORMULA, only=0, hint=hint, **FLY)


@check(points=0.75, part="a", after=free_bars_accelerate_as_lagranges)
def hinge_forces_balance(student, draw):
    """on_the_fly: with the hinge forces and the weights each bar obeys Newton's law."""
    hint = "at rest the ceiling carries both weights, and bar 1 carries bar 2: which rows, which signs?"
    agree(student.on_the_fly, right.on_the_fly, flown(draw), within=FORMULA, only=1, hint=hint, **FLY)


@check(points=0.25, part="a", after=free_bars_accelerate_as_lagranges)
def free_bars_with_a_nearly_massless_one(student, draw):
    """on_the_fly keeps its digits when one bar has 1e-9 of the other's mass, and when both hang straight down."""
    calls = cases.nearly_massless(draw)
    agree(student.on_the_fly, right.on_the_fly, calls, within=MASSLESS, only=0, hint=SCALED, **FLY)
    agree(student.on_the_fly, right.on_the_fly, cases.straight_down(draw), within=FORMULA, only=0, **FLY)


@check(points=0.75, part="a")
def energy_is_kinetic_and_potential(student, draw):
    """energy: kinetic energy of turning bars, potential energy of their mass centres, zero at the ceiling."""
    calls = cases.with_plain(cases.moving(draw, 10))
    hint = "hanging at rest, below the ceiling, it is negative"
    agree(student.energy, right.energy, calls, within=FORMULA, of="the energy", unit="J", scale=moment, hint=hint)


@check(points=0.75, part="a")
def angular_momentum_is_about_the_ceiling(student, draw):
    """angular_momentum: r x m v and I omega of both bars, about the ceiling hinge."""
    calls = cases.with_plain(cases.moving(draw, 10, "masses", "lengths"))
    hint = "each bar has the angular momentum of its mass centre and that about its mass centre"
    known = {"of": "the angular momentum", "unit": "kg m^2/s", "scale": spin, "hint": hint}
    agree(student.angular_momentum, right.angular_momentum, calls, within=FORMULA, **known)


@check(points=0.75, part="a")
def simulation_follows_the_equations(student, draw):
    """simulate: angles and angular velocities at uneven times, whatever t[0] is."""
    follow(student.simulate, right.motion, cases.motions(draw), MOTION, within=FOLLOWED, keeps=KEPT_ENERGY)


@check(points=0.5, part="a", after=simulation_follows_the_equations)
def energy_is_conserved_from_horizontal(student, draw):
    """simulate: from (pi/2, pi/2) at rest the energy stays for ten seconds."""
    share = {1e-4: 0.75, 1e-3: 0.5, 1e-2: 0.25}
    stays(student.simulate, right.motion, cases.from_horizontal(draw), MOTION, KEPT_ENERGY, coarsely=0.5, partial=share)


@check(points=0.25, part="a", after=simulation_follows_the_equations)
def momentum_is_conserved_without_gravity(student, draw):
    """simulate: without gravity energy and angular momentum stay."""
    calls = cases.weightless(draw)
    hint = "without gravity the same equations hold: do you divide by it?"
    stays(student.simulate, right.motion, calls, MOTION, KEPT_MOMENTUM, coarsely=FOLLOWED, hint=hint)
    stays(student.simulate, right.motion, calls, MOTION, KEPT_ENERGY, coarsely=FOLLOWED, hint=hint)


def in_order(case, found, expected):
    swapped = np.allclose(np.sort(found), expected, rtol=FREQUENCY, atol=0)
    return "they are right, but not in ascending order" if swapped else "for small angles sin th is th"


OSCILLATION = {"of": "a frequency", "unit": "rad/s", "hint": in_order}


@check(points=0.5, part="a")
def small_oscillations_have_two_frequencies(student, draw):
    """small_oscillation_frequencies: of [M]{th}'' + [K]{th} = 0 about hanging straight down."""
    calls = [given(**cases.pendulum(draw)).on("random masses and lengths") for _ in range(10)]
    agree(student.small_oscillation_frequencies, right.frequencies, calls, within=FREQUENCY, **OSCILLATION)


@check(points=0.25, part="a", after=small_oscillations_have_two_frequencies)
def frequencies_in_special_cases(student, draw):
    """small_oscillation_frequencies: equal bars, a nearly massless bar, no gravity."""
    agree(
        student.small_oscillation_frequencies, right.frequencies, cases.special(draw), within=FREQUENCY, **OSCILLATION
    )


@check(points=0.5, part="a")
def wireframe_shows_the_bars(student, draw):
    """wireframe: ceiling hinge to elbow, elbow to tip."""
    calls = cases.with_plain([given(cases.angles(draw), **cases.pendulum(draw, "lengths")) for _ in range(8)])
    hint = "theta zero is down, a positive angle to the right"
    agree(student.wireframe, right.wireframe, calls, within=FORMULA, of="an end of a bar", unit="m", hint=hint)


@check(points=0.5, part="d")
def tip_path_is_drawn(student, draw):
    """plot_tip_path draws the tip's path from t[0] to t[-1], at equal scales."""
    case = cases.tip_path(draw)
    frames = np.array(
        [right.wireframe(row[:2], case.kwargs["lengths"]) for row in right.motion(*case.args, **case.kwargs)]
    )
    elbows, tips = frames[:, :, 1].swapaxes(0, 1)
    others = {
        "it is the elbow's path": elbows,
        "it is the path of bar 2's mass centre": (elbows + tips) / 2,
        "it is the tip's path as seen from the elbow": tips - elbows,
    }
    picture = student.plot_tip_path.drawn(case)
    (line,) = curves_seen(picture, 1)
    path_drawn(line, tips, within=DRAWN, of="the curve", others=others)
    judge_axes_of_lengths(picture)
