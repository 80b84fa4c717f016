"""Hidden checks of hw08.

What is right is built another way than by the formula: by turning a frame that has the axis as third vector.
"""

import numpy as np

from tam570_grader import array, check, expect, expect_that, given, once, suspect

RESULTS = {"skew": array(3, 3), "rotation_matrix": array(3, 3), "rotate": array(3)}
NEEDS = ("numpy",)
OFF_LIMITS = {"*": ("scipy.spatial.transform", "tam570.rotations")}

POINTWISE = (
    1e-12  # a few roundings of numbers of size 1 make 1e-15; quaternions and products of matrices, 1e-14
)
HUGE_ANGLE = 1e-9  # 1e6 rad, reduced modulo 2 pi by hand, is off by 1e6 eps = 2e-10


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


def by_formula(n, angle):
    """The formula with whatever vector it is given for the unit vector."""
    cross = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * np.outer(n, n) + np.sin(angle) * cross


def rotated(matrix):
    """`rotate` as the product with a matrix of axis and angle."""
    return lambda r, axis, angle: matrix(axis, angle) @ r


WRONG_MATRICES = {
    "the transpose, the rotation the other way (look at the sign of the sin th term)": transposed,
    "the angle taken for degrees": in_degrees,
    "the axis not made a unit vector": by_formula,
}
MATRIX_SUSPECTS = [suspect(says, rotation_matrix=wrong) for says, wrong in WRONG_MATRICES.items()]
ROTATE_SUSPECTS = [suspect(says, rotate=rotated(wrong)) for says, wrong in WRONG_MATRICES.items()]


@once
def rotations(draw, angles):
    """Axes of lengths from .1 to 10, some in coordinate planes and one on an axis, angles, and the right matrices."""
    angles = draw.uniform(-4 * np.pi, 4 * np.pi, 15) if angles is None else angles
    axes = draw.normal(size=(len(angles), 3)) * 10 ** draw.uniform(-1, 1, (len(angles), 1))
    axes[::3, draw.integers(3)] = 0.0
    axes[0] = np.roll([axes[0, 0] + axes[0, 1], 0.0, 0.0], draw.integers(3))
    return [(axis, angle, turned(axis, angle)) for axis, angle in zip(axes, angles, strict=True)]


PLAIN = "no turn, a quarter or a half turn, about a coordinate axis or a diagonal"


@once
def plain_turns(draw):
    """No turn, quarter, half and whole turns about axes of whole numbers, and the right matrices."""
    ways = [*np.eye(3), *-np.eye(3), np.array([1.0, 0.0, -1.0]), np.array([-1.0, -1.0, -1.0])]
    turns = np.array([0.0, 0.5, 1.0, -0.5, -1.0, 2.0]) * np.pi
    cases = [(draw.integers(1, 4) * way, angle) for way in ways for angle in turns]
    return [(axis, angle, turned(axis, angle)) for axis, angle in cases]


def matrices(student, cases):
    """The student's matrices beside the cases."""
    return zip(
        student.rotation_matrix.many([given(axis, angle) for axis, angle, _ in cases]), cases, strict=True
    )


@check(points=1, part="a", suspects=[suspect("the transpose, r x v", skew=lambda v: np.cross(v, np.eye(3)))])
def skew_is_the_cross_product(student, draw):
    """skew(v) r = v x r, for any v and r."""
    vectors = [*(draw.normal(size=(8, 3)) * 10 ** draw.uniform(-3, 3, (8, 1))), *-np.eye(3), np.zeros(3)]
    for v, matrix in zip(vectors, student.skew.many([given(v) for v in vectors]), strict=True):
        r = draw.normal(size=3)
        expect(matrix @ r, np.cross(v, r), within=POINTWISE, scale=np.linalg.norm(v) or 1.0, of="skew(v) r",
               unit="of the length of v", at=(v, r),
               kind="random vectors" if v.all() else "a v with zeros in it")  # fmt: skip


@check(points=2, part="a", suspects=MATRIX_SUSPECTS)
def matrix_turns_by_the_right_hand_rule(student, draw):
    """rotation_matrix turns by the angle about the axis, right-handed, whatever the axis's length."""
    for R, case in matrices(student, rotations(draw, None)):
        expect(R, case[2], within=POINTWISE, of="the matrix", at=case, kind="a random axis and angle",
               hint="try a quarter turn about z, and an axis twice as long")  # fmt: skip
    for R, case in matrices(student, plain_turns(draw)):
        expect(R, case[2], within=POINTWISE, of="the matrix", at=case, kind=PLAIN,
               hint="where do the coordinate axes go?")  # fmt: skip


@check(points=1, part="a", after=matrix_turns_by_the_right_hand_rule)
def matrix_holds_for_every_angle(student, draw):
    """An angle of 1e-12 turns by 1e-12, one of 1e6 by 1e6; R^T R = I and det R = 1 for all of them."""
    for angles, within in every_angle(draw):
        for R, case in matrices(student, rotations(draw, angles)):
            expect(R, case[2], within=within, of="the matrix", at=case, kind="a very small or very large angle",
                   hint="look at what each term becomes there")  # fmt: skip
            expect(R.T @ R, np.eye(3), within=POINTWISE, of="R^T R", at=case, kind="angles from 1e-12 to 1e6")
            expect(
                np.linalg.det(R), 1.0, within=POINTWISE, of="det R", at=case, kind="angles from 1e-12 to 1e6"
            )


def every_angle(draw):
    """Angles by size, and how near to right the matrix must be."""
    signs = draw.choice([-1, 1], 4)
    yield (
        (-1e-12, 1e-12, -1e-9, 1e-9),
        1e-14,
    )  # the rounding of the cosine; a tiny angle taken for 0 is off by 1e-12
    yield tuple(10 ** draw.uniform(-8, 0, 4) * signs), POINTWISE
    yield (np.pi - 1e-9, 1e-9 - np.pi, 2 * np.pi), POINTWISE
    yield tuple(10 ** draw.uniform(2, 6, 4) * signs), HUGE_ANGLE


@check(points=1, part="a", after=matrix_turns_by_the_right_hand_rule)
def matrix_depends_on_the_direction_alone(student, draw):
    """Axes of length 1e-100 or 1e100 give the same matrix as the unit axis."""
    n, angle = draw.normal(size=3), draw.uniform(0.5, 3)
    lengths = 10.0 ** draw.uniform(-100, 100, 4)  # beyond 1e150 the square of a length overflows
    for length, R in zip(
        lengths, student.rotation_matrix.many([given(k * n, angle) for k in lengths]), strict=True
    ):
        expect(R, turned(n, angle), within=POINTWISE, of="the matrix", at=(n, angle, length),
               kind="a very long or very short axis")  # fmt: skip


@check(points=1, part="a", after=matrix_turns_by_the_right_hand_rule)
def matrix_refuses_what_is_no_axis(student, draw):
    """rotation_matrix raises ValueError for an axis that is zero or not finite."""
    angle = draw.uniform(0.5, 3)
    for axis, kind in NO_AXES:
        expect_that(student.rotation_matrix.refuses(np.array(axis), angle),
                    "rotation_matrix does not raise ValueError", kind=kind)  # fmt: skip


NO_AXES = (
    ((0.0, 0.0, 0.0), "the zero axis"),
    ((0.0, np.nan, 1.0), "an axis with a NaN"),
    ((np.inf, 0.0, 1.0), "an infinite axis"),
    ((0.0, -np.inf, 0.0), "an axis with minus infinity"),
)


def turned_vectors(student, draw, cases):
    """The student's turned vectors beside the right ones and the case."""
    return beside(
        student, draw.normal(size=(len(cases), 3)) * 10 ** draw.uniform(-2, 2, (len(cases), 1)), cases
    )


def beside(student, vectors, cases):
    """The student's turned vectors beside these vectors and the case."""
    calls = [given(r, axis, angle) for r, (axis, angle, _) in zip(vectors, cases, strict=True)]
    return zip(student.rotate.many(calls), vectors, cases, strict=True)


@check(points=2, part="a", suspects=ROTATE_SUSPECTS)
def vector_turns_by_the_right_hand_rule(student, draw):
    """rotate turns r as the matrix would, whatever the axis's length."""
    for r1, r, case in turned_vectors(student, draw, rotations(draw, None)):
        expect(r1, case[2] @ r, within=POINTWISE, scale=np.linalg.norm(r), of="the turned vector",
               unit="of its length", at=(r, *case), kind="a random vector, axis and angle")  # fmt: skip
    plain = plain_turns(draw)
    for r1, r, case in turned_vectors(student, draw, plain):
        expect(r1, case[2] @ r, within=POINTWISE, scale=np.linalg.norm(r), of="the turned vector",
               unit="of its length", at=(r, *case), kind=PLAIN)  # fmt: skip
    for r1, r, case in beside(student, [-2.0 * axis for axis, *_ in plain], plain):
        expect(r1, r, within=POINTWISE, scale=np.linalg.norm(r), of="the turned vector", unit="of its length",
               at=(r, *case), kind="a vector along the axis")  # fmt: skip
    expect(student.rotate(np.zeros(3), *plain[1][:2]), np.zeros(3), within=POINTWISE, of="the turned vector",
           kind="the zero vector")  # fmt: skip


@check(points=1, part="a", after=vector_turns_by_the_right_hand_rule)
def vector_turns_by_every_angle(student, draw):
    """rotate holds for angles from 1e-12 to 1e6 and axes from 1e-100 to 1e100 long."""
    for angles, within in every_angle(draw):
        length = 10.0 ** draw.uniform(-100, 100)
        cases = [(length * axis, angle, right) for axis, angle, right in rotations(draw, angles)]
        for r1, r, case in turned_vectors(student, draw, cases):
            expect(r1, case[2] @ r, within=within, scale=np.linalg.norm(r), of="the turned vector",
                   unit="of its length", at=(r, *case), kind="a very small or large angle or axis")  # fmt: skip


@check(points=1, part="a", after=vector_turns_by_the_right_hand_rule)
def rotate_refuses_what_is_no_axis(student, draw):
    """rotate raises ValueError for an axis that is zero or not finite."""
    r, angle = draw.normal(size=3), draw.uniform(0.5, 3)
    for axis, kind in NO_AXES:
        expect_that(
            student.rotate.refuses(r, np.array(axis), angle), "rotate does not raise ValueError", kind=kind
        )
