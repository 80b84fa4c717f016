"""Hidden checks of hw08.

What is right is built another way than by the formula: by turning a frame that has the axis as third vector.
"""

import math
from functools import partial

import numpy as np

from tam570_grader import array, check, expect, expect_that, given, once, suspect

RESULTS = {"skew": array(3, 3), "rotation_matrix": array(3, 3), "rotate": array(3)}
NEEDS = ("numpy",)
OFF_LIMITS = {"*": ("scipy.spatial.transform", "tam570.rotations")}

NEARLY = 1e-5  # of a result; single precision, or a pi of few digits, loses less
# a few roundings of numbers of size 1 make 1e-15; quaternions and products of matrices, 1e-14
POINTWISE = 1e-12
TINY = 1e-14  # the rounding of the cosine; an angle of 1e-12 taken for 0 is off by 1e-12, cos 3e-6 for 1 by 4e-12
# 1e6 rad, reduced modulo 2 pi by hand, is off by 2e-10; R^T R of a matrix exponential by 2e-8
HUGE_ANGLE = 5e-8


def turned(axis, angle):
    """The rotation matrix: e, f, n with e turned towards f; the frame comes from a QR factorisation."""
    n = np.asarray(axis) / np.max(np.abs(axis))
    n = n / np.linalg.norm(n)
    e, f = np.linalg.qr(np.column_stack([n, np.eye(3)]))[0].T[1:]
    f = f * np.sign(np.dot(np.cross(e, f), n))
    c, s = np.cos(angle), np.sin(angle)
    return np.outer(n, n) + np.outer(c * e + s * f, e) + np.outer(c * f - s * e, f)


def transposed(axis, angle):
    return turned(axis, angle).T


def in_degrees(axis, angle):
    return turned(axis, np.radians(angle))


def by_its_size(axis, angle):
    return turned(axis, abs(angle))


def none_below(smallest):
    """Smaller angles are taken for none."""
    return lambda axis, angle: turned(axis, angle if abs(angle) > smallest else 0.0)


def with_a_positive_sine(axis, angle):
    """sin th by the root of 1 - cos^2 th."""
    return turned(axis, math.acos(math.cos(angle)))


def in_single_precision(axis, angle):
    single = np.float32(angle)
    return turned(axis, math.atan2(np.sin(single), np.cos(single)))


def by_formula(angle, n, m, c=None):
    """The formula with these vectors for the unit vector in its second and third term, and with c for the cosine."""
    c = np.cos(angle) if c is None else c
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + np.sin(angle) * np.cross(m, np.eye(3)).T


def unit(axis):
    return axis / np.linalg.norm(axis)


def summed(axis, angle, product):
    """The formula with this matrix for n n^T."""
    return turned(axis, angle) + (1 - np.cos(angle)) * (product - np.outer(unit(axis), unit(axis)))


def of_first_order(axis, angle):
    """cos th = 1 where the angle is small."""
    n = unit(axis)
    return by_formula(angle, n, n, 1.0) if abs(angle) < 1e-4 else turned(axis, angle)


def rotated(matrix):
    """`rotate` as the product with a matrix of axis and angle."""
    return lambda r, axis, angle: matrix(axis, angle) @ r


def suspects(wrong_matrices, within=1e-6):
    """For rotation_matrix, and for rotate."""
    matrices = [suspect(says, within=within, rotation_matrix=wrong) for says, wrong in wrong_matrices.items()]
    vectors = [suspect(says, within=within, rotate=rotated(wrong)) for says, wrong in wrong_matrices.items()]
    return matrices, vectors


WRONG_MATRICES = {
    "the transpose, the rotation the other way (look at the sign of the sin th term)": transposed,
    "the angle taken for degrees": in_degrees,
    "the sign of the angle dropped": by_its_size,
    "sin th never negative (a root of 1 - cos^2 th has lost the sign)": with_a_positive_sine,
    "half of the angle": lambda axis, angle: turned(axis, angle / 2),
    "the axis not made a unit vector": lambda axis, angle: by_formula(angle, axis, axis),
    "the axis not made a unit vector in the sin th term": (lambda axis, angle: by_formula(angle, unit(axis), axis)),
    "the axis not made a unit vector in the (1 - cos th) term": (
        lambda axis, angle: by_formula(angle, axis, unit(axis))
    ),
    "the axis divided by the square of its length": (
        lambda axis, angle: by_formula(angle, axis / (axis @ axis), axis / (axis @ axis))
    ),
    "the axis not made a unit vector in n . r": lambda axis, angle: summed(axis, angle, np.outer(unit(axis), axis)),
    "n * r, element by element, for n . r": lambda axis, angle: summed(axis, angle, np.diag(unit(axis) ** 2)),
    "r for cos th r, or n n^T for [n x]^2 in a formula with it": (
        lambda axis, angle: turned(axis, angle) + (1 - np.cos(angle)) * np.eye(3)
    ),
    "1 - sin th for 1 - cos th": lambda axis, angle: (
        turned(axis, angle) + (np.cos(angle) - np.sin(angle)) * np.outer(unit(axis), unit(axis))
    ),
    "-(1 - cos th) for 1 - cos th": lambda axis, angle: (
        turned(axis, angle) - 2 * (1 - np.cos(angle)) * np.outer(unit(axis), unit(axis))
    ),
    "-(1 - cos th) [n x]^2 for (1 - cos th) [n x]^2": lambda axis, angle: (
        turned(axis, angle) + 2 * (1 - np.cos(angle)) * (np.eye(3) - np.outer(unit(axis), unit(axis)))
    ),
    "the angle reduced modulo 360, which is no whole number of turns in radians": (
        lambda axis, angle: turned(axis, angle % 360)
    ),
    "the angle reduced modulo pi": lambda axis, angle: turned(axis, math.fmod(angle, math.pi)),
    "1 + cos th for 1 - cos th": (
        lambda axis, angle: turned(axis, angle) + 2 * np.cos(angle) * np.outer(unit(axis), unit(axis))
    ),
}
# Right but for a few angles: compared as closely as the check does, so that nothing else that is nearly right agrees.
WRONG_WHEN_SMALL = {
    f"a turn by {what} taken for no turn": none_below(smallest) for what, smallest in (("1e-12", 1e-10), ("1e-9", 1e-8))
}
WRONG_WHEN_SMALL["cos th taken for 1 where the angle is small"] = of_first_order


@once
def rotations(draw, angles):
    """Axes of lengths from .1 to 10, some in coordinate planes and one on an axis, angles, and the right matrices.

    Without angles given the last two axes are next to coordinate axes: an arccos of what is 1 but for 1e-16 takes
    them for those.
    """
    near = [] if angles is not None else [[1e-8, 0.0, 1.0], [1.0, -1e-8, 0.0]]
    angles = draw.uniform(-4 * np.pi, 4 * np.pi, 15) if angles is None else angles
    axes = draw.normal(size=(len(angles), 3)) * 10 ** draw.uniform(-1, 1, (len(angles), 1))
    axes[::3, draw.integers(3)] = 0.0
    axes[0] = np.roll([axes[0, 0] + axes[0, 1], 0.0, 0.0], draw.integers(3))
    axes[len(axes) - len(near) :] = np.reshape(near, (-1, 3))
    return [(axis, angle, turned(axis, angle)) for axis, angle in zip(axes, angles, strict=True)]


@once
def plain_turns(draw):
    """No turn, quarter, half and whole turns about axes of whole numbers, and the right matrices."""
    ways = [*np.eye(3), *-np.eye(3), np.array([1.0, 0.0, -1.0]), np.array([-1.0, -1.0, -1.0])]
    turns = np.array([0.0, 0.5, 1.0, -0.5, -1.0, 2.0]) * np.pi
    cases = [(draw.integers(1, 4) * way, angle) for way in ways for angle in turns]
    return [(axis, angle, turned(axis, angle)) for axis, angle in cases]


TURNS = {0.0: "no turn", 0.5: "a quarter turn", 1.0: "a half turn", 2.0: "a whole turn"}


def plain_kind(axis, angle):
    """What a plain turn is called."""
    about = "a coordinate axis" if np.count_nonzero(axis) == 1 else "a diagonal"
    return f"{TURNS[abs(angle) / np.pi]} about {about}"


def any_kind(axis, angle):
    middle, largest = np.sort(np.abs(axis))[1:]
    return "an axis 1e-8 from a coordinate axis" if 0 < middle < 1e-6 * largest else "a random axis and angle"


def not_turned(found, before, otherwise=""):
    """What to say where a turn has left all as it was, or otherwise."""
    same = np.allclose(found, before, rtol=POINTWISE, atol=POINTWISE)
    return "it is taken for no turn" if same else otherwise


def digits_lost(found, right, otherwise=""):
    """What to say of a result that is nearly right, or otherwise."""
    if np.abs(found - right).max() > NEARLY * np.abs(right).max():
        return otherwise
    if np.array_equal(found, np.float32(found)):
        return "nearly right: its numbers are in single precision"
    if any(np.array_equal(found, np.round(found, places)) for places in range(5, 13)):
        return "nearly right: its numbers are rounded"
    return "nearly right: some number in it has too few digits"


def matrices(student, cases, kind):
    """The student's matrices beside the cases and the kind(axis, angle) of each."""
    kinds = [kind(axis, angle) for axis, angle, _ in cases]
    calls = [given(*case[:2]).on(kind) for case, kind in zip(cases, kinds, strict=True)]
    return zip(student.rotation_matrix.many(calls), cases, kinds, strict=True)


@check(points=1, part="a", suspects=[suspect("the transpose, r x v", skew=lambda v: np.cross(v, np.eye(3)))])
def skew_is_the_cross_product(student, draw):
    """skew(v) r = v x r, for any v and r."""
    vectors = [*(draw.normal(size=(8, 3)) * 10 ** draw.uniform(-3, 3, (8, 1))), *-np.eye(3), np.zeros(3)]
    kinds = ["a v of random numbers"] * 8 + ["a v along a coordinate axis"] * 3 + ["a v of zeros"]
    calls = [given(v).on(kind) for v, kind in zip(vectors, kinds, strict=True)]
    for v, matrix, kind in zip(vectors, student.skew.many(calls), kinds, strict=True):
        r = draw.normal(size=3)
        expect(
            matrix @ r,
            np.cross(v, r),
            within=POINTWISE,
            scale=np.linalg.norm(v) or 1.0,
            of="skew(v) r",
            unit="of the length of v",
            at=(v, r),
            kind=kind,
        )


WHAT_TO_TRY = "try a quarter turn about z, an axis twice as long, and one half as long"


@check(points=2, part="a", suspects=suspects(WRONG_MATRICES)[0])
def matrix_turns_by_the_right_hand_rule(student, draw):
    """rotation_matrix turns by the angle about the axis, right-handed, whatever the axis's length."""
    for R, case, kind in matrices(student, rotations(draw, None), any_kind):
        expect(
            R,
            case[2],
            within=POINTWISE,
            of="the matrix",
            at=case,
            kind=kind,
            hint=partial(digits_lost, R, case[2], WHAT_TO_TRY),
        )
    for R, case, kind in matrices(student, plain_turns(draw), plain_kind):
        expect(
            R,
            case[2],
            within=POINTWISE,
            of="the matrix",
            at=case,
            kind=kind,
            hint=partial(not_turned, R, np.eye(3), "where do the coordinate axes go?"),
        )


@check(points=1, part="a", after=matrix_turns_by_the_right_hand_rule, suspects=suspects(WRONG_WHEN_SMALL, TINY)[0])
def matrix_holds_for_every_angle(student, draw):
    """An angle of 1e-12 turns by 1e-12, one of 1e6 by 1e6; R^T R = I and det R = 1 for all of them."""
    for angles, within, kind in every_angle(draw):
        for R, case, _ in matrices(student, rotations(draw, angles), lambda axis, angle, kind=kind: kind):
            expect(
                R,
                case[2],
                within=within,
                of="the matrix",
                at=case,
                kind=kind,
                hint=partial(terms, R, *case[:2], within),
            )
            # an exponential of the matrix by scaling and squaring is off in its lengths, too, at 1e6 rad
            expect(R.T @ R, np.eye(3), within=max(within, POINTWISE), of="R^T R", at=case, kind=kind)
            expect(np.linalg.det(R), 1.0, within=max(within, POINTWISE), of="det R", at=case, kind=kind)


AS_FLOAT32 = "it is that of the angle in single precision"


def nearer(found, wrong, right):
    """Whether a result is much nearer to what is wrong than to what is right."""
    return np.linalg.norm(found - wrong) < np.linalg.norm(found - right) / 4


def precision(found, r, axis, angle, right):
    return AS_FLOAT32 if nearer(found, in_single_precision(axis, angle) @ r, right @ r) else ""


def terms(R, axis, angle, within):
    """Which of sine and cosine the matrix has wrong, if it is one of them: the trace has the one, R - R^T the other."""
    cosine, sine = (np.trace(R) - 1) / 2, np.sum((R - R.T) * turned(axis, np.pi / 2)) / 4
    if nearer(R, in_single_precision(axis, angle), turned(axis, angle)):
        return AS_FLOAT32
    wrong = abs(cosine - np.cos(angle)) > within, abs(sine - np.sin(angle)) > within
    return {
        (True, False): "the sine is right in it, the cosine is not",
        (False, True): "the cosine is right in it, the sine is not",
    }.get(wrong, "look at what each term becomes there")


SMALL = 3e-5, 9e-5, 1e-4, 9e-4, 1e-3, 9e-3, 3e-2  # where series of one term or two are used, and lose digits


def every_angle(draw):
    """Angles by size, how near to right the matrix must be, and what the angles are called."""
    signs = draw.choice([-1, 1], 4)
    yield (-1e-12, 1e-12, -1e-9, 1e-9, -3e-6, 3e-6), TINY, "an angle of 1e-12, 1e-9 or 3e-6"
    any_size = 10 ** draw.uniform(-8, 0, 4) * signs
    any_size = (*any_size, *SMALL, *(-angle for angle in SMALL))
    yield any_size, POINTWISE, "an angle from 1e-8 to 1"
    yield (np.pi - 1e-9, 1e-9 - np.pi, 2 * np.pi), POINTWISE, "an angle next to a half turn, or a whole turn"
    yield tuple(10 ** draw.uniform(2, 6, 4) * signs), HUGE_ANGLE, "an angle from 100 to 1e6"


def length_kind(length):
    return "a very short axis" if length < 1 else "a very long axis"


@check(points=1, part="a", after=matrix_turns_by_the_right_hand_rule)
def matrix_depends_on_the_direction_alone(student, draw):
    """Axes of length 1e-100 or 1e100 give the same matrix as the unit axis."""
    n, angle = draw.normal(size=3), draw.uniform(0.5, 3)
    # beyond 1e150 the square of a length overflows
    lengths = 10.0 ** draw.uniform((-100, -50, 0, 50), (-50, 0, 50, 100))
    calls = [given(length * n, angle).on(length_kind(length)) for length in lengths]
    for length, R, call in zip(lengths, student.rotation_matrix.many(calls), calls, strict=True):
        expect(R, turned(n, angle), within=POINTWISE, of="the matrix", at=(n, angle, length), kind=call.kind)


@check(points=1, part="a")
def matrix_refuses_what_is_no_axis(student, draw):
    """rotation_matrix raises ValueError for an axis that is zero or not finite, whatever the angle."""
    angle = draw.uniform(0.5, 3)
    student.on("the z axis").rotation_matrix(Z, 0.0)  # which it must not refuse
    cases = [(axis, angle, kind) for axis, kind in NO_AXES]
    cases += [(axis, 0.0, f"{kind}, no turn") for axis, kind in NO_AXES[:2]]
    for axis, angle, kind in cases:
        expect_that(
            student.on(kind).rotation_matrix.refuses(np.array(axis), angle),
            "rotation_matrix does not raise ValueError",
            kind=kind,
        )


Z = np.array([0.0, 0.0, 1.0])
NO_AXES = (
    ((0.0, 0.0, 0.0), "the zero axis"),
    ((0.0, np.nan, 1.0), "an axis with a NaN"),
    ((np.inf, 0.0, 1.0), "an infinite axis"),
    ((0.0, -np.inf, 0.0), "an axis with minus infinity"),
)


def turned_vectors(student, draw, cases, kind):
    """The student's turned vectors beside the right ones, the case and its kind."""
    vectors = draw.normal(size=(len(cases), 3)) * 10 ** draw.uniform(-2, 2, (len(cases), 1))
    return beside(student, vectors, cases, kind)


def beside(student, vectors, cases, kind):
    """The student's turned vectors beside these vectors, the case and the kind(axis, angle) of it."""
    kinds = [kind(axis, angle) for axis, angle, _ in cases]
    calls = [given(r, axis, angle).on(kind) for r, (axis, angle, _), kind in zip(vectors, cases, kinds, strict=True)]
    return zip(student.rotate.many(calls), vectors, cases, kinds, strict=True)


SHORTENED = suspect(
    "r made a unit vector: its length is lost",
    rotate=lambda r, axis, angle: turned(axis, angle) @ r / (np.linalg.norm(r) or 1.0),
)


@check(points=2, part="a", suspects=[*suspects(WRONG_MATRICES)[1], SHORTENED])
def vector_turns_by_the_right_hand_rule(student, draw):
    """rotate turns r as the matrix would, whatever the axis's length."""
    for r1, r, case, kind in turned_vectors(student, draw, rotations(draw, None), any_kind):
        expect(
            r1,
            case[2] @ r,
            within=POINTWISE,
            scale=np.linalg.norm(r),
            of="the turned vector",
            unit="of its length",
            at=(r, *case),
            kind=kind,
            hint=partial(digits_lost, r1, case[2] @ r),
        )
    plain = plain_turns(draw)
    for r1, r, case, kind in turned_vectors(student, draw, plain, plain_kind):
        expect(
            r1,
            case[2] @ r,
            within=POINTWISE,
            scale=np.linalg.norm(r),
            of="the turned vector",
            unit="of its length",
            at=(r, *case),
            kind=kind,
            hint=partial(not_turned, r1, r),
        )
    along = [-2.0 * axis for axis, *_ in plain]
    for r1, r, case, kind in beside(student, along, plain, lambda axis, angle: "a vector along the axis"):
        expect(
            r1,
            r,
            within=POINTWISE,
            scale=np.linalg.norm(r),
            of="the turned vector",
            unit="of its length",
            at=(r, *case),
            kind=kind,
        )
    nothing = student.on("the zero vector").rotate(np.zeros(3), *plain[1][:2])
    expect(nothing, np.zeros(3), within=POINTWISE, of="the turned vector", kind="the zero vector")


@check(points=1, part="a", after=vector_turns_by_the_right_hand_rule, suspects=suspects(WRONG_WHEN_SMALL, TINY)[1])
def vector_turns_by_every_angle(student, draw):
    """rotate holds for angles from 1e-12 to 1e6 and axes from 1e-100 to 1e100 long."""
    for (angles, within, kind), sign in zip(every_angle(draw), (-1, 1, -1, 1), strict=True):
        length = 10.0 ** (sign * draw.uniform(10, 100))
        cases = [(length * axis, angle, right) for axis, angle, right in rotations(draw, angles)]
        about = f"{kind}, {length_kind(length)}"
        for r1, r, case, _ in turned_vectors(student, draw, cases, lambda axis, angle, about=about: about):
            expect(
                r1,
                case[2] @ r,
                within=within,
                scale=np.linalg.norm(r),
                of="the turned vector",
                unit="of its length",
                at=(r, *case),
                kind=about,
                hint=partial(precision, r1, r, *case),
            )


@check(points=1, part="a")
def rotate_refuses_what_is_no_axis(student, draw):
    """rotate raises ValueError for an axis that is zero or not finite, whatever the angle and the vector."""
    some, nothing, angle = draw.normal(size=3), np.zeros(3), draw.uniform(0.5, 3)
    student.on("the z axis").rotate(some, Z, 0.0)  # which it must not refuse
    cases = [(some, axis, angle, kind) for axis, kind in NO_AXES]
    for axis, kind in NO_AXES[:2]:
        cases += [(some, axis, 0.0, f"{kind}, no turn"), (nothing, axis, angle, f"{kind}, the zero vector")]
    for r, axis, angle, kind in cases:
        expect_that(
            student.on(kind).rotate.refuses(r, np.array(axis), angle), "rotate does not raise ValueError", kind=kind
        )
