"""Hidden checks of hw07."""

import numpy as np

from tam570_grader import Assignment, Case, check, once
from tam570_grader.checks.compare import Column, check_raises, compare_with, first_wrong, trim_to_signature
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.plots import curves_seen, judge_axes_of_lengths, path_drawn
from tam570_grader.checks.returns import array, drawing, free_body_diagram, group, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_trajectory

from . import cases, reference
from .equations import agree_in_equations

FORMULA = 1e-8  # a few rounding errors make 1e-15, derivatives of energies by central differences 1e-9
# If one bar has 1e-9 of the other's mass, the ten equations for unscaled unknowns are solved to 1e-14 by LU, to 6e-6 by
# least squares or a pseudoinverse (the largest of 5000 draws), and to 2e-6 by the Schur complement of the constraints.
MASSLESS = 5e-5
FREQUENCY = 1e-6  # an eigenvalue of an asymmetric matrix, next to another, has an error of 1e-9
FOLLOWED = 1e-4  # RK45, DOP853 and LSODA at rtol 1e-9, atol 1e-9 have errors of 1e-5 at most, also for sensitive starts
ENERGY = 1e-5  # of m g l; the same solvers lose 5e-8 of it in ten seconds, a symplectic method of fixed steps 1e-6
SHARES = {1e-4: 0.75, 1e-3: 0.5, 1e-2: 0.25}
ROUGHLY = 0.02  # of the scale: in ten seconds errors grow a thousandfold, small ones to 1e-4; wrong motions make .3
DRAWN = 1e-3  # of the length; chords between the 529 points deviate from the path by up to 4e-5 of it (30 draws)

compare = compare_with(reference, tolerance=FORMULA)
compare_conserved = compare_with(reference, by=check_conserved)


def power_of_rate(n, mass=1, length=2):
    """Return the scale m^mass l^length rate^n of a case, with the rate of the angular velocities and sqrt(g/l)."""

    def scale(case, _=None):
        omega, lengths = case.args[-1] if len(case.args) > 1 else np.zeros(2), case.kwargs["lengths"]
        rate2 = np.max(omega**2) + case.kwargs.get("gravity", 0.0) / np.min(lengths)
        return np.sum(case.kwargs["masses"]) ** mass * np.max(lengths) ** length * rate2 ** (n / 2)

    return scale


INERTIA, SPIN, MOMENT = power_of_rate(0), power_of_rate(1), power_of_rate(2)
FORCE, RATE2 = power_of_rate(2, length=1), power_of_rate(2, mass=0, length=0)
MOTION = (Column("an angle", "rad", [0, 1], turns=True), Column("an angular velocity", "rad/s", [2, 3]))
RATES = OwnRates("angular_acceleration", reference, lambda t, row: (row[:2], row[2:]))
KEPT_ENERGY = Invariant("the energy", "of m g l", reference.energies, MOMENT, ENERGY)
KEPT_MOMENTUM = Invariant("the angular momentum", "of m l^2 omega", reference.momenta, SPIN, ENERGY)


@check("free_body_diagram", points=0.5)
def forces_on_each_bar(student, rng):
    """every force on each bar, where it acts and along what."""
    calls = cases.free_bars(rng)
    compare_diagrams(student.free_body_diagram, reference, calls)
    bad = [call.replace(bar).labelled("another bar") for call in calls[:1] for bar in (0, 3, -1)]
    hint = "Only 1 and 2 are bars."
    check_raises(student.free_body_diagram, trim_to_signature(reference.free_body_diagram, bad), hint=hint)


def of_accelerations(otherwise):
    """Return a hint for alpha: `otherwise`, unless it is zero without gravity."""

    def hint(case, alpha, _):
        if not np.any(alpha) and case.kwargs["gravity"] == 0:
            return "Without gravity the bars still act on each other: why does neither accelerate?"
        return otherwise

    return hint


def out_of_order(case, result, expected):
    swapped = np.allclose(np.sort(result), expected, rtol=FREQUENCY, atol=0)
    return "They are right, but not in ascending order." if swapped else ""


def in_order(case, result, expected):
    return out_of_order(case, result, expected) or "Put each one into det([K] - omega^2 [M]): is it zero?"


def of_energy(case, energy, expected):
    """Return which of kinetic and potential energy is right."""
    (theta, omega), near = case.args, FORMULA * MOMENT(case)
    potential = reference.energy(theta, 0 * omega, **case.kwargs)
    kinetic = expected - potential
    if abs(energy - kinetic + potential) <= near:
        return "The potential energy has the wrong sign: hanging at rest, below the ceiling, it is negative."
    lowest = reference.energy(0 * theta, 0 * omega, **case.kwargs)
    if abs(energy - expected + lowest) <= near:
        return "The potential energy is zero at the height of the ceiling, not in the lowest position."
    return "At rest it is the weights times the heights; add what each mass centre moves, and what turns about it."


# Where to look
PUT_BACK = "Put alpha back into [M]{alpha} + {f} + {g}: is it zero?"
SCALED = "Is anything added to the masses, or do rows of your linear system differ in size by 1e-9?"


@check("mass_matrix", points=1)
def mass_matrix_makes_the_kinetic_energy(student, rng):
    """[M] of Lagrange's equations, or of the two that your {f} and {g} belong to."""
    hint = "Write the velocities of both mass centres by the absolute angular velocities"
    agree_in_equations(student.mass_matrix, cases.states(rng), tolerance=FORMULA, hint=hint)


@check("velocity_terms", points=1)
def velocity_terms_are_centripetal(student, rng):
    """{f} of Lagrange's equations, or of the two that your [M] and {g} belong to."""
    hint = "Which way does each mass centre accelerate when alpha is zero, and which moment has m a of that?"
    agree_in_equations(student.velocity_terms, cases.states(rng), tolerance=FORMULA, hint=hint)


@check("gravity_terms", points=0.75)
def gravity_terms_are_moments_of_the_weights(student, rng):
    """{g} of Lagrange's equations, or of the two that your [M] and {f} belong to."""
    hint = "Which lever has each weight, or how does the height of each mass centre change with each angle?"
    agree_in_equations(student.gravity_terms, cases.states(rng), tolerance=FORMULA, hint=hint)


@check("angular_acceleration", points=0.75)
def accelerations_obey_the_equations(student, rng):
    """[M]{alpha} + {f} + {g} = 0, without gravity too."""
    compare(student.angular_acceleration, cases.states(rng), hint=of_accelerations(PUT_BACK))


@check("angular_acceleration", points=0.25, after=accelerations_obey_the_equations)
def accelerations_with_a_nearly_massless_bar(student, rng):
    """angular_acceleration keeps its digits when one bar has 1e-9 of the other's mass."""
    compare(student.angular_acceleration, cases.nearly_massless(rng), tolerance=MASSLESS, hint=of_accelerations(SCALED))


def the_unbalanced(case, result, expected):
    """Return the name of the balance that does not hold, with the accelerations that the hinges give."""
    off = reference.unbalanced(*case.args, *result, **case.kwargs)
    (*wrong,) = np.flatnonzero(off > FORMULA * off.max())
    if len(wrong) > 1:
        return "Two bars have three equations each, two hinges two constraints each: do you solve all ten?"
    bar, axis = divmod(wrong[0], 3)
    if axis == 2:
        return f"Only the moments on bar {bar + 1} about its mass centre do not balance"
    return (
        f"Only {'xy'[axis]} of Newton's law for bar {bar + 1} does not hold: look at it, and at this hinge's constraint"
    )


@check("on_the_fly", points=0.5)
def free_bars_accelerate_as_lagranges(student, rng):
    """alpha from two free bars and two hinge constraints."""
    compare(student.on_the_fly, cases.states(rng), only=0, hint=the_unbalanced)


@check("on_the_fly", points=0.75, after=free_bars_accelerate_as_lagranges)
def hinge_forces_balance(student, rng):
    """with the hinge forces and the weights each bar obeys Newton's law."""
    hint = "At rest the ceiling carries both weights, and bar 1 carries bar 2: which rows, which signs?"
    compare(student.on_the_fly, cases.states(rng), only=1, hint=hint)


@check("on_the_fly", points=0.25, after=free_bars_accelerate_as_lagranges)
def free_bars_with_a_nearly_massless_one(student, rng):
    """on_the_fly keeps its digits with a bar of 1e-9 of the other's mass, and straight down."""
    compare(student.on_the_fly, cases.nearly_massless(rng), tolerance=MASSLESS, only=0, hint=SCALED)
    compare(student.on_the_fly, cases.straight_down(rng), only=0)


@check("energy", points=0.75)
def energy_is_kinetic_and_potential(student, rng):
    """kinetic of turning bars, potential of their mass centres, zero at the ceiling."""
    compare(student.energy, cases.states(rng), hint=of_energy)


@check("angular_momentum", points=0.75)
def angular_momentum_is_about_the_ceiling(student, rng):
    """r x m v and I omega of both bars, about the ceiling hinge."""
    hint = "Each bar has the angular momentum of its mass centre and that about its mass centre"
    compare(student.angular_momentum, cases.states(rng), hint=hint)


@check("simulate", points=0.5)
def simulation_follows_the_equations(student, rng):
    """angles and angular velocities at uneven times, whatever t[0] is."""
    compare_trajectory(student.simulate, reference, cases.motions(rng), tolerance=FOLLOWED, keeps=KEPT_ENERGY)


@check("simulate", points=0.25, after=simulation_follows_the_equations)
def energy_is_conserved_from_horizontal(student, rng):
    """from (pi/2, pi/2) at rest the energy stays for ten seconds."""
    compare_conserved(student.simulate, cases.from_horizontal(rng), KEPT_ENERGY, coarsely=ROUGHLY, partial=SHARES)


@check("simulate", points=0.25, after=simulation_follows_the_equations)
def momentum_is_conserved_without_gravity(student, rng):
    """without gravity energy and angular momentum stay."""
    conserved = KEPT_MOMENTUM, KEPT_ENERGY
    hint = "Without gravity the same equations hold: the bars still act on each other"
    compare_conserved(student.simulate, cases.weightless(rng), *conserved, coarsely=FOLLOWED, hint=hint)


@check("small_oscillation_frequencies", points=0.5)
def small_oscillations_have_two_frequencies(student, rng):
    """of [M]{th}'' + [K]{th} = 0 about hanging straight down."""
    compare(student.small_oscillation_frequencies, cases.thrown(rng, 3), tolerance=FREQUENCY, hint=in_order)


@check("small_oscillation_frequencies", points=0.25, after=small_oscillations_have_two_frequencies)
def frequencies_in_special_cases(student, rng):
    """equal bars, a nearly massless bar, no gravity."""
    compare(student.small_oscillation_frequencies, cases.special(rng), tolerance=FREQUENCY, hint=out_of_order)


@check("wireframe", points=0.5)
def wireframe_shows_the_bars(student, rng):
    """ceiling hinge to elbow, elbow to tip."""
    compare(student.wireframe, cases.states(rng), hint="An angle of zero is down, a positive one to the right")


@once
def tip_path(rng):
    """Return a case, with the paths of the elbow and of the tip."""
    case = cases.tip_path(rng)
    t, *start = case.args
    fine = np.linspace(t[0], t[-1], 4 * len(t) - 3)  # a student's line may have points between the given times
    motion = reference.simulate(fine, *start, **case.kwargs)
    elbows, tips = np.swapaxes([reference.wireframe(row[:2], case.kwargs["lengths"])[:, 1] for row in motion], 0, 1)
    return case, elbows, tips


@check("plot_tip_path", points=0.5, part="d")
def tip_path_is_drawn(student, rng):
    """plot_tip_path draws the tip's path from t[0] to t[-1], at equal scales."""
    case, elbows, tips = tip_path(rng)
    others = {
        "It is the elbow's path": elbows,
        "It is the path of bar 2's mass centre": (elbows + tips) / 2,
        "It is the tip's path as seen from the elbow": tips - elbows,
    }
    picture = student.plot_tip_path.drawn(case)
    (line,) = curves_seen(picture, 1)
    lengths = case.kwargs["lengths"]

    def wrong_source():
        bars = first_wrong(reference, Case(case.args[1], lengths=lengths), student.wireframe)
        return first_wrong(reference, case, student.simulate)() or bars()

    def own_paths():
        judge_axes_of_lengths(picture)
        rows = student.simulate.aside(case)
        yield np.array([reference.wireframe(row[:2], lengths)[1, 1] for row in rows])
        yield np.array([student.wireframe.aside(Case(row[:2], lengths=lengths))[1, 1] for row in rows])

    path_drawn(
        line, tips, tolerance=DRAWN, quantity="the curve", others=others, wrong_source=wrong_source, own_paths=own_paths
    )
    judge_axes_of_lengths(picture)


ASSIGNMENT = Assignment(
    returns={
        "mass_matrix": array(2, 2).described("[M]", "kg m^2", INERTIA),
        "velocity_terms": array(2).described("{f}", "N m", MOMENT),
        "gravity_terms": array(2).described("{g}", "N m", MOMENT),
        "angular_acceleration": array(2).described("alpha", "rad/s^2", RATE2),
        "on_the_fly": group(
            array(2).described("alpha", "rad/s^2", RATE2), array(2, 2).described("a hinge force", "N", FORCE)
        ),
        "energy": number.described("the energy", "J", MOMENT),
        "angular_momentum": number.described("the angular momentum", "kg m^2/s", SPIN),
        "simulate": rows(4, columns=MOTION, rates=RATES),
        "small_oscillation_frequencies": array(2).described("a frequency", "rad/s"),
        "wireframe": array(2, 2, 2).described("an end of a bar", "m"),
        "plot_tip_path": drawing,
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={},
    needs=("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg"),
    states=(4,),
)
