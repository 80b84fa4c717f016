"""Hidden inputs of hw09: turns, sequences, rotations of any angle, and matrices that are none."""

import itertools
import math

import numpy as np

from tam570_grader import given

from .right import axis_rotation, turned

QUARTERS = {0: "no turn", 1: "a quarter turn", 2: "a half turn", 4: "a whole turn"}
# the order counts in all of them
ORDERS = "xyz", "zxz", "yxyz", "zyxzy", "xzyxzy", "yz", "zxyxzzyxyxyz", "xxyyz"
IN_PLANES = [np.roll([0.0, 0.6, way], k) for k in range(3) for way in (-0.8, 0.8)]
ALONG = [*np.eye(3), *-np.eye(3)]
FEW_LOST = 1.2e-3, 2e-3, 3.5e-3, 6e-3  # rad; an arccos is off by 3e-12 to 8e-11 of them
# of two axes each: two columns, or two rows, of what they make of a rotation are not perpendicular, and no others
SHEARS = np.eye(3) + 1e-5 * np.array([np.outer(e, f) + np.outer(f, e) for e, f in itertools.combinations(np.eye(3), 2)])


def turns(draw):
    """About x, y and z: random angles, and quarter turns."""
    for axis in "xyz":
        yield from [given(axis, angle).on(f"a turn about {axis}") for angle in draw.uniform(-7, 7, 5)]
        for k in (0, 1, -1, 2, -2, 4):
            yield given(axis, k * math.pi / 2).on(f"{QUARTERS[abs(k)]} about {axis}")


def no_axes(draw):
    """First x, which is one."""
    angle, names = draw.uniform(0.5, 3), ("x", "w", "X", "xy", "yz", "", "-x", "x ", "1")
    return [given(axis, angle).on(f'the string "{axis}"') for axis in names]


def sequences(draw):
    """Two to twelve steps each, and quarter turns."""
    steps = [list(zip(order, draw.uniform(-4, 4, len(order)).tolist(), strict=True)) for order in ORDERS]
    quarters = [list(zip("zyxyz", (1, 0, 1, -1, 2), strict=True)), list(zip("xyz", (-1, 1, 0), strict=True))]
    plain = [given([(axis, k * math.pi / 2) for axis, k in one]).on("a sequence of quarter turns") for one in quarters]
    return [given(one).on(f"a sequence of {len(one)} turns") for one in steps] + plain


def few_steps(draw):
    step = str(draw.choice(list("xyz"))), draw.uniform(0.5, 3)
    return [given([step]).on("a single turn"), given([]).on("no turns at all")]


def unit_axis(draw):
    """All components count: the smallest is a tenth at least."""
    v = draw.uniform(0.3, 1, 3) * draw.choice([-1, 1], 3)
    return v / np.linalg.norm(v)


def rotation(draw):
    return turned(unit_axis(draw), draw.uniform(0.5, 2.5))


def place(n):
    return ("", "along a coordinate axis", "in a coordinate plane", "of any direction")[np.count_nonzero(n)]


def matrices(pairs, kind):
    return [given(turned(n, angle)).on(kind) for n, angle in pairs]


def generic(draw):
    """Angles from .3 to 2.8, where arccos of the trace and R - R^T over 2 sin th lose 1e-14 at most."""
    pairs = [(unit_axis(draw), draw.uniform(0.3, 2.8)) for _ in range(20)]
    pairs += [(np.array(v) / math.sqrt(3), 2 * math.pi / 3) for v in ((1, -1, 1), (1, 1, 1))]
    yield from matrices(pairs, "an axis and angle far from special ones")
    yield from matrices([(n, math.pi / 2) for n in ALONG], "a quarter turn about a coordinate axis")
    for n in (*ALONG, *IN_PLANES, *(-n for n in IN_PLANES)):
        yield from matrices([(n, angle) for angle in (0.3, 1.0, 2.0, 2.8)], f"an axis {place(n)}")


def distances(draw):
    """From the special angles, rad, the largest first: there an arccos is not yet that of the special angle."""
    return sorted([*draw.uniform(0.05, 0.3, 3), 1e-8, 1e-9, 1e-12, *10 ** draw.uniform(-12, -2, 9)], reverse=True)


def small(draw):
    pairs = [(unit_axis(draw), angle) for angle in (*FEW_LOST, *distances(draw))]
    return matrices(pairs + [(n, angle) for n in ALONG for angle in (1e-9, 1e-3)], "a small angle")


def near_pi(draw):
    return matrices([(unit_axis(draw), math.pi - distance) for distance in distances(draw)], "an angle near pi")


def near_quarters(draw):
    """The sine is flat there: an arcsine of it loses half of the digits."""
    pairs = [(unit_axis(draw), math.pi / 2 + more) for more in (0.0, 1e-8, -1e-8)]
    return matrices(pairs, "a quarter turn, or nearly one, about an axis of any direction")


def small_components(draw):
    for k in range(3):
        n = unit_axis(draw)
        n[k] = 10 ** draw.uniform(-7, -5) * draw.choice([-1, 1])
        pair = n / np.linalg.norm(n), math.pi - 10 ** draw.uniform(-9, -3)
        yield from matrices([pair], "an angle near pi, a component of the axis near 0")
    for n in (*ALONG, *IN_PLANES):
        pairs = [(n, math.pi - distance) for distance in (1e-9, 1e-3)]
        yield from matrices(pairs, f"an angle near pi, an axis {place(n)}")


def half_turns(draw):
    axes = [*(unit_axis(draw) for _ in range(8)), *np.eye(3), *IN_PLANES]
    return [given(2 * np.outer(n, n) - np.eye(3)).on(f"a half turn about an axis {place(n)}") for n in axes]


def off_by(R, draw, defect):
    """R sheared: max abs(R^T R - I) is `defect`, and that of R R^T - I, which some take, within a tenth of it."""
    while True:
        shear = draw.uniform(-1, 1, (3, 3))
        shear = (shear + shear.T) * (1 - np.eye(3))
        ours, theirs = np.abs(shear).max(), np.abs(R @ shear @ R.T).max()
        if abs(theirs / ours - 1) < 0.1:
            return R @ (np.eye(3) + 0.5 * defect / ours * shear)


def nearly_rotations(draw):
    R = rotation(draw)
    matrix = given(off_by(R, draw, 7e-7)).on("a matrix with R^T R off by 7e-7")
    return [matrix, given((1 + 4.5e-7) * R).on("a rotation times 1 + 4.5e-7")]


def no_rotations(draw):
    R, noise = rotation(draw), draw.uniform(0.3, 1, (3, 3)) * draw.choice([-1, 1], (3, 3))
    holed, infinite = R.copy(), R.copy()
    holed[0, 1], infinite[2, 0] = np.nan, np.inf
    pairs = [
        ("a reflection", -R),
        ("a reflection", R @ np.diag([1.0, 1.0, -1.0])),
        # R^T R is off by what is allowed, the determinant, near -1, by more than a rounding
        ("a reflection times 1 + 4e-7", (1 + 4e-7) * -R),
        ("a reflection times 1 - 4e-7", (1 - 4e-7) * R @ np.diag([1.0, -1.0, 1.0])),
        ("a rotation times 1.1", 1.1 * R),
        ("a rotation times 1.00001", (1 + 1e-5) * R),
        *(("a rotation with a shear of 1e-5", R @ sheared) for sheared in SHEARS),
        *(("a shear of 1e-5 after a rotation", sheared @ R) for sheared in SHEARS),
        ("a matrix with R^T R off by 1.5e-6", off_by(R, draw, 1.5e-6)),
        ("a matrix of random numbers", noise),
        ("the zero matrix", np.zeros((3, 3))),
        ("a matrix with a NaN", holed),
        ("a matrix with an infinite element", infinite),
        *identities_but_for_infinity(draw),
    ]
    return [given(matrix).on(kind) for kind, matrix in pairs]


def stretched_along_z(draw):
    """R^T R and R R^T have the same one element off, 1.000005."""
    R = axis_rotation("z", draw.uniform(0.5, 2.5)) @ np.diag([1.0, 1.0, 1 + 2.5e-6])
    return [given(R).on("a matrix with R^T R off by 5e-6 on the diagonal")]


def identities_but_for_infinity(draw):
    """Zeros times infinity are NaN, and no comparison with NaN is true."""
    i, j = draw.permutation(3)[:2]
    for k, size in itertools.product((i, j), (np.inf, -np.inf)):
        R = np.eye(3)
        R[i, k] = size
        yield f"the identity, but for {size} {'on' if k == i else 'off'} the diagonal", R


def books(draw):
    """(R, size, kind) of boxes."""
    sizes = [draw.permutation(10 ** draw.uniform(-1, 1) * np.array([1, 1.7, 2.9])) for _ in range(6)]
    yield from [(rotation(draw), size, "a random rotation and size") for size in sizes[:4]]
    yield np.eye(3), sizes[4], "a book that is not turned"
    yield axis_rotation(draw.choice(list("xyz")), math.pi / 2), sizes[5], "a quarter turn"
    yield rotation(draw), np.full(3, sizes[0][0]), "a cube"
