"""Hidden inputs of hw10: bodies of any size, wheels, spins about axes, motions on both sides of the separatrix."""

import math
from itertools import product

import numpy as np

from tam570_grader import given, in_turn, uneven

from . import right


def a_body(draw):
    """Inertias in any order, each less than the sum of the other two, of any size."""
    spread = draw.permutation([draw.uniform(0.1, 0.25), draw.uniform(0.4, 0.6), draw.uniform(0.8, 1)])
    return (spread.sum() - spread) * 10 ** draw.uniform(-2, 2)


def a_wheel(draw):
    """A = B, and C from a rod's to that of a disk."""
    A = 10 ** draw.uniform(-2, 2)
    return np.array([A, A, A * draw.choice([draw.uniform(0.2, 0.7), draw.uniform(1.3, 1.9)])])


def near_wheels(draw):
    """Each two of the inertias, once, differ by less than isclose and allclose see."""
    for shift in range(3):
        other = draw.choice([draw.uniform(0.5, 0.8), draw.uniform(1.3, 1.8)])
        yield np.roll([1.0, 1.0 + draw.choice([-1, 1]) * draw.uniform(2e-6, 8e-6), other], shift)


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


ATTITUDES = {"R = I": 0.0, "R of a quarter turn": math.pi / 2, "R of a half turn": math.pi}


def named_attitudes(draw):
    """(R, kind): the body's axes along those of space, as they are, and after a quarter turn and a half turn."""
    axis = draw.permutation(np.eye(3))[0]
    return [(np.round(right.turned(angle * axis)) + 0.0, kind) for kind, angle in ATTITUDES.items()]


def an_attitude(draw):
    return right.turned(draw.uniform(0.4, 1.2, 3) * draw.choice([-1, 1], 3))


def moving(draw, kind, body, omega, radians, count=25, side=0):
    """A motion over so many radians at uneven times, which begin on this side of t = 0."""
    start = (side or draw.choice([-1, 1])) * draw.uniform(0.5, 3)
    t = uneven(draw, radians / np.linalg.norm(omega), count, start)
    return given(t, an_attitude(draw), omega, inertia=body).on(kind)


def turning(draw):
    """(omega, inertia=...)"""
    A, k = 2.0 ** draw.integers(-1, 2), draw.uniform(0.5, 2)  # H is along omega to the last digit where all are A
    bodies = [(a_body(draw), "a random body and omega") for _ in range(12)]
    bodies += [(a_wheel(draw), "a body with A = B") for _ in range(4)]
    bodies += [(np.array([A, A, A]), "three equal inertias"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(body, "two inertias that are equal to five digits, no more") for body in near_wheels(draw)]
    calls = [(body, an_omega(draw), kind) for body, kind in bodies]
    calls += [(body, *omega) for body in (a_body(draw), np.array([2.0, 1.0, 2.0])) for omega in plain_omegas(draw)]
    return [given(omega, inertia=body).on(kind) for body, omega, kind in calls]


def turning_in_space(draw):
    """(R, omega, inertia=...)"""
    bodies = [(a_body, "a random R and omega")] * 14 + [(a_wheel, "a body with A = B")]
    calls = [given(an_attitude(draw), an_omega(draw), inertia=body(draw)).on(kind) for body, kind in bodies]
    return calls + [
        given(R, omega, inertia=a_body(draw)).on(f"{way}, {kind}")
        for R, kind in [*named_attitudes(draw), (an_attitude(draw), "a random R")]
        for omega, way in plain_omegas(draw)
    ]


def euler_angles(draw):
    """For euler_rates_313: theta of any sign, and a right angle."""
    ranges = {"theta from 0 to pi": (0.3, 2.8), "a negative theta": (-2.8, -0.3), "theta from pi to 2 pi": (3.5, 5.9)}
    calls = [
        given(draw.uniform((-4, low, -4), (4, high, 4)), an_omega(draw)).on(kind)
        for kind, (low, high) in ranges.items()
        for _ in range(5)
    ]
    quarters = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    return calls + [
        given(angles, omega).on(f"theta a right angle, {kind}")
        for angles in quarters
        for omega, kind in plain_omegas(draw)
    ]


UNDETERMINED = {"theta = 0": 0.0, "theta = pi": math.pi, "theta = -pi": -math.pi, "theta next to 0": 7e-13}
NEARLY_UNDETERMINED = 1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8


def undetermined(draw):
    """First angles with rates, where psi' is large, then angles next to them without rates."""
    omega, psi = an_omega(draw), draw.uniform(-3, 3)
    phi = math.atan2(omega[0], omega[1]) + draw.uniform(-1, 1)  # half and more of p and q is psi' sin(theta)
    kinds = [(theta, "sin theta small, but not below 1e-12") for theta in NEARLY_UNDETERMINED]
    kinds += [(theta, kind) for kind, theta in UNDETERMINED.items()]
    return [given(np.array([psi, theta, phi]), omega).on(kind) for theta, kind in kinds]


def on_side(draw, sign):
    """A body and an omega well on one side of the separatrix; 1: round the axis of the largest inertia."""
    while True:
        body, omega = a_body(draw), an_omega(draw)
        double = 2 * right.energy(omega, inertia=body)
        if sign * (np.sum((body * omega) ** 2) / (double * np.median(body)) - 1) > 0.05:
            return body, omega


def tumbles(draw):
    """Motions on both sides of the separatrix and near it."""
    near = draw.uniform(1, 3) * np.array([draw.uniform(0, 0.003), 1.0, draw.uniform(0.01, 0.02)])
    (last, round_last), (first, round_first) = on_side(draw, 1), on_side(draw, -1)
    return [
        moving(draw, "omega round the last axis, t[0] > 0", last, round_last, 14, side=1),
        moving(draw, "omega round the first axis, t[0] < 0", first, round_first, 14, side=-1),
        moving(draw, "omega near the middle axis, t[0] > 0", np.sort(a_body(draw)), near, 25, side=1),
    ]


def general_motions(draw):
    kinds = {"a general motion, t[0] > 0": 1, "a general motion, t[0] < 0": -1}
    return [moving(draw, kind, a_body(draw), an_omega(draw), 12, side=side) for kind, side in kinds.items()]


def many_turns(draw):
    return [moving(draw, "many fast turns", a_body(draw), a_fast_omega(draw), 45, 12)]


# Their trace is -1: a quaternion that is made by a division by its scalar part has none there.
HALF_TURNS = {"x": [1.0, 0.0, 0.0], "y": [0.0, 1.0, 0.0], "(1, 2, 2)": [1.0, 2.0, 2.0]}
FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


def special_motions(draw):
    """Equal inertias or nothing to turn, spins about axes, two times alone, starts at half turns."""
    flat, ball = np.array([1.0, 1.0, 2.0]) * 10 ** draw.uniform(-2, 2), np.full(3, 10 ** draw.uniform(-2, 2))
    wheels = {"a body with A = B": a_wheel(draw), "a flat disk": flat, "three equal inertias": ball}
    calls = [moving(draw, kind, body, an_omega(draw), 10) for kind, body in wheels.items()]
    rest = moving(draw, "a wheel at rest", a_wheel(draw), np.ones(3), 10)
    two = moving(draw, "two times, R = I at the start", a_wheel(draw), an_omega(draw), 5, 2)
    calls += [rest.but(*rest.args[:2], np.zeros(3)), two.but(two.args[0], np.eye(3))]
    for about, n in HALF_TURNS.items():
        case = moving(
            draw, f"a start half a turn about {about} from the axes of space", a_wheel(draw), an_omega(draw), 4, 4
        )
        calls.append(case.but(case.args[0], 2 * np.outer(n, n) / np.dot(n, n) - np.eye(3)))
    for axis in (0, 1, 2):
        omega = draw.choice([-1, 1]) * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0
        calls.append(moving(draw, f"spin about the principal axis {axis}", a_body(draw), omega, 4))
    calls.append(moving(draw, FAST_AND_FAR, a_wheel(draw), a_fast_omega(draw), 40, 2))
    again = moving(draw, "", a_wheel(draw), an_omega(draw), 5, 4)
    return calls + in_turn(draw, again, start=(an_attitude(draw), an_omega(draw)), inertia=a_wheel(draw))


def precessing(draw):
    """For symmetric_solution: (t, omega, inertia=...)"""
    wheels = [(a_wheel(draw), "a random body with A = B", 40, 25, an_omega(draw)) for _ in range(6)]
    wheels.append((np.full(3, draw.uniform(0.1, 10)), "three equal inertias", 40, 25, an_omega(draw)))
    wheels += [(a_wheel(draw), f"two times, {kind}", 10, 2, omega) for omega, kind in plain_omegas(draw)]
    return [
        given(uneven(draw, radians / (np.linalg.norm(omega) or 1.0), count), omega, inertia=body).on(kind)
        for body, kind, radians, count, omega in wheels
    ]


def wobbling(draw):
    """For wobble_rate; about the symmetry axis alone nothing wobbles."""
    kind = "a random body with A = B"
    omegas = [(an_omega(draw), kind) for _ in range(8)] + [(an_omega(draw) * [0.01, 0.01, 1], kind) for _ in range(4)]
    for omega, kind in plain_omegas(draw):
        if omega[:2].any():
            omegas.append((omega, kind if omega[2] else "omega across the symmetry axis"))
    return [given(omega, inertia=a_wheel(draw)).on(kind) for omega, kind in omegas]


WAYS = {1: "", -1: ", at a negative rate"}


def spins(draw):
    """For growth_rate_squared: each axis, both ways."""
    calls = []
    for axis, sign in product((0, 1, 2), (1, -1)):
        for body in (a_body(draw), a_body(draw), a_body(draw), a_wheel(draw)):
            calls.append(
                given(axis, sign * draw.uniform(1.5, 6), inertia=body).on(f"a spin about axis {axis}{WAYS[sign]}")
            )
        ball = given(axis, sign * draw.uniform(1.5, 6), inertia=np.full(3, draw.uniform(0.5, 2)))
        calls += [ball.on("three equal inertias"), given(axis, 0.0, inertia=a_body(draw)).on("no spin")]
    return calls


def tumbling(sign, kind):
    """For tumble_period, on one side of the separatrix, in principal planes too."""

    def drawn(draw):
        bodies = [on_side(draw, sign) for _ in range(6)]
        calls = [given(omega[np.argsort(body)], inertia=np.sort(body)).on(kind) for body, omega in bodies]
        tiny = calls[0].but(inertia=1e-6 * calls[0].kwargs["inertia"])  # the period is the same
        A, B, C = body = np.sort(a_body(draw))
        first, middle, last = np.diag([1 / math.sqrt(A * (B - A)), 1 / B, 1 / math.sqrt(C * (C - B))])
        about, other = (last, first) if sign > 0 else (first, last)
        omegas = about + other / 2, about - other / 2, middle - about, -about - middle
        plane = [given(omega, inertia=body).on(f"{kind}, in a principal plane") for omega in omegas]
        return [tiny.on(f"{kind}, a tiny body"), *calls[1:], *plane]

    return drawn


def pure_spins(draw):
    calls = []
    for axis, sign in product((0, 2), (1, -1)):
        omega = sign * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0
        calls.append(given(omega, inertia=np.sort(a_body(draw))).on(f"pure spin about axis {axis}{WAYS[sign]}"))
    return calls


def beside_separatrix(draw, distance):
    """A call with C (C - B) r^2 = (1 + distance) A (B - A) p^2, beyond the separatrix for a positive distance.

    At 1e-6, k by energy and H^2 gives the period to 4e-10, events of solve_ivp at 1e-9 give it to 4e-7 (RK45).
    """
    body, (p, q) = np.sort(a_body(draw)), draw.uniform(0.4, 1, 2)
    A, B, C = body
    r = p * math.sqrt((1 + distance) * A * (B - A) / (C * (C - B)))
    omega = draw.uniform(1, 4) * draw.choice([-1, 1], 3) * [p, q, r]
    return given(omega, inertia=body).on("omega next to the separatrix, not about the middle axis")


def near_separatrix(draw):
    omegas = np.array([(0, 1, 3e-5), (0, 1, -1e-3), (3e-5, 1, 0), (-1e-3, 1, 0)])
    calls = [given(draw.uniform(1, 4) * way, inertia=np.sort(a_body(draw))) for way in (*omegas[:2], *-omegas[2:])]
    beside = [beside_separatrix(draw, sign * distance) for distance in (1e-2, 1e-4, 1e-6) for sign in (1, -1)]
    return [case.on("omega almost about the middle axis") for case in calls] + beside


def on_separatrix(draw):
    """Whole numbers times powers of two: 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2, without any rounding."""
    body = np.array([3.0, 4.0, 6.0]) * 2.0 ** draw.integers(-5, 6)
    ways = {"pure spin about the middle axis": (0, 1, 0), "omega on the separatrix": (2, 1, -1)}
    return [given(np.array(way) * 0.25 * draw.integers(1, 9), inertia=body).on(kind) for kind, way in ways.items()]


def boxes(draw):
    sizes = [draw.permutation(10 ** draw.uniform(-1, 1) * np.array([1, 1.7, 2.9])) for _ in range(6)]
    drawn = [(an_attitude(draw), size, "a random attitude and size") for size in sizes[:3]]
    drawn += [(R, size, f"a box, {kind}") for (R, kind), size in zip(named_attitudes(draw), sizes[3:], strict=True)]
    return [*drawn, (an_attitude(draw), np.full(3, sizes[0][0]), "a cube")]


def pictures(draw):
    """A disk near its spin axis, and a body with three different inertias; 401 times."""
    tilted = np.array([*draw.uniform(0.1, 0.2, 2), 1.0])
    kinds = {
        "a disk near its spin axis, t[0] not 0": ([1.0, 1.0, 2.0], tilted),
        "a body with three different inertias, t[0] not 0": ([1.0, 1.7, 2.2], np.array([0.5, -0.7, 0.5])),
    }
    for kind, (body, way) in kinds.items():
        spin, start, inertia = draw.uniform(1, 4), draw.uniform(-2, 2), np.array(body) * 10 ** draw.uniform(-2, 2)
        t = np.linspace(start, start + draw.uniform(4, 6) / spin, 401)
        yield given(t, an_attitude(draw), spin * way, inertia=inertia, radius=10 ** draw.uniform(-1, 1)).on(kind)
