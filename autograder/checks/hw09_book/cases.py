"""Hidden inputs of hw09: turns, sequences, rotations of any angle, and matrices that are none."""

import itertools
import math

import numpy as np

from tam570_grader import Case

from .reference import axis_rotation, turned

QUARTERS = {0: "no turn", 1: "a quarter turn", 2: "a half turn", 4: "a whole turn"}
# the order matters in all of them
ORDERS = "xyz", "zxz", "yz", "zxyxzzyxyxyz", "xxyyz"
IN_PLANES = [np.roll([0.0, 0.6, way], k) for k in range(3) for way in (-0.8, 0.8)]
ALONG = [*np.eye(3), *-np.eye(3)]
FEW_LOST = 1.2e-3, 2e-3, 3.5e-3, 6e-3  # rad; an arccos has an error of 3e-12 to 8e-11 of them
# each in two axes: only two columns, or two rows, of its product with a rotation are not perpendicular
SHEARS = np.eye(3) + 1e-5 * np.array([np.outer(e, f) + np.outer(f, e) for e, f in itertools.combinations(np.eye(3), 2)])


def turns(rng):
    """Yield turns about x, y and z: random angles, and quarter turns."""
    for axis in "xyz":
        yield from [Case(axis, angle).labelled(f"a turn about {axis}") for angle in rng.uniform((-7, 20), (0, 30))]
        for k in (0, 1, -1, 2, -2, 4):
            yield Case(axis, k * math.pi / 2).labelled(f"{QUARTERS[abs(k)]} about {axis}")


def no_axes(rng):
    """Return x, which is an axis, then strings that are none."""
    angle, names = rng.uniform(0.5, 3), ("x", "w", "X", "xy", "yz", "", "-x", "x ", "1")
    return [Case(axis, angle).labelled(f'the string "{axis}"') for axis in names]


def sequences(rng):
    """Return sequences of two to twelve steps, and of quarter turns."""
    steps = [list(zip(order, rng.uniform(-4, 4, len(order)).tolist(), strict=True)) for order in ORDERS]
    quarters = [list(zip("zyxyz", (1, 0, 1, -1, 2), strict=True)), list(zip("xyz", (-1, 1, 0), strict=True))]
    plain = [
        Case([(axis, k * math.pi / 2) for axis, k in steps]).labelled("a sequence of quarter turns")
        for steps in quarters
    ]
    return [Case(step).labelled(f"a sequence of {len(step)} turns") for step in steps] + plain


def few_steps(rng):
    step = str(rng.choice(list("xyz"))), rng.uniform(0.5, 3)
    return [Case([step]).labelled("a single turn"), Case([]).labelled("no turns at all")]


def unit_axis(rng):
    """Return a unit axis whose components all matter: the smallest is a tenth at least."""
    v = rng.uniform(0.3, 1, 3) * rng.choice([-1, 1], 3)
    return v / np.linalg.norm(v)


def rotation(rng):
    return turned(unit_axis(rng), rng.uniform(0.5, 2.5))


def describe(n):
    return ("", "along a coordinate axis", "in a coordinate plane", "of any direction")[np.count_nonzero(n)]


def matrices(pairs, label):
    return [Case(turned(n, angle)).labelled(label) for n, angle in pairs]


def generic(rng):
    """Yield angles from .3 to 2.8, where arccos of the trace and R - R^T over 2 sin th have errors of 1e-14 at most."""
    pairs = [(unit_axis(rng), rng.uniform(0.3, 2.8)) for _ in range(3)]
    pairs += [(np.array(v) / math.sqrt(3), 2 * math.pi / 3) for v in ((1, -1, 1), (1, 1, 1))]
    yield from matrices(pairs, "an axis and angle far from special ones")
    yield from matrices([(n, math.pi / 2) for n in ALONG], "a quarter turn about a coordinate axis")
    axes = *ALONG, *IN_PLANES, *(-n for n in IN_PLANES)
    for n, angle in zip(axes, itertools.cycle((0.3, 1.0, 2.0, 2.8)), strict=False):
        yield from matrices([(n, angle)], f"an axis {describe(n)}")


def distances(rng):
    """Return distances from the special angles, rad; the first is so large that an arccos does not round it away."""
    distances = rng.uniform(0.05, 0.3), 1e-8, 1e-9, 1e-12, *10 ** rng.uniform((-12, -9, -7, -4), (-9, -7, -4, -2))
    return sorted(distances, reverse=True)


def small(rng):
    pairs = [(unit_axis(rng), angle) for angle in (*FEW_LOST, *distances(rng))]
    return matrices(pairs + [*zip(ALONG, itertools.cycle((1e-9, 1e-3)), strict=False)], "a small angle")


def near_pi(rng):
    return matrices([(unit_axis(rng), math.pi - distance) for distance in distances(rng)], "an angle near pi")


def near_quarters(rng):
    """Return angles at which the sine is flat: its arcsine loses half of the digits."""
    pairs = [(unit_axis(rng), math.pi / 2 + more) for more in (0.0, 1e-8, -1e-8)]
    return matrices(pairs, "a quarter turn, or nearly one, about an axis of any direction")


def small_components(rng):
    for k in range(3):
        n = unit_axis(rng)
        n[k] = 10 ** rng.uniform(-7, -5) * rng.choice([-1, 1])
        pair = n / np.linalg.norm(n), math.pi - 10 ** rng.uniform(-9, -3)
        yield from matrices([pair], "an angle near pi, a component of the axis near 0")
    for n, distance in zip((*ALONG, *IN_PLANES), itertools.cycle((1e-9, 1e-3)), strict=False):
        yield from matrices([(n, math.pi - distance)], f"an angle near pi, an axis {describe(n)}")


def half_turns(rng):
    lopsided = rng.permutation([3.0, -2.0, -2.0]) / math.sqrt(17)  # the sum has another sign than the largest component
    axes = [*(unit_axis(rng) for _ in range(3)), lopsided, *np.eye(3), *IN_PLANES]
    return [Case(2 * np.outer(n, n) - np.eye(3)).labelled(f"a half turn about an axis {describe(n)}") for n in axes]


def off_by(R, rng, defect):
    """Return R sheared: max abs(R^T R - I) is `defect`, that of R R^T - I, which some use, within a tenth of it."""
    while True:
        shear = rng.uniform(-1, 1, (3, 3))
        shear = (shear + shear.T) * (1 - np.eye(3))
        ours, theirs = np.abs(shear).max(), np.abs(R @ shear @ R.T).max()
        if abs(theirs / ours - 1) < 0.1:
            return R @ (np.eye(3) + 0.5 * defect / ours * shear)


def nearly_rotations(rng):
    R = rotation(rng)
    matrix = Case(off_by(R, rng, 7e-7)).labelled("a matrix with R^T R off by 7e-7")
    return [matrix, Case((1 + 4.5e-7) * R).labelled("a rotation times 1 + 4.5e-7")]


def no_rotations(rng):
    R, noise = rotation(rng), rng.uniform(0.3, 1, (3, 3)) * rng.choice([-1, 1], (3, 3))
    holed, infinite = R.copy(), R.copy()
    holed[0, 1], infinite[2, 0] = np.nan, np.inf
    pairs = [
        ("a reflection", -R),
        ("a reflection", R @ np.diag([1.0, 1.0, -1.0])),
        # the error of R^T R is allowed, the determinant, near -1, differs by more than rounding
        ("a reflection times 1 + 4e-7", (1 + 4e-7) * -R),
        ("a reflection times 1 - 4e-7", (1 - 4e-7) * R @ np.diag([1.0, -1.0, 1.0])),
        ("a rotation times 1.1", 1.1 * R),
        ("a rotation times 1.00001", (1 + 1e-5) * R),
        *(("a rotation with a shear of 1e-5", R @ sheared) for sheared in SHEARS),
        *(("a shear of 1e-5 after a rotation", sheared @ R) for sheared in SHEARS),
        ("a matrix with R^T R off by 1.5e-6", off_by(R, rng, 1.5e-6)),
        ("a matrix of random numbers", noise),
        ("the zero matrix", np.zeros((3, 3))),
        ("a matrix with a NaN", holed),
        ("a matrix with an infinite element", infinite),
        *identities_but_for_infinity(rng),
    ]
    return [Case(matrix).labelled(label) for label, matrix in pairs]


def stretched_along_z(rng):
    """Return a matrix for which R^T R and R R^T differ from I in one and the same element, 1.000005."""
    R = axis_rotation("z", rng.uniform(0.5, 2.5)) @ np.diag([1.0, 1.0, 1 + 2.5e-6])
    return [Case(R).labelled("a matrix with R^T R off by 5e-6 on the diagonal")]


def identities_but_for_infinity(rng):
    """Yield identities with an infinite element: zero times infinity is NaN, for which all comparisons are false."""
    i, j = rng.permutation(3)[:2]
    for k, size in itertools.product((i, j), (np.inf, -np.inf)):
        R = np.eye(3)
        R[i, k] = size
        yield f"the identity, but for {size} {'on' if k == i else 'off'} the diagonal", R


def books(rng):
    """Yield (R, size, label) of boxes."""
    sizes = [rng.permutation(10 ** rng.uniform(-1, 1) * np.array([1, 1.7, 2.9])) for _ in range(4)]
    yield from [(rotation(rng), size, "a random rotation and size") for size in sizes[:2]]
    yield np.eye(3), sizes[2], "a book that is not turned"
    yield axis_rotation(rng.choice(list("xyz")), math.pi / 2), sizes[3], "a quarter turn"
    yield rotation(rng), np.full(3, sizes[0][0]), "a cube"
