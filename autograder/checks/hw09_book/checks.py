"""Hidden checks of hw09. What is right is built from the formula of hw08, by vectors, one column after another."""

import itertools
import math
from functools import partial

import numpy as np

from tam570_grader import array, check, expect, expect_that, given, group, judge_boxes, number, suspect

RESULTS = {
    "axis_rotation": array(3, 3),
    "space_sequence": array(3, 3),
    "body_sequence": array(3, 3),
    "book_rotations": group(array(3, 3), array(3, 3)),
    "axis_angle": group(array(3), number),
    "book_edges": array(12, 2, 3),
}
NEEDS = ("numpy",)
OFF_LIMITS = {"*": ("scipy.spatial.transform", "tam570.rotations")}
MANUAL = {
    "c": (2, "the drawings of the book before and after both sequences"),
    "e": (1, "the axes n on these drawings, and what shows that they stay where they are"),
}

# Products of six matrices and quaternions are off by 1e-15; axis and angle by any way that does not divide by a
# small number, by 1e-15 too. A matrix that takes 1e-12 rad for none is off by 1e-12.
WITHIN = 1e-13
# Of a small angle and its axis, which keep 15 digits by R - R^T or a quaternion (5e-16 at most). The null vector of
# R - I is off by 6e-11 and more at 1e-8 rad, an eigenvector and arccos by more than that.
RELATIVE = 1e-12
# Axes that turn as S = R A R^T, R <- S R, are right, and the rounding of R^T R grows threefold a turn: 1e-14 after six
# turns, 1e-11 after twelve.
MANY_TURNS = 1e-10
NEARLY = 1e-5  # of a result, or rad; single precision, or a pi of few digits, loses less
AXES = dict(zip("xyz", np.eye(3), strict=True))
GENERIC = "an axis and angle far from special ones"


def turned(n, angle):
    """The matrix of a unit axis and an angle; 1 - cos without cancellation."""
    columns = [
        math.cos(angle) * e + 2 * math.sin(angle / 2) ** 2 * (n @ e) * n + math.sin(angle) * np.cross(n, e)
        for e in np.eye(3)
    ]
    return np.column_stack(columns)


def about(axis, angle):
    return turned(AXES[axis], angle)


def in_space(steps, turn=about):
    """Every column is carried through the steps, first step first."""
    R = np.eye(3)
    for axis, angle in steps:
        R = turn(axis, angle) @ R
    return R


def with_the_body(steps, turn=about):
    return in_space(steps[::-1], turn)


WRONG_TURNS = {
    "the transpose, the rotation the other way": lambda axis, angle: about(axis, -angle),
    "the angle taken for degrees": lambda axis, angle: about(axis, math.radians(angle)),
    "y turned the other way (z, x is the order about y, not x, z)": (
        lambda axis, angle: about(axis, -angle if axis == "y" else angle)
    ),
    "x turned the other way, y and z turned right": (lambda axis, angle: about(axis, -angle if axis == "x" else angle)),
    "z turned the other way, x and y turned right": (lambda axis, angle: about(axis, -angle if axis == "z" else angle)),
    "the angle reduced modulo 360, which is no whole number of turns in radians": (
        lambda axis, angle: about(axis, angle % 360)
    ),
    "the sign of the angle dropped": lambda axis, angle: about(axis, abs(angle)),
}


def in_every_turn(function, sequence):
    """Suspects: sequences of wrong turns."""
    return [
        suspect(f"{says}, in every turn", **{function: lambda steps, wrong=wrong: sequence(steps, wrong)})
        for says, wrong in WRONG_TURNS.items()
    ]


WHERE_TO = "where does a quarter turn take each of the other two axes?"
WHICH_FIRST = "which matrix acts on a vector first, the leftmost or the rightmost?"


NEARLY_RIGHT = "nearly right: some number in it has too few digits"


def wrong_matrix(R, right, without, otherwise, within=WITHIN):
    """What to say of a matrix that is without() half turns or nearly right, and otherwise."""
    if np.abs(R - without()).max() <= within:
        return "a half turn is taken for no turn"
    return NEARLY_RIGHT if np.abs(R - right).max() < NEARLY else otherwise


def none_for_half(axis, angle):
    """A turn is taken for none where the sine of its angle is zero: at half turns, too."""
    return about(axis, angle if abs(math.sin(angle)) > 1e-15 else 0.0)


def a_unit_axis(draw):
    """All components count: the smallest is a tenth at least."""
    v = draw.uniform(0.3, 1, 3) * draw.choice([-1, 1], 3)
    return v / np.linalg.norm(v)


def a_rotation(draw):
    return turned(a_unit_axis(draw), draw.uniform(0.5, 2.5))


# (a, b) Sequences

TURNS = ("no turn", "a quarter turn", "a half turn", "", "a whole turn")  # by the number of quarters


@check(points=1, part="a", suspects=[suspect(says, axis_rotation=wrong) for says, wrong in WRONG_TURNS.items()])
def turns_about_the_coordinate_axes(student, draw):
    """axis_rotation turns by the angle about x, y or z, by the right-hand rule."""
    calls = []
    for axis in "xyz":
        calls += [given(axis, angle).on(f"a turn about {axis}") for angle in draw.uniform(-7, 7, 5)]
        calls += [
            given(axis, quarters * math.pi / 2).on(f"{TURNS[abs(quarters)]} about {axis}")
            for quarters in (0, 1, -1, 2, -2, 4)
        ]
    for R, call in zip(student.axis_rotation.many(calls), calls, strict=True):
        right = about(*call.args)
        expect(
            R,
            right,
            within=WITHIN,
            of="the matrix",
            at=call,
            kind=call.kind,
            hint=partial(wrong_matrix, R, right, partial(none_for_half, *call.args), WHERE_TO),
        )


@check(points=0.5, part="a", after=turns_about_the_coordinate_axes)
def other_axes_are_refused(student, draw):
    """axis_rotation raises ValueError for any other string."""
    angle = draw.uniform(0.5, 3)
    for axis in ("w", "X", "xy", "yz", "", "-x", "x ", "1"):
        kind = f'the string "{axis}"'
        expect_that(
            student.on(kind).axis_rotation.refuses(axis, angle),
            "axis_rotation does not raise ValueError",
            kind=kind,
            at=axis,
        )


def sequences(draw):
    """Two to twelve steps each, quarter turns and none among the last ones; the order counts in all of them.

    With what they are called.
    """
    orders = ("xyz", "zxz", "yxyz", "zyxzy", "xzyxzy", "yz", "zxyxzzyxyxyz", "xxyyz")
    angles = [draw.uniform(-4, 4, len(order)) for order in orders]
    angles += [np.array([1, 0, 1, -1, 2]) * math.pi / 2, np.array([-1, 1, 0]) * math.pi / 2]
    kinds = [f"a sequence of {len(order)} turns" for order in orders]
    kinds += ["a sequence with a half turn", "a sequence of quarter turns"]
    return [
        (list(zip(order, turns.tolist(), strict=True)), kind)
        for order, turns, kind in zip((*orders, "zyxyz", "xyz"), angles, kinds, strict=True)
    ]


def judge_sequences(function, right, draw):
    cases = sequences(draw)
    calls = [given(steps).on(kind) for steps, kind in cases]
    for R, (steps, kind) in zip(function.many(calls), cases, strict=True):
        expected, within = right(steps), WITHIN if len(steps) < 5 else MANY_TURNS
        expect(
            R,
            expected,
            within=within,
            of="the matrix",
            at=steps,
            kind=kind,
            hint=partial(wrong_matrix, R, expected, partial(right, steps, none_for_half), WHICH_FIRST, within),
        )


def judge_short_sequences(function, draw):
    step = (str(draw.choice(list("xyz"))), draw.uniform(0.5, 3))
    for steps, kind in (([step], "a single turn"), ([], "no turns at all")):
        found = function.many([given(steps).on(kind)])[0]
        expect(found, in_space(steps), within=WITHIN, of="the matrix", at=steps, kind=kind)


@check(
    points=1,
    part="a",
    suspects=[
        suspect("the order reversed: axes that turn with the body", space_sequence=with_the_body),
        suspect("the transpose", space_sequence=lambda steps: in_space(steps).T),
        *in_every_turn("space_sequence", in_space),
    ],
)
def space_sequence_takes_the_first_step_first(student, draw):
    """space_sequence turns about axes fixed in space, first step first."""
    judge_sequences(student.space_sequence, in_space, draw)


@check(points=0.25, part="a", after=space_sequence_takes_the_first_step_first)
def space_sequence_takes_few_steps(student, draw):
    """space_sequence of one step, and of none: the identity."""
    judge_short_sequences(student.space_sequence, draw)


@check(
    points=1,
    part="a",
    suspects=[
        suspect("the order reversed: axes fixed in space", body_sequence=in_space),
        suspect("the transpose", body_sequence=lambda steps: with_the_body(steps).T),
        *in_every_turn("body_sequence", with_the_body),
    ],
)
def body_sequence_takes_the_axes_along(student, draw):
    """body_sequence turns about the axes that the steps before have turned."""
    judge_sequences(student.body_sequence, with_the_body, draw)


@check(points=0.25, part="a", after=body_sequence_takes_the_axes_along)
def body_sequence_takes_few_steps(student, draw):
    """body_sequence of one step, and of none: the identity."""
    judge_short_sequences(student.body_sequence, draw)


def books(angle=math.pi / 2, sequence=in_space):
    z_then_x = [("z", angle), ("x", angle)]
    return sequence(z_then_x), sequence(z_then_x[::-1])


@check(
    points=1,
    part="a",
    suspects=[
        suspect("(a) and (b) swapped, or axes that turn with the book", book_rotations=lambda: books()[::-1]),
        suspect("both turns the other way", book_rotations=lambda: books(-math.pi / 2)),
        suspect("the transposes", book_rotations=lambda: [R.T for R in books()]),
        suspect("90 radians", book_rotations=lambda: books(90.0)),
    ],
)
def the_book_is_turned_in_both_orders(student, draw):
    """book_rotations: 90 degrees about z then x, and about x then z, axes fixed in space."""
    for found, right, which in zip(student.book_rotations(), books(), ("(a)", "(b)"), strict=True):
        nearly = np.abs(found - right).max() < NEARLY
        expect(
            found,
            right,
            within=WITHIN,
            of=f"the matrix of {which}",
            hint=NEARLY_RIGHT if nearly else "turn a real book, and look where its three edges end",
        )


# (d, e) Axis and angle


def reversed_axis(R):
    n, angle = by_arctangent(R)
    return -n, angle


def by_arctangent(R):
    """Axis and angle of a rotation that is not too near a half turn."""
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    length = np.linalg.norm(v)
    return v / length, math.atan2(length, np.trace(R) - 1)


def by_arccosine(R):
    return by_arctangent(R)[0], math.acos(np.clip((np.trace(R) - 1) / 2, -1, 1))


def without_axis_at_pi(R):
    """v / (2 sin angle) where v is zero and the angle pi."""
    return np.zeros(3), math.pi


@check(
    points=1,
    part="a",
    suspects=[
        suspect("the axis reversed, that of the transpose", axis_angle=reversed_axis),
        suspect("the angle in degrees", axis_angle=lambda R: (by_arctangent(R)[0], math.degrees(by_arctangent(R)[1]))),
    ],
)
def axis_and_angle_are_those_of_the_matrix(student, draw):
    """axis_angle gives the unit axis and the angle of a rotation, of the book's two and of a quarter turn too."""
    cases = [(a_unit_axis(draw), draw.uniform(0.3, 2.8)) for _ in range(20)]
    cases += [(np.array(v) / math.sqrt(3), 2 * math.pi / 3) for v in ((1, -1, 1), (1, 1, 1))]
    compare_axes(student, cases, GENERIC)
    quarters = [(sign * n, math.pi / 2) for n in np.eye(3) for sign in (1, -1)]
    compare_axes(student, quarters, "a quarter turn about a coordinate axis")
    cases = [(a_unit_axis(draw), angle) for angle in (*draw.uniform(0.05, 0.3, 3), *draw.uniform(2.8, 3.09, 3))]
    compare_axes(student, cases, GENERIC)
    planes = [sign * np.roll([0.0, 0.6, -0.8], k) for k in (0, 1, 2) for sign in (1, -1)]
    for axes in ([*np.eye(3), *-np.eye(3)], planes):
        turns = [(n, angle) for n in axes for angle in (0.1, 1.0, 2.0, 3.0)]
        compare_axes(student, turns, f"an axis {axis_kind(axes[0])}")


WHAT_STAYS = "which vector does R leave alone, and what is the trace of R?"


def compare_axes(student, cases, kind, hint=WHAT_STAYS, nearly=NEARLY_RIGHT, flat=""):
    """With one kind of input for all cases, or one for each.

    Where a few digits are lost `nearly` is said, and of an angle `flat` if that is given.
    """
    kinds = [kind] * len(cases) if isinstance(kind, str) else kind
    calls = [given(turned(*case)).on(kind) for case, kind in zip(cases, kinds, strict=True)]
    found = student.axis_angle.many(calls)
    near_is_pi = taken_for(math.pi, found, cases, WITHIN)
    for (axis, angle), case, call in zip(found, cases, calls, strict=True):
        of_angle = NEAR_IS_PI if near_is_pi else partial(wrong_angle, angle, case[1], hint, flat or nearly)
        expect(angle, case[1], within=WITHIN, of="the angle", unit="rad", at=call, kind=call.kind, hint=of_angle)
        expect(
            axis,
            case[0],
            within=WITHIN,
            of="the axis",
            at=call,
            kind=call.kind,
            hint=partial(wrong_axis, axis, case[0], hint, nearly),
        )


NEAR_IS_PI = "angles that are near enough to pi are given as pi"
BEYOND_PI = "it is larger than pi: the same turn is one by 2 pi - angle about the opposite axis"
SIGNS = "the sizes of its components are right, their signs are not: R + R^T has the products n_x n_y"


def wrong_angle(angle, right, otherwise, nearly):
    """What is wrong with an angle, if that can be told, and otherwise what to look at."""
    if abs(angle + right - 2 * math.pi) < 1e-6 < angle - math.pi:
        return BEYOND_PI
    if abs(angle - right / 2) < 1e-6 < right:
        return "it is half of the angle"
    return nearly if abs(angle - right) < NEARLY else otherwise


def wrong_axis(axis, right, otherwise, nearly):
    """What is wrong with an axis, if that can be told, and otherwise what to look at."""
    size, off = np.linalg.norm(axis), np.abs(axis - right) > WITHIN
    if abs(size - 1) > 1e-6 and np.abs(axis - size * right).max() <= 1e-6 * size:
        return "it points the right way, but its length is not 1"
    if np.abs(axis + right).max() < 1e-6:
        return "it points the other way"
    if off.any() and np.abs(right[off]).max() < 1e-4 and np.abs(axis - right).max() < 1e-6:
        return "only what is small or zero in it is off: is that a square root of a small difference?"
    if np.abs(axis - right).max() < NEARLY:
        return nearly
    return SIGNS if np.abs(np.abs(axis) - np.abs(right)).max() < 1e-6 else otherwise


def taken_for(special, found, cases, within):
    """Whether the angles nearer to a special one than some bound are taken for it, and the others are right."""
    angles, right = np.array([angle for _, angle in found]), np.array([angle for _, angle in cases])
    off, distance = np.abs(angles - right) > within, np.abs(right - special)
    if not off.any() or np.any(angles[off] != special):
        return False
    return distance[off].max() < distance[~off].min(initial=np.inf)


def axis_kind(n):
    return ("", "along a coordinate axis", "in a coordinate plane", "of any direction")[np.count_nonzero(n)]


def distances(draw):
    """From the special angles, rad."""
    return [1e-8, 1e-9, 1e-12, *10 ** draw.uniform(-12, -2, 9)]


@check(
    points=0.75,
    part="a",
    after=axis_and_angle_are_those_of_the_matrix,
    suspects=[suspect("arccos of the trace alone, which loses half of the digits", axis_angle=by_arccosine)],
)
def small_angles_keep_their_digits(student, draw):
    """axis_angle keeps all digits of axis and angle for angles from 1e-12 to 1e-2."""
    cases = [(a_unit_axis(draw), angle) for angle in (*distances(draw), *FEW_LOST)]
    cases += [(n, angle) for n in (*np.eye(3), *-np.eye(3)) for angle in (1e-9, 1e-3)]
    kind = "a very small angle"
    calls = [given(turned(*case)).on(kind) for case in cases]
    found = student.axis_angle.many(calls)
    small_is_none = taken_for(0.0, found, cases, RELATIVE * np.array([angle for _, angle in cases]))
    for (axis, angle), case, call in zip(found, cases, calls, strict=True):
        says = {"within": RELATIVE, "unit": "of itself", "at": call, "kind": kind}
        expect(
            angle,
            case[1],
            scale=case[1],
            of="the angle",
            **says,
            hint="angles that are small enough are given as 0" if small_is_none else FLAT,
        )
        expect(
            axis,
            case[0],
            scale=np.max(np.abs(case[0])),
            of="the axis",
            **says,
            hint=UNDETERMINED if is_left_alone(axis, call.args[0]) else FLAT,
        )
        expect(
            turned(axis, angle), call.args[0], within=WITHIN, of="the matrix made of axis and angle", at=call, kind=kind
        )


FEW_LOST = 1.2e-3, 2e-3, 3.5e-3, 6e-3  # rad; an arccos is off by 3e-12 to 8e-11 of them
FLAT = "how flat is the cosine there? and the sine?"
UNDETERMINED = "R leaves it alone to the last digit: near no turn R nearly does so with every vector"


def is_left_alone(axis, R):
    """An eigenvector of R for the eigenvalue 1, to the rounding of R: no axis that is off by chance is that."""
    return np.abs(R @ axis - axis).max() < 2e-15


@check(points=0.75, part="a", after=axis_and_angle_are_those_of_the_matrix)
def angles_near_pi_keep_their_digits(student, draw):
    """axis_angle keeps all digits of axis and angle 1e-12 to 1e-2 from a half turn, and at a quarter turn."""
    cases = [(a_unit_axis(draw), math.pi - distance) for distance in distances(draw)]
    compare_axes(student, cases, "an angle near pi", WHICH_PART, WHICH_PART, flat=FLAT_AT_PI)
    # the sine is flat there: an arcsine of it loses half of the digits
    near = [(a_unit_axis(draw), math.pi / 2 + more) for more in (0.0, 1e-8, -1e-8)]
    compare_axes(student, near, "a quarter turn, or nearly one, about an axis of any direction", nearly=NO_ARCSINE)


FLAT_AT_PI = "an arccos of the trace loses half of the digits there, and so does the arcsine of half of the angle"
NO_ARCSINE = "nearly right: how flat is the sine there, and the cosine?"
WHICH_PART = "which part of R is large there: R - R^T or R + R^T?"


@check(points=0.25, part="a", after=angles_near_pi_keep_their_digits)
def axes_with_small_components_keep_their_digits(student, draw):
    """axis_angle keeps all digits near pi where a component of the axis is very small."""
    cases = []
    for k in (0, 1, 2):
        n = a_unit_axis(draw)
        n[k] = 10 ** draw.uniform(-7, -5) * draw.choice([-1, 1])
        cases.append((n / np.linalg.norm(n), math.pi - 10 ** draw.uniform(-9, -3)))
    kinds = ["an angle near pi, a component of the axis near 0"] * 3
    for n in ([1.0, 0, 0], [-1.0, 0, 0], [0, 0.6, -0.8], [0, -0.8, 0.6]):
        cases += [(np.roll(n, k), math.pi - distance) for k in (0, 1, 2) for distance in (1e-9, 1e-3)]
        kinds += [f"an angle near pi, an axis {axis_kind(n)}"] * 6
    compare_axes(student, cases, kinds, nearly=WHICH_PART)


@check(
    points=0.25,
    part="a",
    after=axis_and_angle_are_those_of_the_matrix,
    suspects=[suspect("an axis divided by sin(pi) = 0, where R - R^T says nothing", axis_angle=without_axis_at_pi)],
)
def half_turns_have_their_axis(student, draw):
    """axis_angle of a half turn: the angle pi and the axis, of either sign."""
    axes = [
        *(a_unit_axis(draw) for _ in range(8)),
        *np.eye(3),
        *(np.roll(n, k) for k in (0, 1, 2) for n in ([0.0, 0.6, -0.8], [0.0, 0.6, 0.8])),
    ]
    calls = [given(2 * np.outer(n, n) - np.eye(3)).on(f"a half turn, an axis {axis_kind(n)}") for n in axes]
    for (axis, angle), n, call in zip(student.axis_angle.many(calls), axes, calls, strict=True):
        # 2 n n^T - I of a rounded n is a rotation to 1e-16, and so is the sine that it has
        expect(
            angle,
            math.pi,
            within=WITHIN,
            of="the angle",
            unit="rad",
            at=call,
            kind=call.kind,
            hint=partial(wrong_angle, angle, math.pi, "", WHICH_PART),
        )
        expect(
            np.outer(axis, axis),
            np.outer(n, n),
            within=WITHIN,
            of="the product n n^T of the axis",
            at=call,
            kind=call.kind,
            hint=partial(wrong_half_turn, axis, n),
        )


def wrong_half_turn(axis, n):
    """What to say of a half turn's axis that is neither n nor -n."""
    return SIGNS if np.abs(np.abs(axis) - np.abs(n)).max() < 1e-6 else "what is R + I there?"


@check(points=0.25, part="a", after=axis_and_angle_are_those_of_the_matrix)
def no_turn_has_a_unit_axis(student, draw):
    """axis_angle of the identity: the angle 0 and any unit axis."""
    axis, angle = student.on("the identity").axis_angle(np.eye(3))
    expect(angle, 0.0, within=WITHIN, of="the angle", unit="rad", kind="the identity")
    expect_that(np.any(axis), "the axis is the zero vector", kind="the identity")
    expect(np.linalg.norm(axis), 1.0, within=WITHIN, of="the length of the axis", kind="the identity")


@check(points=0.25, part="a", after=axis_and_angle_are_those_of_the_matrix)
def what_is_no_rotation_is_refused(student, draw):
    """axis_angle raises ValueError for what is no rotation, and takes one with R^T R off by 9e-7."""
    R, noise = a_rotation(draw), draw.uniform(0.3, 1, (3, 3)) * draw.choice([-1, 1], (3, 3))
    near = [(off_by(R, draw, 7e-7), "a matrix with R^T R off by 7e-7")]
    near += [
        ((1 + 4.5e-7) * matrix, f"{what} times 1 + 4.5e-7")
        for matrix, what in ((R, "a rotation"), (np.eye(3), "the identity"))
    ]
    found = student.axis_angle.many([given(matrix).on(kind) for matrix, kind in near])
    for (axis, angle), (matrix, kind) in zip(found[:2], near[:2], strict=True):
        n, right = by_arctangent(matrix)
        # the two parts of R tell angles and axes that differ by the size of the shear; an axis by eigh of the
        # symmetric part by up to 3.5e-6 (the largest of 4000 draws)
        expect([*axis, angle], [*n, right], within=2e-5, of="axis or angle", at=matrix, kind=kind)
    axis, angle = found[2]
    expect(np.linalg.norm(axis), 1.0, within=1e-5, of="the length of the axis", kind=near[2][1])
    # the trace is that of a cosine of 1 + 6.8e-7: no angle, and 1.2e-3 rad if the size of 1 - cos th is taken
    expect(angle, 0.0, within=2e-3, of="the angle", unit="rad", kind=near[2][1])
    for matrix, kind in no_rotations(R, noise, draw):
        expect_that(
            student.on(kind).axis_angle.refuses(matrix), "axis_angle does not raise ValueError", kind=kind, at=matrix
        )


def off_by(R, draw, defect):
    """R sheared: max abs(R^T R - I) is `defect`, and that of R R^T - I, which some take, within a tenth of it."""
    while True:
        shear = draw.uniform(-1, 1, (3, 3))
        # the diagonal stays out: allclose allows 1e-5 beside a one
        shear = (shear + shear.T) * (1 - np.eye(3))
        ours, theirs = np.abs(shear).max(), np.abs(R @ shear @ R.T).max()
        if abs(theirs / ours - 1) < 0.1:
            return R @ (np.eye(3) + 0.5 * defect / ours * shear)


def no_rotations(R, noise, draw):
    """Matrices to refuse, and what each is."""
    holed, infinite = R.copy(), R.copy()
    holed[0, 1], infinite[2, 0] = np.nan, np.inf
    i, j = draw.permutation(3)[:2]
    return (
        (-R, "a reflection"),
        (R @ np.diag([1.0, 1.0, -1.0]), "a reflection"),
        # R^T R is off by what is allowed, the determinant, near -1, by more than a rounding
        ((1 + 4e-7) * -R, "a reflection times 1 + 4e-7"),
        ((1 - 4e-7) * R @ np.diag([1.0, -1.0, 1.0]), "a reflection times 1 - 4e-7"),
        (1.1 * R, "a rotation times 1.1"),
        ((1 + 1e-5) * R, "a rotation times 1.00001"),
        *((R @ sheared, "a rotation with a shear of 1e-5") for sheared in SHEARS),
        *((sheared @ R, "a shear of 1e-5 after a rotation") for sheared in SHEARS),
        (off_by(R, draw, 1.5e-6), "a matrix with R^T R off by 1.5e-6"),
        (noise, "a matrix of random numbers"),
        (np.zeros((3, 3)), "the zero matrix"),
        (holed, "a matrix with a NaN"),
        (infinite, "a matrix with an infinite element"),
        # zeros times infinity are NaN, and no comparison with NaN is true
        *(
            (infinite_at(i, k, size), f"the identity, but for {size} {'on' if k == i else 'off'} the diagonal")
            for k in (i, j)
            for size in (np.inf, -np.inf)
        ),
    )


# of two axes each: two columns, or two rows, of what they make of a rotation are not perpendicular, and no others
SHEARS = np.eye(3) + 1e-5 * np.array([np.outer(e, f) + np.outer(f, e) for e, f in itertools.combinations(np.eye(3), 2)])


def infinite_at(i, j, size):
    """The identity, with this infinity in row i and column j."""
    R = np.eye(3)
    R[i, j] = size
    return R


# (c) The book


@check(points=1.5, part="c")
def the_book_has_its_twelve_edges(student, draw):
    """book_edges are the edges of the turned book, in any order and direction."""
    sizes = [draw.permutation(10 ** draw.uniform(-1, 1) * np.array([1, 1.7, 2.9])) for _ in range(6)]
    cases = [(a_rotation(draw), size, "a random rotation and size") for size in sizes[:4]]
    quarter = about(str(draw.choice(list("xyz"))), math.pi / 2)
    cases += [
        (np.eye(3), sizes[4], "a book that is not turned"),
        (quarter, sizes[5], "a quarter turn"),
        (a_rotation(draw), np.full(3, sizes[0][0]), "a cube"),
    ]
    judge_boxes(student.book_edges, cases, within=WITHIN)
