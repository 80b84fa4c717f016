"""Hidden checks of hw10."""

from dataclasses import replace

import numpy as np

from tam570_grader import Assignment, Case, check
from tam570_grader.checks.compare import Column, absolute, check_domain, compare_with, first_wrong, if_nearly
from tam570_grader.checks.expected import expected_result
from tam570_grader.checks.plots import (
    along,
    curves_seen,
    exchanged,
    follows_path,
    judge_axes_of_lengths,
    judge_boxes,
    path_drawn,
)
from tam570_grader.checks.returns import array, drawing, group, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, compare_invariants, compare_trajectory

from . import cases, reference

POINTWISE = 1e-8  # a few rounding errors make 1e-15; a derivative by central differences, 1e-9
SINGULAR = 1e-2  # a pseudoinverse at a singular value of 1e-12 makes 1e-4; a sine kept from zero, 0.3
# solve_ivp at rtol 1e-9, atol 1e-9 has an error of 6e-8 at most (LSODA), an explicit method of order 2 at a thousand
# steps a radian of 1e-6, and solve_ivp at its default tolerances of 2e-5.
TRAJECTORY = 3e-6
# The same solvers lose 7e-8 of R^T R = I in 45 radians; with order 2 the energy may oscillate by 1e-6.
INVARIANT = 1e-5
PERIOD = 1e-6  # a period measured in a simulation has an error of 1e-8
# 1 - k^2 is 1e-9 there: as a difference it has 7 digits; events of solve_ivp at 1e-9 have errors of 4e-6 (LSODA)
NEAR_PERIOD = 1e-4
# Of the radius: chords of 401 points, over less than a turn, deviate from the path by (6/400)^2/8 = 3e-5, and those of
# 26, every sixteenth, by (6/25)^2/8 = 7e-3.
DRAWN, COARSELY = 1e-3, 1e-2

compare = compare_with(reference, tolerance=POINTWISE)


def last_length(case, _):
    """Return |omega|, the last argument."""
    return np.linalg.norm(case.args[-1])


# Pointwise


@check("euler_equations", points=0.75)
def euler_equations_keep_the_angular_momentum(student, rng):
    """omega' of a body without moments, for any three inertias, equal ones too."""
    compare(student.euler_equations, cases.turning(rng), hint="In body components H changes by -omega x H.")


@check("attitude_rate", points=0.5)
def attitude_follows_omega(student, rng):
    """dR/dt for omega in body components."""
    compare(student.attitude_rate, cases.turning_in_space(rng), hint="The columns of R move at omega x themselves.")


@check("energy", points=0.5)
def energy_is_half_omega_h(student, rng):
    """half of omega . H."""
    compare(student.energy, cases.turning(rng))


@check("angular_momentum", points=0.5)
def angular_momentum_is_in_space_axes(student, rng):
    """the vector H in space components."""
    compare(student.angular_momentum, cases.turning_in_space(rng))


@check("euler_rates_313", points=0.75)
def euler_rates_make_omega(student, rng):
    """the rates of psi, theta, phi that make this omega, for theta of any sign."""
    positive = "It is right where the sine of theta is positive."
    turns = "omega is psi' along space z, theta' along the line of nodes, and phi' along body z."
    calls = cases.euler_angles(rng)
    compare(student.euler_rates_313, calls, hint=lambda case, *_: positive if np.sin(case.args[0][1]) < 0 else turns)


@check("euler_rates_313", points=0.25, after=euler_rates_make_omega, refusals=True)
def euler_rates_are_refused_where_undetermined(student, rng):
    """euler_rates_313 raises ValueError where abs(sin theta) < 1e-12, and nowhere else."""
    hint = "sin theta may be negative."
    check_domain(student.euler_rates_313, reference, cases.undetermined(rng), tolerance=SINGULAR, allowed=4, hint=hint)


# Motions

OMEGA = Column("omega", "rad/s", range(3), scale=last_length)
ATTITUDE = Column("R", "", range(3, 12), scale=absolute)
BOTH = OMEGA, ATTITUDE
SHORT = "The steps must be short for a fast turn, and must not depend on the sampling."


def restart(row):
    """Return R and omega of a row."""
    return row[3:].reshape(3, 3), row[:3]


def rotations_of(states):
    return states[:, 3:].reshape(-1, 3, 3)


ATTITUDE_RATES = OwnRates("attitude_rate", reference, lambda t, row: restart(row))
RATES = OwnRates("euler_equations", reference, lambda t, row: (row[:3],), ATTITUDE_RATES)


def wrong_attitude(motion):
    """Return a hint for the rotations."""
    omega, expected = motion.actual[:, :3], motion.expected[:, :3]
    turning = np.allclose(omega, expected, rtol=0, atol=1e-3 * np.abs(expected).max())
    return of_rotations(motion) or (ATTITUDE_RATES.hint(motion) if turning else "")


def of_rotations(motion):
    """Return what is wrong with the rotations; empty if they do not show it."""
    rotations, expected = rotations_of(motion.actual), rotations_of(motion.expected)
    transposes = rotations.transpose(0, 2, 1)
    flaws = {
        SHORT: motion.case.label == cases.FAST_AND_FAR,
        "The three axes are left-handed: the determinant is -1.": np.linalg.det(rotations).min() < 0,
        "These are the transposes, from space to body.": np.abs(transposes - expected).max() < 1e-3,
        "R is not kept orthogonal: R^T R is no longer I.": np.abs(transposes @ rotations - np.eye(3)).max() > 1e-4,
    }
    return next((message for message, holds in flaws.items() if holds), "")


def squares(states, inertia):
    """Return R^T R of each row."""
    return rotations_of(states).transpose(0, 2, 1) @ rotations_of(states)


def momenta(states, inertia):
    return np.einsum("nij,nj->ni", rotations_of(states), inertia * states[:, :3])


def energies(states, inertia):
    return 0.5 * states[:, :3] ** 2 @ inertia


ROTATES = Invariant("R^T R", "", squares, absolute, INVARIANT)
KEEPS_MOMENTUM = Invariant("H in space", "of its start", momenta, None, INVARIANT)
KEEPS_ENERGY = Invariant("the energy", "of its start", energies, None, INVARIANT)
SHARES = {1e-4: 0.5, 1e-2: 0.25}  # {drift: share of the points}
compare_motions = compare_with(reference.motion, by=compare_trajectory, tolerance=TRAJECTORY, restart=restart)


@check("simulate", points=0.75)
def omega_follows_elliptic_functions(student, rng):
    """omega against Jacobi's elliptic functions, on both sides of the separatrix."""
    tumbles = cases.tumbles(rng)
    compare_trajectory(
        student.simulate, reference.tumble, tumbles, columns=[OMEGA], tolerance=TRAJECTORY, restart=restart
    )


@check("simulate", points=0.75)
def attitude_follows_the_motion(student, rng):
    """the rotations along a general motion, from any attitude at the start."""
    compare_motions(student.simulate, cases.general_motions(rng), columns=[ATTITUDE], hint=wrong_attitude)


FOLLOWS = omega_follows_elliptic_functions, attitude_follows_the_motion


@check("simulate", points=0.5, after=FOLLOWS)
def invariants_stay_over_many_turns(student, rng):
    """R^T R = I, H in space and the energy over many fast turns."""
    turns = {"tolerance": 3e-2, "hint": SHORT, "near_miss_credit": False}
    motions = compare_motions(student.simulate, cases.many_turns(rng), **turns)
    conserved = ROTATES, KEEPS_MOMENTUM, KEEPS_ENERGY
    compare_invariants(student.simulate, motions, *conserved, partial=SHARES, hint=SHORT)


@check("simulate", points=0.5, after=FOLLOWS)
def special_bodies_move_too(student, rng):
    """equal inertias, rest, pure spin, two times, starts at half turns."""
    compare_motions(student.simulate, cases.special_motions(rng), hint=wrong_attitude)


# (a) A = B


@check("symmetric_solution", points=0.75)
def symmetric_bodies_precess(student, rng):
    """omega in body components at all times, from omega at t[0]."""
    hint = "Put it into euler_equations: which of the three is not obeyed?"
    compare(student.symmetric_solution, cases.precessing(rng), hint=hint)


@check("wobble_rate", points=0.5)
def wobble_goes_round_the_angular_momentum(student, rng):
    """the rate at which the symmetry axis goes round H, at any angle between them."""
    compare(student.wobble_rate, cases.wobbling(rng), hint="Split omega along H and along the symmetry axis.")


# (b) Stability and tumbling


@check("growth_rate_squared", points=0.75, part="b")
def small_deviations_grow_at_this_rate(student, rng):
    """positive where the spin is unstable, else minus the frequency squared."""
    hint = "Write Euler's equations for a small deviation: which products are of first order?"
    compare(student.growth_rate_squared, cases.spins(rng), hint=hint)


BACK = if_nearly(
    "how accurate is your quadrature, or your time of return?", "After what time is omega back, sign and all?"
)


@check("tumble_period", points=0.375, part="b")
def period_round_the_last_axis(student, rng):
    """tumble_period for omega round the axis of the largest inertia."""
    calls = cases.on_side(rng, label="omega round the axis of the largest inertia", sign=1)
    compare(student.tumble_period, calls, tolerance=PERIOD, hint=BACK)


@check("tumble_period", points=0.375, part="b")
def period_round_the_first_axis(student, rng):
    """tumble_period for omega round the axis of the smallest inertia."""
    calls = cases.on_side(rng, label="omega round the axis of the smallest inertia", sign=-1)
    compare(student.tumble_period, calls, tolerance=PERIOD, hint=BACK)


PERIODS = period_round_the_last_axis, period_round_the_first_axis


@check("tumble_period", points=0.25, part="b", after=PERIODS)
def period_of_pure_spin_is_that_of_small_oscillations(student, rng):
    """tumble_period for pure spin about axis 0 or 2, by small oscillations."""
    compare(student.tumble_period, cases.pure_spins(rng), tolerance=PERIOD, hint="There the modulus k is 0.")


@check("tumble_period", points=0.25, part="b", after=PERIODS)
def period_grows_to_infinity_at_the_separatrix(student, rng):
    """tumble_period near the separatrix, and math.inf on it."""
    hint = "How near 1 is a modulus k that is not 1?"
    compare(student.tumble_period, cases.near_separatrix(rng), tolerance=NEAR_PERIOD, hint=hint)
    compare(student.tumble_period, cases.on_separatrix(rng), tolerance=PERIOD, hint="What is K(k) for k = 1?")


# Drawing

AXES = "y horizontal", "z height vertical"


@check("wireframe", points=0.5, part="b")
def the_box_has_its_twelve_edges(student, rng):
    """the edges of the turned box, in any order and direction."""
    judge_boxes(student.wireframe, cases.boxes(rng), tolerance=POINTWISE)


def seen_along_x(rotations):
    """Return y and z of the body's axes 0 and 1 in space: two paths (n, 2)."""
    return rotations[:, 1:, 0], rotations[:, 1:, 1]


def mistaken(rotations):
    """Return {message: the two paths that this mistake draws, over the radius}."""
    paths, turned = seen_along_x(rotations), rotations.transpose(0, 2, 1)
    return {
        "This is the path of the opposite point: it runs on the same circle": [-path for path in paths],
        "The paths are seen along z": [rotations[:, :2, axis] for axis in (0, 1)],
        "The paths are seen along y": [rotations[:, ::2, axis] for axis in (0, 1)],
        "These are the paths by the transposes of R": seen_along_x(turned),
        "The paths start with the identity, not with the given R": seen_along_x(rotations[0].T @ rotations),
        "The label of y stands at the axis of z": [path[:, ::-1] for path in paths],
    }


@check("plot_rim_paths", points=0.5)
def rim_paths_are_drawn(student, rng):
    """both paths as seen along x, from t[0] to t[-1], with labels and equal scales."""
    case = cases.pictured(rng)
    picture, (t, R, omega), radius = student.plot_rim_paths.drawn(case), case.args, case.kwargs["radius"]
    densely = Case(np.linspace(t[0], t[-1], 801), R, omega, inertia=case.kwargs["inertia"])
    _, rotations = expected_result(reference.motion, densely)
    paths = [radius * path for path in seen_along_x(rotations)]
    wrong_source = first_wrong(reference.motion, case, student.simulate)
    others = {message: [radius * path for path in both] for message, both in mistaken(rotations).items()}
    others["These are the paths for a radius of 1 m"] = seen_along_x(rotations)
    from_behind = all(exchanged(picture, *AXES))  # seen from there: z to the right and y up
    curves = [replace(line, points=line.points[:, ::-1]) if from_behind else line for line in curves_seen(picture, 2)]

    def own_paths():
        judge_axes_of_lengths(picture, *AXES, from_below=True)
        student_paths = [radius * path for path in seen_along_x(student.simulate.aside(densely)[1])]
        pairs = zip(in_order(curves, student_paths[0]), student_paths, strict=True)
        return student_paths if all(follows_path(line, [path], DRAWN) for line, path in pairs) else []

    for line, path in zip(in_order(curves, paths[0]), paths, strict=True):
        path_drawn(
            line,
            path,
            tolerance=DRAWN * radius / np.ptp(path, axis=0).max(),
            fewer=COARSELY / DRAWN,
            quantity="a path",
            others=others,
            wrong_source=wrong_source,
            own_paths=own_paths,
            near_miss_credit=False,
        )
    judge_axes_of_lengths(picture, *AXES, from_below=True)


def in_order(lines, path):
    """Return the lines, first the one whose ends are nearer to those of the path."""
    return sorted(lines, key=lambda line: np.abs(along(line, path)[[0, -1]] - path[[0, -1]]).max())


ASSIGNMENT = Assignment(
    returns={
        "euler_equations": array(3).described("omega'", "rad/s^2", lambda case, _: np.sum(case.args[0] ** 2)),
        "attitude_rate": array(3, 3).described("dR/dt", "rad/s", last_length),
        "euler_rates_313": array(3).described("a rate", "rad/s"),
        "energy": number.described("the energy", "J"),
        "angular_momentum": array(3).described("H", "kg m^2/s"),
        "simulate": group(rows(3), rows(3, 3), columns=BOTH, rates=RATES),
        "symmetric_solution": rows(3).described("omega", "rad/s", last_length),
        "wobble_rate": number.described("the rate", "rad/s"),
        "growth_rate_squared": number.described("the square of the rate", "1/s^2", lambda case, _: case.args[1] ** 2),
        "tumble_period": array(infinite=True).described("the period", "s"),
        "wireframe": array(12, 2, 3),
        "plot_rim_paths": drawing,
    },
    forbidden={"*": ("tam570.lectures",), "euler_rates_313": ("tam570.rotations", "scipy.spatial.transform")},
    needs=("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg"),
    states=(7,),
)
