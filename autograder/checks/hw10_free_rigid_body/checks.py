"""Hidden checks of hw10."""

import math
from functools import partial

import numpy as np

from tam570_grader import Column, Invariant, absolute, check, expect, law
from tam570_grader.writing.drawings import curves_seen, exchanged, judge_axes_of_lengths, judge_boxes
from tam570_grader.writing.returns import array, drawing, group, number, rows

from . import cases, right
from .paths import farthest, turned_over, wrong_paths

NEEDS = ("numpy", "matplotlib.figure", "matplotlib.backends.backend_agg")
OFF_LIMITS = {"*": ("tam570.lectures",), "euler_rates_313": ("tam570.rotations", "scipy.spatial.transform")}
MANUAL = {
    "a": (2, "a simple explanation of the two tilted circles"),
    "b": (2, "the prediction for (0, 1, eps), made before looking, and the plot that shows the instability"),
}

POINTWISE = 1e-8  # a few roundings make 1e-15; a derivative by central differences, 1e-9
SINGULAR = 1e-2  # a pseudoinverse where a singular value is 1e-12 makes 1e-4; a sine kept from zero, 0.3
# solve_ivp at rtol 1e-9, atol 1e-9 is off by 6e-8 at the most (LSODA), an explicit method of order 2 at a thousand
# steps a radian by 1e-6; at its own tolerances solve_ivp is off by 2e-5.
TRAJECTORY = 3e-6
# The same solvers lose 7e-8 of R^T R = I in 45 radians; with order 2 the energy may swing by 1e-6.
INVARIANT = 1e-5
PERIOD = 1e-6  # a period measured on a simulation is good to 1e-8
# 1 - k^2 is 1e-9 there: as a difference it has 7 digits; events of solve_ivp at 1e-9 are off by 4e-6 (LSODA)
NEAR_PERIOD = 1e-4

COARSELY = 3e-2  # of |omega|, and of R


def last_length(case, _):
    """|omega|, the last of the arguments."""
    return np.linalg.norm(case.args[-1])


RESULTS = {
    "euler_equations": array(3).called("omega'", "rad/s^2", lambda case, _: np.sum(case.args[0] ** 2)),
    "attitude_rate": array(3, 3).called("dR/dt", "rad/s", last_length),
    "euler_rates_313": array(3).called("a rate", "rad/s"),
    "energy": number.called("the energy", "J"),
    "angular_momentum": array(3).called("H", "kg m^2/s"),
    "simulate": group(rows(3), rows(3, 3)),
    "symmetric_solution": rows(3).called("omega", "rad/s", last_length),
    "wobble_rate": number.called("the rate", "rad/s"),
    "growth_rate_squared": number.called("the square of the rate", "1/s^2", lambda case, _: case.args[1] ** 2),
    "tumble_period": array(infinite=True).called("the period", "s"),
    "wireframe": array(12, 2, 3),
    "plot_rim_paths": drawing,
}

# Pointwise

KEEPS_H = "The rate of H in body components plus omega x H is zero."
AXES_MOVE = "The columns of R are the body's axes in space; each moves at omega x itself."
euler_equations_keep_the_angular_momentum = law(
    "euler_equations: omega' of a body without moments, for any three inertias, equal ones too.", points=0.75, part="a"
).agrees(right.euler_equations, cases.turning, within=POINTWISE, hint=KEEPS_H)
attitude_follows_omega = law("attitude_rate: dR/dt for omega in body components.", points=0.5, part="a").agrees(
    right.attitude_rate, cases.turning_in_space, within=POINTWISE, hint=AXES_MOVE
)
energy_is_half_omega_h = law("energy: half of omega . H.", points=0.5, part="a").agrees(
    right.energy, cases.turning, within=POINTWISE
)
angular_momentum_is_in_space_axes = law(
    "angular_momentum: the vector H in space components.", points=0.5, part="a"
).agrees(right.angular_momentum, cases.turning_in_space, within=POINTWISE)


def wrong_rates(case, found, expected):
    """What is wrong with the rates, if it can be told."""
    (_, theta, _), (psi_rate, theta_rate, phi_rate) = case.args[0], expected
    if math.sin(theta) < 0:
        rooted = [-psi_rate, theta_rate, phi_rate + 2 * psi_rate * math.cos(theta)]
        if np.allclose(found, rooted, rtol=POINTWISE, atol=POINTWISE):
            return "The sine of theta is negative there: do you compute it as a square root?"
    return "omega is psi' along space z, theta' along the line of nodes, and phi' along body z."


euler_rates_make_omega = law(
    "euler_rates_313: the rates of psi, theta, phi that make this omega, for theta of any sign.", points=0.75, part="a"
).agrees(right.euler_rates_313, cases.euler_angles, within=POINTWISE, hint=wrong_rates)
NEARLY = len(cases.NEARLY_UNDETERMINED)
euler_rates_are_refused_where_undetermined = euler_rates_make_omega.then(
    "euler_rates_313 raises ValueError where abs(sin theta) < 1e-12, and nowhere else.", points=0.25, part="a"
).refuses(right.euler_rates_313, cases.undetermined, within=SINGULAR, allowed=NEARLY, hint="sin theta may be negative.")

# Motions

OMEGA = Column("omega", "rad/s", range(3), scale=last_length)
ATTITUDE = Column("R", "", range(3, 12), scale=absolute)
BOTH = OMEGA, ATTITUDE
SHORT = "The steps must be short for a fast turn, and must not depend on the sampling."


def restart(row):
    """R and omega of a row."""
    return row[3:].reshape(3, 3), row[:3]


def rotations_of(states):
    return states[:, 3:].reshape(-1, 3, 3)


def wrong_attitude(motion):
    """What is wrong with the rotations, if they tell."""
    if motion.case.kind == cases.FAST_AND_FAR:
        return SHORT
    rotations, expected = rotations_of(motion.found), rotations_of(motion.expected)
    if np.linalg.det(rotations).min() < 0:
        return "The three axes are left-handed: the determinant is -1."
    if np.abs(rotations.transpose(0, 2, 1) - expected).max() < 1e-3:
        return "These are the transposes, from space to body."
    if np.abs(rotations.transpose(0, 2, 1) @ rotations - np.eye(3)).max() > 1e-4:  # each step is R + dt R'
        return "R is not kept orthogonal: R^T R is no longer I."
    return "Does attitude_rate pass? Which components has omega?"


def squares(states, inertia):
    """R^T R of each row."""
    return rotations_of(states).transpose(0, 2, 1) @ rotations_of(states)


def momenta(states, inertia):
    return np.einsum("nij,nj->ni", rotations_of(states), inertia * states[:, :3])


def energies(states, inertia):
    return 0.5 * states[:, :3] ** 2 @ inertia


ROTATES = Invariant("R^T R", "", squares, absolute, INVARIANT)
KEEPS_MOMENTUM = Invariant("H in space", "of itself", momenta, None, INVARIANT)
KEEPS_ENERGY = Invariant("the energy", "of its start", energies, None, INVARIANT)
SHARES = {1e-4: 0.5, 1e-2: 0.25}  # of the drift of the energy
FOLLOWED = {"within": TRAJECTORY, "restart": restart, "name": "simulate"}
TURNS = {"cases": cases.many_turns, "columns": BOTH, "name": "simulate", "coarsely": COARSELY, "hint": SHORT}

omega_follows_elliptic_functions = law(
    "simulate: omega against Jacobi's elliptic functions, on both sides of the separatrix.", points=0.75, part="a"
).follows(right.tumble, cases.tumbles, columns=[OMEGA], hint="Does euler_equations pass?", **FOLLOWED)
attitude_follows_the_motion = law(
    "simulate: the rotations along a general motion, from any attitude at the start.", points=0.75, part="a"
).follows(right.motion, cases.general_motions, columns=[ATTITUDE], hint=wrong_attitude, **FOLLOWED)
FOLLOWS = omega_follows_elliptic_functions, attitude_follows_the_motion
invariants_stay_over_many_turns = (
    law("simulate: R^T R = I, H in space and the energy over many fast turns.", points=0.5, part="a", after=FOLLOWS)
    .keeps(ROTATES, KEEPS_MOMENTUM, right=right.motion, **TURNS)
    .also.keeps(KEEPS_ENERGY, right=right.motion, partial=SHARES, **TURNS)
)
special_bodies_move_too = law(
    "simulate: equal inertias, rest, pure spin, two times, starts at half turns.", points=0.5, part="a", after=FOLLOWS
).follows(right.special, cases.special_motions, columns=BOTH, hint=wrong_attitude, **FOLLOWED)

# (a) A = B

AT_FIRST = "Compare with euler_equations at the first time."
ALONG_BOTH = "Split omega into a part along H and one along the symmetry axis."
symmetric_bodies_precess = law(
    "symmetric_solution: omega in body components at all times, from omega at t[0].", points=0.75, part="a"
).agrees(right.symmetric_solution, cases.precessing, within=POINTWISE, hint=AT_FIRST)
wobble_goes_round_the_angular_momentum = law(
    "wobble_rate: the rate at which the symmetry axis goes round H, at any angle between them.", points=0.5, part="a"
).agrees(right.wobble_rate, cases.wobbling, within=POINTWISE, hint=ALONG_BOTH)

# (b) Stability and tumbling

LINEAR = "Keep what is linear in the two small components of omega."
small_deviations_grow_at_this_rate = law(
    "growth_rate_squared: positive where the spin is unstable, else minus the frequency squared.", points=0.75, part="b"
).agrees(right.growth_rate_squared, cases.spins, within=POINTWISE, hint=LINEAR)
BACK = "After what time is omega back, sign and all?"
ROUND_LAST = cases.tumbling(1, "omega round the axis of the largest inertia")
ROUND_FIRST = cases.tumbling(-1, "omega round the axis of the smallest inertia")
NEAR_ONE = "How near 1 is a k that is not 1?"
period_round_the_last_axis = law(
    "tumble_period where omega goes round the axis of the largest inertia.", points=0.375, part="b"
).agrees(right.tumble_period, ROUND_LAST, within=PERIOD, hint=BACK)
period_round_the_first_axis = law(
    "tumble_period where omega goes round the axis of the smallest inertia.", points=0.375, part="b"
).agrees(right.tumble_period, ROUND_FIRST, within=PERIOD, hint=BACK)
PERIODS = period_round_the_last_axis, period_round_the_first_axis
period_of_pure_spin_is_that_of_small_oscillations = law(
    "tumble_period for pure spin about axis 0 or 2, by small oscillations.", points=0.25, part="b", after=PERIODS
).agrees(right.tumble_period, cases.pure_spins, within=PERIOD, hint="There k = 0.")
period_grows_to_infinity_at_the_separatrix = (
    law("tumble_period near the separatrix, and math.inf on it.", points=0.25, part="b", after=PERIODS)
    .agrees(right.tumble_period, cases.near_separatrix, within=NEAR_PERIOD, hint=NEAR_ONE)
    .also.agrees(right.tumble_period, cases.on_separatrix, within=PERIOD, hint="What is K(k) for k = 1?")
)

# Drawing


@check(points=0.5, part="b")
def the_box_has_its_twelve_edges(student, draw):
    """wireframe: the edges of the turned box, in any order and direction."""
    judge_boxes(student.wireframe, cases.boxes(draw), within=POINTWISE)


@check(points=0.5, part="a")
def rim_paths_are_drawn(student, draw):
    """plot_rim_paths: the two paths as seen along z, from t[0] to t[-1], with labels and equal scales."""
    # chords of the fine path, over less than a turn, leave the curve by (6/800)^2/8 = 7e-6 of the radius, and those of
    # 26 points, every sixteenth, by (6/25)^2/8 = 7e-3
    for case in cases.pictures(draw):
        picture, (t, R, omega) = student.plot_rim_paths.drawn(case), case.args
        found, radius = curves_seen(picture, 2), case.kwargs["radius"]
        times = np.linspace(t[0], t[-1], 801)
        fine = radius * right.motion(times, R, omega, inertia=case.kwargs["inertia"])[1]
        found = turned_over(found) if all(exchanged(picture)) else found
        hint = partial(wrong_paths, found, picture, fine, radius)
        off = farthest(found, fine[:, :2, 0])
        expect(off, 0.0, within=1e-3 * radius, of="a path", unit="m", hint=hint, gradual=False)
        judge_axes_of_lengths(picture, from_below=True)
