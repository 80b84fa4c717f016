"""Hidden checks of hw04."""

from functools import partial

import numpy as np

from tam570_grader import Assignment, Case, check, expect, expect_that
from tam570_grader.checks.compare import Column, absolute, compare_with, first_wrong
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.expect import FollowsFrom
from tam570_grader.checks.expected import expected_result
from tam570_grader.checks.plots import curves_seen, judge_axes_of_lengths, path_drawn
from tam570_grader.checks.returns import array, drawing, free_body_diagram, group, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_trajectory

from . import cases, reference

POINTWISE = 1e-9  # a few rounding errors make 1e-14
TRAJECTORY = 1e-5  # solve_ivp at rtol 1e-9, atol 1e-9 has an error of 2e-7 at most
ENERGY = 1e-5  # relative; the same solvers lose 1e-7 of it in five periods
COARSELY = 0.05  # of the scale: in five periods, loose tolerances shift the phase; rest has an error of 0.7
# Of the square of the larger axis. Axes sought along a simulated orbit have errors up to 8e-9 (LSODA at rtol 1e-9, atol
# 1e-9); of a circle, by sum and difference sqrt(r^2 + v^2/k^2 +- 2 abs(r x v)/k), up to 5e-8: the root of rounding.
TENSOR = 1e-7
# Of the motion's size, added to each ellipse's. A zero axis has the rounding error of |centre|; a difference of squares
# has that of |centre|^2, 1e-15 of the size's square. TENSOR * NOUGHT^2 accepts both.
NOUGHT = 1e-3
ON_OWN_MOTION = 1e-4  # of the motion's size; a careful integration has a smaller error
RIGHT_ANGLE = 1e-7  # of the square of the size; eigenvectors have errors of rounding over the gap
DRAWN = 1e-3  # of the picture; chords between the 201 points of the path deviate from it by 4e-5

compare = compare_with(reference, tolerance=POINTWISE)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)
compare_energy = compare_with(reference, by=check_conserved, coarsely=COARSELY)


def length(case, _=None):
    """Return the size of the motion, m; 1 for permanent rest at the origin."""
    k = reference.rate_of(**case.kwargs)
    state = case.args[-1] if len(case.args[-1]) == 6 else np.hstack(case.args[-2:])
    return np.linalg.norm(state[:3]) + np.linalg.norm(state[3:]) / k + case.kwargs["gravity"] / k**2 or 1.0


def speed(case, _=None):
    return reference.rate_of(**case.kwargs) * length(case)


def rate_size(case, _):
    return reference.rate_of(**case.kwargs) * np.repeat([length(case), speed(case)], 3)


MOTION = Column("the position", "m", [0, 1, 2], scale=length), Column("the velocity", "m/s", [3, 4, 5], scale=speed)
KEPT = Invariant("the energy", "of its start", reference.energies, None, ENERGY)


@check("free_body_diagram", points=0.5)
def forces_on_the_mass(student, rng):
    """every force on the mass, where it acts and along what."""
    compare_diagrams(student.free_body_diagram, reference, cases.states(rng))


@check("state_derivative", points=1.5)
def derivative_is_velocity_and_force_over_mass(student, rng):
    """the velocity, and the acceleration by the spring and the weight."""
    hint = "Which two forces act on the mass, and which way, when it is below the origin?"
    compare(student.state_derivative, cases.states_at_times(rng), hint=hint)


@check("energy", points=1)
def energy_is_that_of_motion_spring_and_weight(student, rng):
    """kinetic, of the spring, of the weight; zero at rest at the origin."""
    compare(student.energy, cases.states(rng), hint="Three terms: speed, stretch, height.")


def of_closed_form(case, result, expected):
    """Return which columns of a closed form are right."""
    position, velocity = np.abs(result - expected).reshape(-1, 2, 3).max(axis=(0, 2)) <= 1e-6 * np.abs(expected).max()
    if position or velocity:
        return "The position is right: differentiate it." if position else "The velocity is right, the position is not."
    return "About which point does it oscillate, and how fast?"


@check("solution", points=1.25)
def solution_is_the_motion(student, rng):
    """position and velocity in closed form, given those at t = 0."""
    compare(student.solution, cases.with_gravity(rng), hint=of_closed_form)


@check("solution", points=0.5, after=solution_is_the_motion)
def solution_holds_without_gravity_and_from_any_time(student, rng):
    """without gravity too, and at times of which none is zero."""
    late, weightless = "Row i is the state at t[i], the given one that at t = 0.", "Do you divide by gravity?"
    calls = cases.from_any_time(rng)
    compare(student.solution, calls, hint=lambda case, *_: late if case.kwargs["gravity"] else weightless)


@check("simulate", points=0.75)
def simulate_moves_as_it_must(student, rng):
    """the state at few and uneven times, the first of which is not 0."""
    compare_motions(student.simulate, cases.moving(rng), keeps=KEPT)


@check("simulate", points=0.5, after=simulate_moves_as_it_must)
def simulate_does_not_depend_on_the_sampling(student, rng):
    """the same with only two times, periods apart, whatever was asked before."""
    compare_motions(student.simulate, cases.few_times(rng))
    hint = "Neither a fixed step nor a fixed number of steps does for every spring and any times."
    compare_motions(student.simulate, cases.stiff(rng), hint=hint)


@check("simulate", points=0.5, after=simulate_moves_as_it_must)
def energy_stays(student, rng):
    """after five periods the energy has its first value."""
    compare_energy(student.simulate, cases.many_periods(rng), KEPT, partial={1e-3: 0.6, 1e-2: 0.3})


# The ellipse


def where_it_rests(student):
    def hint(case, result, expected):
        if source := own_motion(student, case, *result):
            return source
        candidates = {"It is above the origin.": -1, "Your centre lacks the mass.": 1 / case.kwargs["mass"]}
        near = partial(np.allclose, result[0], rtol=0, atol=POINTWISE * length(case))
        matching = (message for message, share in candidates.items() if near(share * expected[0]))
        return next(matching, "Where do spring and weight balance?")

    return hint


def own_motion(student, case, centre, axes):
    """Return FollowsFrom the student's own wrong motion that has this ellipse; empty if none has."""
    moving = Case(np.linspace(0, 1, 12) * 2 * np.pi / reference.rate_of(**case.kwargs), *case.args, **case.kwargs)
    for function in (student.simulate, student.solution):
        if axes.any(axis=1).all() and first_wrong(reference, moving, function)():
            radii = function.aside(moving)[:, :3] - centre
            shares = radii @ np.linalg.pinv(axes)
            off = np.abs(radii - shares @ axes).max() / length(case), np.abs((shares**2).sum(axis=1) - 1).max()
            if max(off) <= ON_OWN_MOTION:
                return FollowsFrom(function.name)
    return ""


def about(centre, case, rate):
    """Return Fradkin's tensor about a centre."""
    radius, velocity = case.args[0] - centre, case.args[1] / rate
    return np.outer(radius, radius) + np.outer(velocity, velocity)


def own_source(student, case, centre, axes):
    """Return FollowsFrom the student's own wrong centre or motion to which the ellipse belongs; empty if to none."""
    tensor = about(centre, case, reference.rate_of(**case.kwargs))
    is_about_it = np.allclose(axes.T @ axes, tensor, rtol=0, atol=TENSOR * np.trace(tensor))
    return FollowsFrom("orbit") if is_about_it else own_motion(student, case, centre, axes)


@check("orbit", points=0.5, part="c")
def orbit_has_its_centre_at_the_equilibrium(student, rng):
    """the centre is where the mass can rest."""
    compare(student.orbit, cases.orbits(rng), only=0, hint=where_it_rests(student))


def judge_axes(student, calls):
    """Fail unless semi-axes a, b are perpendicular, a is the larger, and a a^T + b b^T is Fradkin's tensor."""
    for case, (centre, (a, b)) in student.orbit.each(calls):
        (_, tensor), product = reference.orbit(*case.args, **case.kwargs), np.outer(a, a) + np.outer(b, b)
        square = np.trace(tensor) + (NOUGHT * length(case)) ** 2
        words = {"scale": square, "unit": "of the square of its size"}
        source = partial(own_source, student, case, centre, np.array([a, b]))
        which = partial(likeliest_ellipse, source, case, product, tensor, b, square)
        expect(product, tensor, tolerance=TENSOR, quantity="the ellipse", hint=which, **words)
        hint = "Two radii that give the ellipse need not be its axes."
        expect(a @ b, 0.0, tolerance=RIGHT_ANGLE, quantity="the product of the axes", hint=hint, **words)
        expect_that(a @ a >= b @ b - RIGHT_ANGLE * square, "the larger axis is not the first")


def likeliest_ellipse(source, case, product, tensor, smaller, square):
    rate = reference.rate_of(**case.kwargs)
    candidates = {
        "The smaller axis is not zero.": tensor if smaller.any() or np.linalg.matrix_rank(tensor) < 2 else product,
        "It is twice as large: these are its axes, not semi-axes.": 4 * tensor,
        "The semi-axes have the squares of their lengths.": tensor @ tensor,
        "The semi-axes are unit vectors: give them their lengths.": product @ product if product.any() else tensor,
        "You use v itself: divide it by sqrt(k/m).": about(reference.centre(**case.kwargs), case, 1.0),
        "You multiply v by sqrt(k/m): divide it.": about(reference.centre(**case.kwargs), case, 1 / rate),
    }
    near = (message for message, it in candidates.items() if np.allclose(product, it, rtol=1e-6, atol=TENSOR * square))
    return source() or next(near, case.hint or "Do r and v/sqrt(k/m) lie on your ellipse, as seen from its centre?")


@check("orbit", points=1, part="c")
def orbit_is_the_ellipse_of_the_motion(student, rng):
    """the semi-axes, perpendicular, the larger first."""
    judge_axes(student, cases.orbits(rng))


@check("orbit", points=0.5, part="c", after=orbit_is_the_ellipse_of_the_motion)
def orbit_may_be_a_line_or_a_point(student, rng):
    """an ellipse with one axis or both zero."""
    judge_axes(student, cases.flat(rng))


# The picture


@check("project", points=1)
def projection_is_orthographic(student, rng):
    """what an eye far away sees, right and up."""
    compare(student.project, cases.views(rng), hint="Try one axis at a time: which way does each point?")


@check("plot_projection", points=0.5, after=projection_is_orthographic)
def the_path_is_drawn(student, rng):
    """plot_projection draws the projected path from t[0] to t[-1], with labels and equal scales."""
    case = cases.drawn(rng)
    t, r, v, *view = case.args
    places = expected_result(reference.simulate, Case(t, r, v, **case.kwargs))[:, :3]
    picture = student.plot_projection.drawn(case)
    (line,) = curves_seen(picture, 1)
    others = {
        "These are x and y, not right and up.": places[:, :2],
        "You exchanged azimuth and elevation.": reference.project(places, *view[::-1]),
    }
    wrong_motion = first_wrong(reference, case, student.simulate, student.solution)
    wrong_picture = first_wrong(reference, Case(places, *view), student.project)
    path = reference.project(places, *view)

    def own_paths():
        judge_axes_of_lengths(picture, "right horizontal", "up vertical")
        for function in (student.simulate, student.solution):
            yield student.project.aside(Case(function.aside(Case(t, r, v, **case.kwargs))[:, :3], *view))

    path_drawn(
        line,
        path,
        tolerance=DRAWN,
        quantity="the curve",
        others=others,
        wrong_source=lambda: wrong_motion() or wrong_picture(),
        own_paths=own_paths,
    )
    judge_axes_of_lengths(picture, "right horizontal", "up vertical")


ASSIGNMENT = Assignment(
    returns={
        "state_derivative": array(6).described("a rate", "of its size", rate_size),
        "simulate": rows(6, columns=MOTION, rates=OwnRates("state_derivative", reference)),
        "solution": rows(6, columns=MOTION),
        "energy": number.described("the energy", "J", lambda case, _: case.kwargs["stiffness"] * length(case) ** 2),
        "orbit": group(array(3).described("the centre", "m", length), array(2, 3)),
        "project": array("n", 2).described("a point of the picture", "m", absolute),
        "plot_projection": drawing,
        "free_body_diagram": free_body_diagram(3),
    },
    forbidden={"*": ("tam570.lectures",)},
    needs=("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg"),
    states=(6,),
)
