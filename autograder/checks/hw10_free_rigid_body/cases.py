"""Hidden inputs of hw10: bodies of any size, wheels, spins about axes, motions on both sides of the separatrix."""

import math
from itertools import product

import numpy as np

from tam570_grader import given, in_turn, uneven

from . import right


def a_body(draw):
    """Inertias in any order, each less than the sum of the other two, of any size."""
    spread = draw.permutation(draw.uniform((0.1, 0.4, 0.8), (0.25, 0.6, 1)))
    return (spread.sum() - spread) * 10 ** draw.uniform(-2, 2)


def a_wheel(draw):
    """A = B, and C from a rod's to that of a disk."""
    A = 10 ** draw.uniform(-2, 2)
    return np.array([A, A, A * draw.choice([draw.uniform(0.2, 0.7), draw.uniform(1.3, 1.9)])])


def an_omega(draw):
    """No component is small, and the size is between .5 and 6 rad/s."""
    return draw.uniform(0.4, 1, 3) * draw.choice([-1, 1], 3) * 10 ** draw.uniform(0, 0.5)


def a_fast_omega(draw):
    """At 15 to 18 rad/s: steps of a millisecond follow it, those of ten do not."""
    omega = an_omega(draw)
    return omega * draw.uniform(15, 18) / np.linalg.norm(omega)


OMEGAS = ("omega zero", "omega along a principal axis", "omega in a principal plane", "omega of one sign")


def plain_omegas(draw):
    """(omega, kind): spins about each axis both ways, with one zero, without one but of one sign, and none."""
    size = np.abs(an_omega(draw))
    ways = [sign * size * some + 0.0 for some in np.ndindex(2, 2, 2) for sign in (1, -1)]  # no zero has a sign
    return [(omega, OMEGAS[np.count_nonzero(omega)]) for omega in ways]


def an_attitude(draw):
    return right.turned(draw.uniform(0.4, 1.2, 3) * draw.choice([-1, 1], 3))


def attitudes(draw):
    """(R, kind): a random one, and the body's axes along those of space, after a quarter turn and a half turn, too."""
    axis, turns = draw.permutation(np.eye(3))[0], {"R = I": 0, "R of a quarter turn": 1, "R of a half turn": 2}
    plain = [(np.round(right.turned(turn * math.pi / 2 * axis)) + 0.0, kind) for kind, turn in turns.items()]
    return [(an_attitude(draw), "a random R"), *plain]


def turning(draw):
    """(omega, inertia=...)"""
    A, k = 2.0 ** draw.integers(-1, 2), draw.uniform(0.5, 2)  # H is along omega to the last digit where all are A
    near = 1 + draw.choice([-1, 1]) * draw.uniform(2e-6, 8e-6)  # less from 1 than isclose and allclose see
    bodies = [(a_body(draw), "a random body and omega") for _ in range(12)]
    bodies += [(a_wheel(draw), "a body with A = B") for _ in range(4)]
    bodies += [(np.array([A, A, A]), "three equal inertias"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(np.roll([1.0, near, 1.6], i), "two inertias that are equal to five digits, no more") for i in range(3)]
    calls = [(body, an_omega(draw), kind) for body, kind in bodies]
    calls += [(body, *omega) for body in (a_body(draw), np.array([2.0, 1.0, 2.0])) for omega in plain_omegas(draw)]
    return [given(omega, inertia=body).on(kind) for body, omega, kind in calls]


def turning_in_space(draw):
    """(R, omega, inertia=...)"""
    for case in turning(draw):
        for R, way in attitudes(draw):
            yield case.behind(R).on(f"{case.kind}, {way}")


def euler_angles(draw):
    """For euler_rates_313: theta of any sign, and a right angle."""
    thetas = [("theta from 0 to pi", 0.3, 2.8), ("a negative theta", -2.8, -0.3), ("theta from pi to 2 pi", 3.5, 5.9)]
    some = [(draw.uniform((-4, low, -4), (4, high, 4)), an_omega(draw), kind) for kind, low, high in thetas * 5]
    quarters = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    some += [(turns, omega, f"theta a right angle, {way}") for turns in quarters for omega, way in plain_omegas(draw)]
    return [given(angles, omega).on(kind) for angles, omega, kind in some]


def undetermined(draw):
    """First angles with rates, where psi' is large, then angles next to them without rates."""
    omega, psi = an_omega(draw), draw.uniform(-3, 3)
    phi = math.atan2(omega[0], omega[1]) + draw.uniform(-1, 1)  # half and more of p and q is psi' sin(theta)
    thetas = [(theta, "sin theta small, but not below 1e-12") for theta in (1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8)]
    thetas += [(0.0, "theta = 0"), (math.pi, "theta = pi"), (-math.pi, "theta = -pi"), (7e-13, "theta next to 0")]
    return [given(np.array([psi, theta, phi]), omega).on(kind) for theta, kind in thetas]


def moving(draw, kind, body, omega, radians, count=25, side=0, R=None):
    """A motion over so many radians at uneven times, which begin on this side of t = 0."""
    start = (side or draw.choice([-1, 1])) * draw.uniform(0.5, 3)
    t = uneven(draw, radians / (np.linalg.norm(omega) or 1.0), count, start)
    return given(t, an_attitude(draw) if R is None else R, omega, inertia=body).on(kind)


def tumbling(draw, kind, way):
    """For tumble_period; (1, q, 1) is a way on the separatrix."""
    A, B, C = body = np.sort(a_body(draw))
    omega = way * draw.uniform(0.5, 1.5) * B / np.sqrt([A * (B - A), B * B, C * (C - B)])
    return given(omega, inertia=body).on(kind)


def round_last(draw):
    """A way well on the one side of the separatrix; backwards it is on the other."""
    return draw.uniform((0.2, 0.4, 1), (0.7, 2, 1)) * draw.choice([-1, 1], 3)


def tumbles(draw):
    """Motions on both sides of the separatrix and near it, of inertias in any order; there each is the middle once."""
    for kind, way, radians, side, orders in (
        ("omega round the last axis, t[0] > 0", round_last(draw), 14, 1, 1),
        ("omega round the first axis, t[0] < 0", round_last(draw)[::-1], 14, -1, 1),
        ("omega near the middle axis, t[0] > 0", draw.uniform((0, 1, 0.008), (0.002, 1, 0.012)), 25, 1, 3),
    ):
        places, case = draw.permutation(3), tumbling(draw, kind, way)
        for order in (np.roll(places, k) for k in range(orders)):
            yield moving(draw, kind, case.kwargs["inertia"][order], case.args[0][order], radians, side=side)


def general_motions(draw):
    kinds = {"a general motion, t[0] > 0": 1, "a general motion, t[0] < 0": -1}
    return [moving(draw, kind, a_body(draw), an_omega(draw), 12, side=side) for kind, side in kinds.items()]


def many_turns(draw):
    return [moving(draw, "many fast turns", a_body(draw), a_fast_omega(draw), 45, 12)]


ON_SEPARATRIX = np.array([[3.0, 4.0, 6.0], [2.0, 1.0, -1.0]])  # inertia, omega: 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2
FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


def special_motions(draw):
    """Equal inertias or nothing to turn, spins about axes, two times alone, starts at half turns."""
    ball, size = np.full(3, 10 ** draw.uniform(-2, 2)), 10 ** draw.uniform(-2, 2)
    calls = [
        moving(draw, "a body with A = B", a_wheel(draw), an_omega(draw), 10),
        moving(draw, "a flat disk", size * np.array([1.0, 1.0, 2.0]), an_omega(draw), 10),
        moving(draw, "three equal inertias", ball, an_omega(draw), 10),
        moving(draw, "a wheel at rest", a_wheel(draw), np.zeros(3), 10),
        moving(draw, "two times, R = I at the start", a_wheel(draw), an_omega(draw), 5, 2, R=np.eye(3)),
        moving(draw, FAST_AND_FAR, a_wheel(draw), a_fast_omega(draw), 40, 2),
    ]
    # of half turns the trace is -1: a quaternion that is made by a division by its scalar part has none there
    for about, n in {"x": [1, 0, 0], "y": [0, 1, 0], "(1, 2, 2)": [1, 2, 2]}.items():
        half, kind = 2 * np.outer(n, n) / np.dot(n, n) - np.eye(3), f"a start half a turn about {about}"
        calls.append(moving(draw, f"{kind} from the axes of space", a_wheel(draw), an_omega(draw), 4, 4, R=half))
    for axis in (0, 1, 2):
        omega = draw.choice([-1, 1]) * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0
        calls.append(moving(draw, f"spin about the principal axis {axis}", a_body(draw), omega, 4))
        body, omega = np.roll(ON_SEPARATRIX, axis, axis=1)
        calls.append(moving(draw, f"omega on the separatrix, the middle axis {(axis + 1) % 3}", body, omega, 8))
    again = moving(draw, "", a_wheel(draw), an_omega(draw), 5, 4)
    return calls + in_turn(draw, again, start=(an_attitude(draw), an_omega(draw)), inertia=a_wheel(draw))


def wheels(draw):
    """(omega, inertia=...) with A = B"""
    kind = "a random body with A = B"
    omegas = [(an_omega(draw), kind) for _ in range(8)] + [(an_omega(draw) * [0.01, 0.01, 1], kind) for _ in range(4)]
    return [given(omega, inertia=a_wheel(draw)).on(kind) for omega, kind in omegas + plain_omegas(draw)]


def wobbling(draw):
    """For wobble_rate; about the symmetry axis alone nothing wobbles."""
    return [case for case in wheels(draw) if case.args[0][:2].any()]


def precessing(draw):
    """For symmetric_solution: (t, omega, inertia=...), of two times, too."""
    calls = [*wheels(draw), given(an_omega(draw), inertia=np.full(3, draw.uniform(0.1, 10))).on("three equal inertias")]
    for case in calls:
        t = uneven(draw, 40 / (np.linalg.norm(case.args[0]) or 1.0), 25)
        yield case.behind(t)
        yield case.behind(t[[0, 5]]).on(f"two times, {case.kind}")


WAYS = {1: "", -1: ", at a negative rate"}


def spins(draw):
    """For growth_rate_squared: each axis, both ways."""
    for axis, (sign, way) in product((0, 1, 2), WAYS.items()):
        bodies = [(body(draw), f"a spin about axis {axis}{way}") for body in (a_body, a_body, a_body, a_wheel)]
        for body, kind in [*bodies, (np.full(3, draw.uniform(0.5, 2)), "three equal inertias")]:
            yield given(axis, sign * draw.uniform(1.5, 6), inertia=body).on(kind)
        yield given(axis, 0.0, inertia=a_body(draw)).on("no spin")


def on_side(draw, kind, sign):
    """1: round the axis of the largest inertia, -1: of the smallest; in principal planes, too, and of a tiny body."""
    calls = [tumbling(draw, kind, round_last(draw)[::sign]) for _ in range(6)]
    planes = np.array([(0.5, 0, 1), (-0.5, 0, 1), (0, 1, -1), (0, -1, -1)])[:, ::sign]
    calls += [tumbling(draw, f"{kind}, in a principal plane", way) for way in planes]
    return [*calls, calls[0].but(inertia=1e-6 * calls[0].kwargs["inertia"]).on(f"{kind}, a tiny body")]


def pure_spins(draw):
    for axis, (sign, way) in product((0, 2), WAYS.items()):
        yield tumbling(draw, f"pure spin about axis {axis}{way}", sign * np.eye(3)[axis] + 0.0)


def near_separatrix(draw):
    """Next to it C (C - B) r^2 = (1 + distance) A (B - A) p^2.

    At 1e-6, k by energy and H^2 gives the period to 4e-10, events of solve_ivp at 1e-9 give it to 4e-7 (RK45).
    """
    for way in np.array([(0, 1, 2e-5), (0, 1, -1e-3), (-2e-5, -1, 0), (1e-3, -1, 0)]):
        yield tumbling(draw, "omega almost about the middle axis", way)
    for distance in (1e-2, -1e-2, 1e-4, -1e-4, 1e-6, -1e-6):
        way = draw.choice([-1, 1], 3) * [1, draw.uniform(0.8, 2), math.sqrt(1 + distance)]
        yield tumbling(draw, "omega next to the separatrix, not about the middle axis", way)


def on_separatrix(draw):
    """Times powers of two: without any rounding, too."""
    body, omega = ON_SEPARATRIX * np.array([[2.0 ** draw.integers(-5, 6)], [0.25 * draw.integers(1, 9)]])
    ways = {"pure spin about the middle axis": omega * [0, 1, 0], "omega on the separatrix": omega}
    return [given(way, inertia=body).on(kind) for kind, way in ways.items()]


def boxes(draw):
    for R, kind in [(an_attitude(draw), "a random R"), (an_attitude(draw), "a random R"), *attitudes(draw)]:
        yield R, draw.permutation(10 ** draw.uniform(-1, 1) * np.array([1, 1.7, 2.9])), f"a box, {kind}"
    yield an_attitude(draw), np.full(3, 10 ** draw.uniform(-1, 1)), "a cube"


def pictures(draw):
    """A disk near its spin axis, from any attitude and lying flat, and a body with three inertias; 401 times."""
    disk, tilted = np.array([1.0, 1.0, 2.0]), np.array([*draw.uniform(0.1, 0.2, 2), 1.0])
    flat = "a disk that lies flat, near its spin axis, t[0] not 0"
    for kind, body, way in (
        ("a disk near its spin axis, t[0] not 0", disk, tilted),
        ("a body with three different inertias, t[0] not 0", np.array([1.0, 1.7, 2.2]), np.array([0.5, -0.7, 0.5])),
        (flat, disk, tilted),
    ):
        spin, start, inertia = draw.uniform(1, 4), draw.uniform(-2, 2), body * 10 ** draw.uniform(-2, 2)
        t = np.linspace(start, start + draw.uniform(4, 6) / spin, 401)
        R = yawed(draw.uniform(0, 2 * math.pi)) if kind == flat else an_attitude(draw)
        yield given(t, R, spin * way, inertia=inertia, radius=10 ** draw.uniform(-1, 1)).on(kind)


def yawed(angle):
    """R about space z."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
