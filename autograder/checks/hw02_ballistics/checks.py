"""Hidden checks of hw02."""

import math
from functools import partial

import numpy as np

from tam570_grader import Column, Failed, agree, agree_by_columns, check, expect, expect_that, follow, given, law
from tam570_grader.writing.curves import along
from tam570_grader.writing.drawings import curves_seen, distances, judge_axes_of_lengths
from tam570_grader.writing.returns import array, drawing, number, rows

from . import cases, right

NEEDS = ("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg")
OFF_LIMITS = {"trajectory": ("scipy.integrate", "tam570.integrate")}  # a closed form is asked for
MANUAL = {"b": (2, "the guess before the work; why the limit has the shape it has")}

FORMULA = 1e-12  # a few roundings of the accelerations make 1e-15
SIMULATED = 1e-6  # RK45, DOP853, LSODA at rtol 1e-9, atol 1e-9 are off by 1.3e-9 of the size, RK4 by 1e-8
CLOSED = 1e-10  # 1e-15 with expm1; a Taylor series that takes over where five digits are lost, 1e-11
ROOT = 1e-6  # of the time; roots found by brentq or Newton are good to 1e-9, an event of a simulation to 1e-7
ANGLE = 1e-6  # rad, as the contract asks; minimising the range is good to 1e-8, or with usual tolerances to 1.6e-6
SEARCHED = {1e-4: 0.5}  # rad, of a search that stops early
SWIFT = 1e-2  # of the angle, as the contract asks
CORNER = 1e-9  # the right path, at a speed of 1e12 terminal speeds, is 5e-11 from its limit
# Of the path's size. The chords between FINE points of the motion leave its path by g (T/1000)^2/8: 2e-5 of its size at
# a hundred times the terminal speed, where T = 1.2 v/g is longest for it; the points of a simulation leave it by 1e-7.
DRAWN, FINE = 1e-4, 1001
PASSED = 2e-2  # of the path's size; chords of a line of ten points leave a parabola by (2.4/9)^2/4 = 1.8e-2

SMALL_BESIDE = "Whether drag counts is told by c t/m or c v/(m g), not by c alone."
KEPT = "Is anything kept between calls?"
NO_DIVISION = "Do you divide by drag or gravity?"
GREAT = "e^-s goes to nothing, e^s beyond all numbers."


def of_rates(case, _):
    """v, c v/m and g."""
    speed, known = np.linalg.norm(case.args[1][2:]), case.kwargs
    return speed * (1 + known["drag"] / known["mass"]) + known["gravity"]


def largest(columns, case, states):
    """On the way, too: at two times alone a particle may be next to where it was launched."""
    t, *start = case.args
    way = right.trajectory(np.linspace(0.0, np.ptp(t), 9), *start, **case.kwargs)
    return np.abs(np.vstack([states, way]))[:, columns].max()


def of_range(case, distance):
    """The range; straight up it is zero, but for rounding."""
    speed, angle = case.args
    return speed * right.flight_time(speed, angle, **case.kwargs) if angle == math.pi / 2 else distance


def one(*_):
    return 1.0


of_place, of_velocity = partial(largest, [0, 1]), partial(largest, [2, 3])
MOTION = Column("a place", "m", [0, 1], scale=of_place), Column("a velocity", "m/s", [2, 3], scale=of_velocity)
EACH = (
    *(Column(of, "m", [column], scale=of_place) for column, of in enumerate(("x", "y"))),
    *(Column(of, "m/s", [column], scale=of_velocity) for column, of in enumerate(("vx", "vy"), start=2)),
)
RESULTS = {
    "state_derivative": array(4).called("the state's derivative", "m/s or m/s^2", of_rates),
    "simulate": rows(4, columns=MOTION),
    "trajectory": rows(4, columns=EACH),
    "flight_time": number.called("the flight time", "s"),
    "horizontal_range": number.called("the range", "m", of_range),
    "best_angle": number.called("the best angle", "rad", one),
    "limit_shape": array(3, 2).called("a corner", "m v/c", one),
    "plot_comparison": drawing,
}


@check(points=0.75, part="a")
def rates_are_newtons(student, draw):
    """state_derivative is the velocity and (weight + drag)/mass, for velocities in any direction."""
    hint = "Draw the two forces on the particle: which way does each point when it falls?"
    agree(student.state_derivative, right, cases.states(draw), within=FORMULA, hint=hint)
    agree(student.state_derivative, right, [cases.light_state(draw)], within=FORMULA, hint=SMALL_BESIDE)


rates_without_drag_or_gravity = law(
    "state_derivative holds where drag or gravity, or both, are zero.", points=0.25, part="a", after=rates_are_newtons
).agrees(right.state_derivative, cases.states_without, within=FORMULA, hint=NO_DIVISION)


def judge_motions(function, calls, hint):
    follow(function, right, calls, within=SIMULATED, hint=hint, restart=lambda row: (row, None))


@check(points=1, part="d")
def simulation_follows_the_motion(student, draw):
    """simulate gives the states at uneven times, launched at t[0], whatever t[0] is."""
    hint = "Is your state_derivative right? There is no ground: the path goes on below y = 0."
    judge_motions(student.simulate, cases.flights(draw) + cases.plain_flights(draw, shifted=True), hint)


@check(points=0.5, part="d", after=simulation_follows_the_motion)
def simulation_without_drag_or_gravity(student, draw):
    """simulate goes straight on without gravity, on a parabola without drag, whatever was asked before."""
    judge_motions(student.simulate, cases.flights_without(draw), NO_DIVISION)
    judge_motions(student.simulate, cases.alike_flights(draw), KEPT)


@check(points=1, part="c")
def trajectory_is_the_motion(student, draw):
    """trajectory gives the states in closed form."""
    hint = "The equations of vx and vy are linear, of first order and apart; then x and y."
    agree_by_columns(student.trajectory, right, cases.flights_from_zero(draw), within=CLOSED, hint=hint)
    plain, hint = cases.plain_flights(draw, shifted=False), "Which way does it fly, and is it launched at the origin?"
    agree_by_columns(student.trajectory, right, plain, within=CLOSED, hint=hint)


@check(points=0.25, part="c", after=trajectory_is_the_motion)
def trajectory_counts_time_from_the_launch(student, draw):
    """trajectory takes the launch to be at t = 0, whatever times are asked for: later ones, a single one, backwards."""
    hint = "The launch is at t = 0, and row i is the state at t[i]."
    agree_by_columns(student.trajectory, right, cases.late_flights(draw), within=CLOSED, hint=hint)


@check(points=0.75, part="c", after=trajectory_is_the_motion)
def trajectory_with_any_drag(student, draw):
    """trajectory keeps its digits at drag 1e-12, at no drag at all, and long after e^(-c t/m) is nothing."""
    digits = "1 - e^-s is a difference of nearly equal numbers (see numpy.expm1); so is y."
    for calls, hint in (
        (cases.flights_of_little_drag(draw), digits),
        (cases.flights_of_great_drag(draw), GREAT),
        ([cases.flight(draw, 0.0, cases.light(draw), cases.LIGHT)], SMALL_BESIDE),
        (cases.alike_flights(draw, from_zero=True), KEPT),
    ):
        agree_by_columns(student.trajectory, right, calls, within=CLOSED, hint=hint)


@check(points=0.75, part="c")
def flight_ends_at_launch_height(student, draw):
    """flight_time is when y is zero again."""
    hint = "Put the time into the y of your closed form: is it zero?"
    agree(student.flight_time, right, cases.landings(draw, 12) + cases.plain_landings(draw), within=ROOT, hint=hint)


@check(points=0.5, part="c", after=flight_ends_at_launch_height)
def flight_time_with_hardly_any_drag(student, draw):
    """flight_time goes over into 2 v sin(angle)/g without losing its digits."""
    hint = (
        "Very little drag is not none. Near its branch point Lambert's W has half of its digits only; "
        "a step of Newton's method brings them back."
    )
    agree(student.flight_time, right, cases.landings_of_little_drag(draw), within=ROOT, hint=hint)


@check(points=0.25, part="c", after=flight_ends_at_launch_height)
def flight_time_with_great_drag_and_straight_up(student, draw):
    """flight_time holds straight up and nearly flat, with drag a thousand times the weight, for light particles."""
    for calls, hint in (
        (cases.flat_landings(draw), "Does a search for the root step over a flight that is short, or end at t = 0?"),
        (cases.landings_of_great_drag(draw), "What is left of the equation when e^-s is nothing?"),
        (cases.light_landings(draw), SMALL_BESIDE),
        (cases.alike_landings(draw), KEPT),
    ):
        agree(student.flight_time, right, calls, within=ROOT, hint=hint)


@check(points=0.5, part="c")
def range_is_where_it_lands(student, draw):
    """horizontal_range is x at the flight time."""
    calls = cases.landings(draw, 12) + cases.plain_landings(draw)
    hint = "Put the flight time into the x of your closed form."
    agree(student.horizontal_range, right, calls, within=ROOT, hint=hint)


@check(points=0.5, part="c", after=range_is_where_it_lands)
def range_with_hardly_any_drag(student, draw):
    """horizontal_range goes over into v^2 sin(2 angle)/g without losing its digits; it holds with great drag, too."""
    digits = "Very little drag is not none: is it the time or x that has lost its digits?"
    for calls, hint in (
        (cases.landings_of_little_drag(draw), digits),
        (cases.light_landings(draw), SMALL_BESIDE),
        (cases.landings_of_great_drag(draw), GREAT),
        (cases.alike_landings(draw), KEPT),
    ):
        agree(student.horizontal_range, right, calls, within=ROOT, hint=hint)


@check(points=0.75, part="a")
def best_angle_has_the_largest_range(student, draw):
    """best_angle maximises the range, for speeds below and above the terminal speed."""
    hint = "Near its largest the range is flat, and a search stops early: solve for where its derivative vanishes."
    agree(student.best_angle, right, cases.usual_speeds(draw), within=ANGLE, partial=SEARCHED, hint=hint)


@check(points=0.25, part="a", after=best_angle_has_the_largest_range)
def best_angle_is_45_degrees_without_drag(student, draw):
    """best_angle is 45 degrees at no drag, and leaves them as the drag grows beside the weight."""
    slow = "45 degrees are for no drag: the angle falls in proportion to the drag, and then by its next term."
    for calls, hint in (
        (cases.speeds_without_drag(draw), "Does your equation for the angle still hold when drag is zero?"),
        (cases.slow_speeds(draw), slow),
        (cases.small_speeds(draw), SMALL_BESIDE),
        (cases.alike_speeds(draw), KEPT),
    ):
        agree(student.best_angle, right, calls, within=ANGLE, partial=SEARCHED, hint=hint)


@check(points=0.5, part="a", after=best_angle_has_the_largest_range)
def best_angle_at_a_huge_speed(student, draw):
    """best_angle goes to zero as the speed grows, and stays good to 1 % of itself."""
    hint = "The largest range is very flat there: solve for where its derivative vanishes, on a logarithmic scale."
    # minimising the range on a logarithmic scale is good to 1e-4 of the angle up to 1e6 terminal speeds, not at 1e7
    calls = cases.speeds(draw, 10.0 ** draw.uniform(4, 6, 5), "a huge speed")
    agree(student.best_angle, right, calls, within=SWIFT, scale=lambda _, angle: angle, hint=hint)


@check(points=1, part="b")
def path_at_a_huge_speed_has_the_limit_shape(student, draw):
    """limit_shape has the corners that a path has at a speed of 1e12 terminal speeds."""
    angles = [*draw.uniform(0.1, 1.5, 6), math.pi / 2, math.pi / 4, math.pi / 3, 1.0, 0.01]
    hint = "Plot your closed form at 10, 100 and 1000 times the terminal speed; launch and landing are corners, too."
    agree(student.limit_shape, right, [given(one).on("a random angle") for one in angles], within=CORNER, hint=hint)


@check(points=0.5, part="e")
def both_paths_are_drawn(student, draw):
    """plot_comparison draws both paths from t[0] to t[-1] on the same axes, at the same scale."""
    case = cases.picture(draw)
    picture = student.plot_comparison.drawn(case)
    curves = curves_seen(picture, 2)
    for line in curves:
        judge_path(line, case)
    judge_axes_of_lengths(picture)
    judge_twins(student, case, curves)


def judge_path(line, case):
    """A line must begin and end where the motion does, and each have all of its points next to the other."""
    t, *start = case.args
    fine = right.trajectory(np.linspace(0.0, t[-1], FINE), *start, **case.kwargs)[:, :2]
    path, scale = along(line, fine), np.abs(fine).max()
    ends, near = partial(end_hint, path, fine, t), DRAWN * scale
    known = {"unit": "m", "gradual": False}
    expect(path[[0, -1]], fine[[0, -1]], within=near, of="an end of a curve", hint=ends, **known)
    known["hint"] = "x is to the right, y up."
    expect(distances(path, fine), 0.0, within=near, of="a curve", **known)
    expect(distances(fine[::5], path), 0.0, within=PASSED * scale, of="a point of the motion", **known)


def end_hint(path, fine, t):
    """What to say of a curve with a wrong end."""
    near = DRAWN * np.abs(fine).max()
    told = {
        "A path is y over x, not over the time.": (path[-1], [t[-1], fine[-1, 1]]),
        "x and y are swapped: x is to the right, y up.": (path[[0, -1], ::-1], fine[[0, -1]]),
        "It begins right: do simulate and trajectory pass, and does the curve end at t[-1]?": (path[0], fine[0]),
    }
    says = (says for says, (one, other) in told.items() if np.abs(np.subtract(one, other)).max() <= near)
    return next(says, "Draw from t[0] to t[-1].")


def judge_twins(student, case, curves):
    """Where the one function's results are moved, and both curves are, while the other's move none, one is drawn twice.

    So it is where they are the same numbers, to the last bit, unless simulate and trajectory agree so.
    """
    hint = "Is one that of simulate, and the other that of trajectory?"
    try:
        moved = [moves(student, case, curves, name) for name in ("simulate", "trajectory")]
        same = np.array_equal(*(line.points for line in curves))
        alike = same and np.array_equal(student.simulate.aside(case), student.trajectory.aside(case))
    except Failed:  # of which their own checks tell
        return
    expect_that(set(moved) != {0, 2}, "both curves are of one function", hint=hint)
    expect_that(alike or not same, "both curves are the same numbers, to the last bit", hint=hint)


def moves(student, case, curves, name):
    """How many of the curves move by a metre where the results of this function do."""
    after, moved = [line.points for line in student.plot_comparison.drawn(case, moved=name).lines], 0
    for line in curves:
        stays = [k for k, points in enumerate(after) if near(line.points, points)]
        moved += not stays
        after = [points for k, points in enumerate(after) if k not in stays[:1]]  # each stays for one
    return moved


def near(one, other):
    """Whether two curves have as many points, half a metre apart at most."""
    return one.shape == other.shape and np.abs(one - other).max() < 0.5
