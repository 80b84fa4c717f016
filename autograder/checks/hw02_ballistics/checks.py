"""Hidden checks of hw02."""

import math
from functools import partial

import numpy as np

from tam570_grader import Assignment, Case, Failed, check, expect_that
from tam570_grader.checks.compare import Column, absolute, compare_with, first_wrong, is_right
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.expect import FollowsFrom
from tam570_grader.checks.plots import curves_seen, follows_path, judge_axes_of_lengths, path_drawn
from tam570_grader.checks.returns import array, drawing, free_body_diagram, number, rows
from tam570_grader.checks.trajectory import OwnRates, compare_trajectory

from . import cases, reference

FORMULA = 1e-12  # a few rounding errors of the accelerations make 1e-15
SIMULATED = 1e-6  # RK45, DOP853, LSODA at rtol 1e-9, atol 1e-9 have an error of 1.3e-9 of the size, RK4 of 1e-8
CLOSED = 1e-10  # errors are 1e-15 with expm1; 1e-11 with a Taylor series where five digits would be lost
ROOT = 1e-6  # of the time; roots by brentq or Newton have errors of 1e-9, an event of a simulation 1e-7
ANGLE = 1e-6  # rad, as the contract demands; minimising the range has errors of 1e-8, or 1.6e-6 at usual tolerances
SEARCHED = {1e-4: 0.5}  # {error, rad: share of the points}, for a search that stops early
NEAR = 1e-3  # relative change of an angle
EARLY = 4e-6  # rad: searches at usual tolerances have smaller errors, a series of first order in the drag larger ones
SWIFT = 1e-2  # of the angle, as the contract demands
CORNER = 1e-9  # the right path, at a speed of 1e12 terminal speeds, is 5e-11 from its limit
# Of the path's size. Chords between FINE points of the motion deviate from its path by g (T/1000)^2/8: 2e-5 of its size
# at a hundred times the terminal speed, where T = 1.2 v/g is longest for it; the points of a simulation by 1e-7.
DRAWN, FINE = 1e-4, 1001
FEWER = 200  # times DRAWN; chords of a line of ten points deviate from a parabola by (2.4/9)^2/4 = 1.8e-2

compare = compare_with(reference, tolerance=ROOT)
compare_rows = compare_with(reference, tolerance=CLOSED)


def of_rates(case, _):
    """Return the scale of the rates, from v, c v/m and g."""
    speed, parameters = np.linalg.norm(case.args[1][2:]), case.kwargs
    return speed * (1 + parameters["drag"] / parameters["mass"]) + parameters["gravity"]


def largest_of(columns, case, states):
    """Return the largest size of columns, also on the way: with only two times, a particle may be near its launch."""
    t, *start = case.args
    way = reference.trajectory(np.linspace(0.0, np.ptp(t), 9), *start, **case.kwargs)
    return np.abs(np.vstack([states, way]))[:, columns].max()


def of_range(case, distance):
    """Return the range; straight up, where it is zero up to rounding, the speed times the flight time."""
    speed, angle = case.args
    return speed * reference.flight_time(speed, angle, **case.kwargs) if angle == math.pi / 2 else distance


PLACE, VELOCITY = partial(largest_of, [0, 1]), partial(largest_of, [2, 3])
COLUMNS = ("x", "m", PLACE), ("y", "m", PLACE), ("vx", "m/s", VELOCITY), ("vy", "m/s", VELOCITY)
MOTION = [Column(quantity, unit, [index], scale=scale) for index, (quantity, unit, scale) in enumerate(COLUMNS)]


@check("free_body_diagram", points=0.5)
def forces_on_the_particle(student, rng):
    """every force on the particle, where it acts and along what."""
    compare_diagrams(student.free_body_diagram, reference, cases.without_time(rng))


@check("state_derivative", points=0.75)
def rates_are_newtons(student, rng):
    """state_derivative is the velocity and (weight + drag)/mass, for velocities in any direction."""
    hint = "Draw the two forces on the particle: which way does each point when it falls?"
    compare(student.state_derivative, cases.states(rng), tolerance=FORMULA, hint=hint)


@check("state_derivative", points=0.25, after=rates_are_newtons)
def rates_without_drag_or_gravity(student, rng):
    """state_derivative holds where drag or gravity, or both, are zero."""
    hint = "Do you divide by drag or gravity?"
    compare(student.state_derivative, cases.states_without(rng), tolerance=FORMULA, hint=hint)


def of_ground(motion):
    ends = motion.actual[:, 1].min() >= -1e-6 > motion.expected[:, 1].min()
    return "There is no ground: the path goes on below y = 0." if ends else ""


def launch(row):
    """Return speed and angle of a row, which launch a flight from the origin with the same increments."""
    return float(np.hypot(*row[2:])), math.atan2(row[3], row[2])


compare_flights = compare_with(reference, by=compare_trajectory, tolerance=SIMULATED, hint=of_ground, restart=launch)


@check("simulate", points=0.75, part="d")
def simulation_follows_the_motion(student, rng):
    """simulate gives the states at uneven times, launched at t[0], whatever t[0] is."""
    compare_flights(student.simulate, cases.flights(rng))


@check("simulate", points=0.5, part="d", after=simulation_follows_the_motion)
def simulation_without_drag_or_gravity(student, rng):
    """simulate goes straight without gravity, a parabola without drag, whatever was asked before."""
    compare_flights(student.simulate, cases.flights_without(rng))


def of_closed_form(case, result, expected):
    """Return which columns of a closed form are right."""
    scale = case.args[1] + case.kwargs["gravity"] * np.ptp(case.args[0])
    x, y, vx, vy = np.abs(result - expected).max(axis=0) <= 1e-6 * scale * max(1.0, np.ptp(case.args[0]))
    if vx and vy:
        return "The velocities are right: integrate them from the origin."
    if x and y:
        return "The path is right: differentiate it."
    if vx or vy:
        return f"Of the velocities, {'vx' if vx else 'vy'} alone is right."
    return "The equations of vx and vy are linear, of first order and apart; then x and y."


@check("trajectory", points=0.75, part="c")
def trajectory_is_the_motion(student, rng):
    """trajectory gives the states in closed form."""
    compare_rows(student.trajectory, cases.flights_from_zero(rng), hint=of_closed_form)


@check("trajectory", points=0.25, part="c", after=trajectory_is_the_motion)
def trajectory_counts_time_from_the_launch(student, rng):
    """trajectory is launched at t = 0, at whatever times: later ones, a single one, backwards."""
    hint = "The launch is at t = 0, and row i is the state at t[i]."
    compare_rows(student.trajectory, cases.late_flights(rng), hint=hint)


@check("trajectory", points=0.75, part="c", after=trajectory_is_the_motion)
def trajectory_with_any_drag(student, rng):
    """trajectory keeps its digits at drag 1e-12, at none, and long after e^(-c t/m) is nothing."""
    hint = "1 - e^-s is a difference of nearly equal numbers (see numpy.expm1); so is y."
    compare_rows(student.trajectory, cases.flights_with_any_drag(rng), hint=hint)


def of_landing(case, time, expected):
    if time <= ROOT * expected:
        return "y is zero at the launch, too; the landing is the later zero."
    ((_, y, _, vy),) = reference.trajectory(np.array([time]), *case.args, **case.kwargs)
    if abs(vy) <= ROOT * case.kwargs["gravity"] * time:
        return "That is the time to the top, where vy is zero; the landing is later."
    return f"At your time y is {y:.2g} m, not 0: put it into your closed form."


@check("flight_time", points=0.75, part="c")
def flight_ends_at_launch_height(student, rng):
    """flight_time is when y is zero again."""
    compare(student.flight_time, cases.landings(rng), hint=of_landing)


def of_little_drag(name, case, result, expected):
    """Return whether a result for little drag is that for none, or has lost digits."""
    without = getattr(reference, name)(*case.args, **{**case.kwargs, "drag": 0.0})
    if case.kwargs["drag"] and abs(result - without) <= 1e-12 * without:
        return "Very little drag is not none."
    if abs(result - expected) <= 1e-2 * expected:
        return "It is nearly right: are digits lost in a difference, or does a term of the next order miss?"
    return f"For no drag it is {without:.3g}: which term of your equation goes wrong as the drag goes to zero?"


@check("flight_time", points=0.5, part="c", after=flight_ends_at_launch_height)
def flight_time_with_hardly_any_drag(student, rng):
    """flight_time goes over into 2 v sin(angle)/g without losing its digits."""
    compare(student.flight_time, cases.landings_of_little_drag(rng), hint=partial(of_little_drag, "flight_time"))


@check("flight_time", points=0.25, part="c", after=flight_ends_at_launch_height)
def flight_time_with_great_drag_and_straight_up(student, rng):
    """flight_time holds straight up, nearly flat, at drag a thousand times the weight."""
    hint = "Does a search for the root step over a flight that is short, or end at t = 0?"
    compare(student.flight_time, [*cases.flat_landings(rng), *cases.landings_of_great_drag(rng)], hint=hint)


@check("horizontal_range", points=0.5, part="c")
def range_is_where_it_lands(student, rng):
    """horizontal_range is x at the flight time."""
    compare(student.horizontal_range, cases.landings(rng), hint="Put the flight time into the x of your closed form.")


@check("horizontal_range", points=0.5, part="c", after=range_is_where_it_lands)
def range_with_hardly_any_drag(student, rng):
    """horizontal_range becomes v^2 sin(2 angle)/g, no digits lost; it holds with great drag, too."""
    calls = [*cases.landings_of_little_drag(rng), *cases.landings_of_great_drag(rng)]
    compare(student.horizontal_range, calls, hint=partial(of_little_drag, "horizontal_range"))


def of_maximum(student, case, angle, expected):
    """Return FollowsFrom if the student's own range is wrong, and largest at this angle; else a hint."""
    own_ranges = [
        student.horizontal_range.aside(Case(*case.args, angle * (1 + change), **case.kwargs))
        for change in (0, -NEAR, NEAR)
    ]
    flight = Case(*case.args, angle, **case.kwargs)
    if own_ranges[0] > max(own_ranges[1:]) and not is_right(student.horizontal_range, reference, [flight]):
        return FollowsFrom("horizontal_range")
    if case.label == cases.SLOW and abs(angle - expected) > EARLY:
        return "45 degrees are for no drag: the angle falls in proportion to the drag, then by its next term."
    if abs(angle - expected) <= max(SEARCHED):
        return "Near its largest the range is flat, and a search stops early: set its derivative to zero."
    best, yours = (reference.horizontal_range(case.args[0], at, **case.kwargs) for at in (expected, angle))
    return f"At your angle the range is {100 * (1 - yours / best):.2g}% below the largest."


def compare_angles(student, speeds):
    hint = partial(of_maximum, student)
    compare(student.best_angle, speeds, tolerance=ANGLE, partial=SEARCHED, hint=hint)


@check("best_angle", points=0.75)
def best_angle_has_the_largest_range(student, rng):
    """best_angle maximises the range, for speeds below and above the terminal speed."""
    compare_angles(student, cases.usual_speeds(rng))


@check("best_angle", points=0.25, after=best_angle_has_the_largest_range)
def best_angle_is_45_degrees_without_drag(student, rng):
    """best_angle is 45 degrees at no drag, and leaves them as the drag grows beside the weight."""
    compare_angles(student, cases.slow_speeds(rng))


@check("best_angle", points=0.5, after=best_angle_has_the_largest_range)
def best_angle_at_a_huge_speed(student, rng):
    """best_angle goes to zero as the speed grows, and stays good to 1 % of itself."""
    hint = "The largest range is very flat there: solve for where its derivative vanishes, on a logarithmic scale."
    compare(student.best_angle, cases.huge_speeds(rng), tolerance=SWIFT, scale=lambda _, angle: angle, hint=hint)


@check("limit_shape", points=1, part="b")
def path_at_a_huge_speed_has_the_limit_shape(student, rng):
    """limit_shape has the corners that a path has at a speed of 1e12 terminal speeds."""
    hint = "Plot your closed form at 10, 100 and 1000 times the terminal speed; launch and landing are corners, too."
    compare(student.limit_shape, cases.angles(rng), tolerance=CORNER, hint=hint)


@check("plot_comparison", points=0.5, part="e")
def both_paths_are_drawn(student, rng):
    """plot_comparison draws both paths from t[0] to t[-1] on the same axes, at the same scale."""
    case = cases.picture(rng)
    t, *start = case.args
    times = np.linspace(0.0, t[-1], FINE)
    path = reference.trajectory(times, *start, **case.kwargs)[:, :2]
    others = {
        "A path is y over x, not over the time.": np.array([[0.0, 0.0], [t[-1], path[-1, 1]]]),
        "x and y are swapped: x is to the right, y up.": path[:, ::-1],
    }
    picture = student.plot_comparison.drawn(case)
    wrong_source = first_wrong(reference, case, student.simulate, student.trajectory)

    def own_paths():
        judge_axes_of_lengths(picture)
        judge_twins(student, case, picture.lines)
        paths = [function.aside(case.replace(times))[:, :2] for function in (student.simulate, student.trajectory)]
        return paths if all(follows_path(line, paths, DRAWN, FEWER) for line in picture.lines) else []

    def of_small():
        return FollowsFrom(wrong_source()) if len(picture.lines) == 2 and own_paths() else ""

    curves = curves_seen(picture, 2, of_small)
    for line in curves:
        path_drawn(
            line,
            path,
            tolerance=DRAWN,
            fewer=FEWER,
            quantity="a curve",
            others=others,
            wrong_source=wrong_source,
            own_paths=own_paths,
            near_miss_credit=False,
        )
    judge_axes_of_lengths(picture)
    judge_twins(student, case, curves)


def judge_twins(student, case, curves):
    """Fail if both curves show one function: moving its results moves both curves, moving the other's moves none.

    Fail as well if they are the same numbers, to the last bit, unless simulate and trajectory agree so.
    """
    hint = "Does one curve show simulate, and the other trajectory?"
    try:
        moved, same = moves(student, case, curves, "simulate"), np.array_equal(*(line.points for line in curves))
        twice = moved != 1 and {moved, moves(student, case, curves, "trajectory")} == {0, 2}
        identical = same and np.array_equal(student.simulate.aside(case), student.trajectory.aside(case))
    except Failed:  # their own checks report it
        return
    expect_that(not twice, "Both curves are of one function", hint=hint)
    expect_that(identical or not same, "Both curves are the same numbers, to the last bit", hint=hint)


def moves(student, case, curves, name):
    """Return how many of the two curves, which are one path, move by a metre if the results of this function do."""
    after = student.plot_comparison.drawn(case, moved=name).lines
    return 2 - sum(any(near(line.points, other.points) for line in curves) for other in after)


def near(points, other):
    """Return whether two curves have as many points, half a metre apart at most."""
    return points.shape == other.shape and np.abs(points - other).max() < 0.5


ASSIGNMENT = Assignment(
    returns={
        "state_derivative": array(4).described("the state's derivative", "m/s or m/s^2", of_rates),
        "simulate": rows(4, columns=MOTION, rates=OwnRates("state_derivative", reference)),
        "trajectory": rows(4, columns=MOTION),
        "flight_time": number.described("the flight time", "s"),
        "horizontal_range": number.described("the range", "m", of_range),
        "best_angle": number.described("the best angle", "rad", absolute),
        "limit_shape": array(3, 2).described("a corner", "of m v/c", absolute),
        "plot_comparison": drawing,
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={"trajectory": ("scipy.integrate", "tam570.integrate")},
    needs=("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg"),
    states=(4,),
)
