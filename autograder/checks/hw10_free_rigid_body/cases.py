"""Hidden inputs of hw10: bodies of any size, wheels, spins about axes, motions on both sides of the separatrix."""

import math

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


def omega_kind(omega):
    """What an omega of `plain_omegas` is called."""
    return OMEGAS[np.count_nonzero(omega)]


def plain_omegas(draw):
    """Spins about each axis both ways, omegas with one zero, without one but of one sign, and none."""
    size = np.abs(an_omega(draw))
    return [sign * size * some + 0.0 for some in np.ndindex(2, 2, 2) for sign in (1, -1)]  # no zero has a sign


ATTITUDES = ("R = I", "R of a quarter turn", "R of a half turn")


def named_attitudes(draw):
    """The body's axes along those of space: as they are, and after a quarter turn and a half turn; their names."""
    axis = draw.permutation(np.eye(3))[0]
    turns = [np.round(right.turned(angle * axis)) + 0.0 for angle in (0.0, math.pi / 2, math.pi)]
    return list(zip(turns, ATTITUDES, strict=True))


def an_attitude(draw):
    return right.turned(draw.uniform(0.4, 1.2, 3) * draw.choice([-1, 1], 3))


def times(draw, omega, radians, count=25, start=None):
    """Uneven times, from this start or any that is not 0, for so many radians."""
    return uneven(draw, radians / np.linalg.norm(omega), count, start)


def bodies_turning(draw):
    """For euler_equations."""
    A, k = 2.0 ** draw.integers(-1, 2), draw.uniform(0.5, 2)  # H is along omega to the last digit where all are A
    bodies = [(a_body(draw), "a random body and omega") for _ in range(12)]
    bodies += [(a_wheel(draw), "a body with A = B") for _ in range(4)]
    bodies += [(np.array([A, A, A]), "three equal inertias"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(body, "two inertias that are equal to five digits, no more") for body in near_wheels(draw)]
    plain = [(body, omega) for body in (a_body(draw), np.array([2.0, 1.0, 2.0])) for omega in plain_omegas(draw)]
    return [given(an_omega(draw), inertia=body).on(kind) for body, kind in bodies] + [
        given(omega, inertia=body).on(omega_kind(omega)) for body, omega in plain
    ]


def turning(draw):
    """For attitude_rate."""
    calls = [given(an_attitude(draw), an_omega(draw)).on("a random attitude and omega") for _ in range(15)]
    return calls + [
        given(R, omega).on(f"{omega_kind(omega)}, {kind}")
        for R, kind in [*named_attitudes(draw), (an_attitude(draw), "a random R")]
        for omega in plain_omegas(draw)
    ]


def spinning(draw):
    """For energy."""
    calls = [given(an_omega(draw), inertia=a_body(draw)).on("a random body and omega") for _ in range(10)]
    calls.append(given(an_omega(draw), inertia=a_wheel(draw)).on("a body with A = B"))
    return calls + [given(omega, inertia=a_body(draw)).on(omega_kind(omega)) for omega in plain_omegas(draw)]


def spinning_in_space(draw):
    """For angular_momentum."""
    kinds = [("a random body, attitude and omega", a_body)] * 10 + [("a body with A = B", a_wheel)]
    calls = [given(an_attitude(draw), an_omega(draw), inertia=body(draw)).on(kind) for kind, body in kinds]
    return calls + [
        given(R, omega, inertia=a_body(draw)).on(f"{omega_kind(omega)}, {kind}")
        for R, kind in named_attitudes(draw)
        for omega in plain_omegas(draw)
    ]


def euler_angles(draw):
    """For euler_rates_313: theta of any sign, and a right angle."""
    thetas = [*draw.uniform(0.3, 2.8, 6), *-draw.uniform(0.3, 2.8, 4), *draw.uniform(3.5, 5.9, 4)]
    kinds = ["theta from 0 to pi"] * 6 + ["a negative theta"] * 4 + ["theta from pi to 2 pi"] * 4
    calls = [
        given(np.array([psi, theta, phi]), an_omega(draw)).on(kind)
        for theta, psi, phi, kind in zip(thetas, *draw.uniform(-4, 4, (2, 14)), kinds, strict=True)
    ]
    quarters = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    return calls + [
        given(angles, omega).on(f"theta a right angle, {omega_kind(omega)}")
        for angles in quarters
        for omega in plain_omegas(draw)
    ]


UNDETERMINED = {"theta = 0": 0.0, "theta = pi": math.pi, "theta = -pi": -math.pi, "theta next to 0": 7e-13}
NEARLY_UNDETERMINED = 1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8


def undetermined(draw):
    """Angles without rates, and angles next to them with rates: psi' is large there."""
    omega, psi = an_omega(draw), draw.uniform(-3, 3)
    phi = math.atan2(omega[0], omega[1]) + draw.uniform(-1, 1)  # half and more of p and q is psi' sin(theta)
    refused = [given(np.array([psi, theta, phi]), omega).on(kind) for kind, theta in UNDETERMINED.items()]
    near = [given(np.array([psi, theta, phi]), omega) for theta in NEARLY_UNDETERMINED]
    return refused, [case.on("sin theta small, but not below 1e-12") for case in near]


def on_side(draw, sign):
    """A body and an omega well on one side of the separatrix; 1: round the axis of the largest inertia."""
    while True:
        body, omega = a_body(draw), an_omega(draw)
        double = 2 * right.energy(omega, inertia=body)
        if sign * (np.sum((body * omega) ** 2) / (double * np.median(body)) - 1) > 0.05:
            return body, omega


def tumbles(draw):
    """Motions on both sides of the separatrix and near it, some from before t = 0 and some from after it."""
    near = draw.uniform(1, 3) * np.array([draw.uniform(0, 0.003), 1.0, draw.uniform(0.01, 0.02)])
    places = {
        "omega round the last axis": (*on_side(draw, 1), 14),
        "omega round the first axis": (*on_side(draw, -1), 14),
        "omega near the middle axis": (np.sort(a_body(draw)), near, 25),
    }
    starts = draw.uniform(0.5, 3, 3) * [1, -1, 1]
    return [
        given(times(draw, omega, radians, start=start), an_attitude(draw), omega, inertia=body).on(
            f"{kind}, t[0] not 0"
        )
        for (kind, (body, omega, radians)), start in zip(places.items(), starts, strict=True)
    ]


def general_motions(draw):
    omegas, starts = [an_omega(draw) for _ in range(2)], draw.uniform(0.5, 3, 2) * [1, -1]
    return [
        given(times(draw, omega, 12, start=start), an_attitude(draw), omega, inertia=a_body(draw)).on(
            "a general motion, t[0] not 0"
        )
        for omega, start in zip(omegas, starts, strict=True)
    ]


def many_turns(draw):
    omega = a_fast_omega(draw)
    case = given(times(draw, omega, 45, count=12), an_attitude(draw), omega, inertia=a_body(draw))
    return [case.on("many fast turns")]


# Their trace is -1: a quaternion that is made by a division by its scalar part has none there.
HALF_TURNS = {
    "about x": np.diag([1.0, -1.0, -1.0]),
    "about y": np.diag([-1.0, 1.0, -1.0]),
    "about (1, 2, 2)": 2 * np.outer([1, 2, 2], [1, 2, 2]) / 9 - np.eye(3),
}
FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


def special_motions(draw):
    """Equal inertias or nothing to turn, spins about axes, two times alone, starts at half turns."""
    flat, ball = np.array([1.0, 1.0, 2.0]) * 10 ** draw.uniform(-2, 2), np.full(3, 10 ** draw.uniform(-2, 2))
    wheels = {"a body with A = B": a_wheel(draw), "a flat disk": flat, "three equal inertias": ball}
    calls = [moving(draw, body, an_omega(draw), 10).on(kind) for kind, body in wheels.items()]
    rest = moving(draw, a_wheel(draw), np.ones(3), 10)
    calls.append(rest.but(rest.args[0], rest.args[1], np.zeros(3)).on("a wheel at rest"))
    two = moving(draw, a_wheel(draw), an_omega(draw), 5, 2)
    calls.append(two.but(two.args[0], np.eye(3)).on("two times, and axes along those of space at the start"))
    for about, start in HALF_TURNS.items():
        case = moving(draw, a_wheel(draw), an_omega(draw), 4, 4)
        calls.append(case.but(case.args[0], start).on(f"a start half a turn {about} from the axes of space"))
    for axis in (0, 1, 2):
        omega = draw.choice([-1, 1]) * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0
        calls.append(moving(draw, a_body(draw), omega, 4).on(f"spin about the principal axis {axis}"))
    calls.append(moving(draw, a_wheel(draw), a_fast_omega(draw), 40, 2).on(FAST_AND_FAR))
    again = moving(draw, a_wheel(draw), an_omega(draw), 5, 4)
    return calls + in_turn(draw, again, start=(an_attitude(draw), an_omega(draw)), inertia=a_wheel(draw))


def moving(draw, body, omega, radians, count=25):
    return given(times(draw, omega, radians, count), an_attitude(draw), omega, inertia=body)


def precessing(draw):
    """For symmetric_solution."""
    wheels = [(a_wheel(draw), "a random body with A = B") for _ in range(6)]
    wheels.append((np.full(3, draw.uniform(0.1, 10)), "three equal inertias"))
    omegas = [an_omega(draw) for _ in wheels]
    calls = [
        given(times(draw, omega, 40), omega, inertia=body).on(kind)
        for (body, kind), omega in zip(wheels, omegas, strict=True)
    ]
    return calls + [
        given(times(draw, np.ones(3), 10, 2), omega, inertia=a_wheel(draw)).on(f"two times, {omega_kind(omega)}")
        for omega in plain_omegas(draw)
    ]


def wobbling(draw):
    """For wobble_rate; about the symmetry axis alone nothing wobbles."""
    omegas = [an_omega(draw) for _ in range(8)] + [an_omega(draw) * [0.01, 0.01, 1] for _ in range(4)]
    calls = [given(omega, inertia=a_wheel(draw)).on("a random body with A = B") for omega in omegas]
    return calls + [
        given(omega, inertia=a_wheel(draw)).on(omega_kind(omega) if omega[2] else "omega across the symmetry axis")
        for omega in plain_omegas(draw)
        if omega[:2].any()
    ]


def spins(draw):
    """For growth_rate_squared: each axis, both ways."""
    calls = []
    for axis in (0, 1, 2):
        bodies = [*(a_body(draw) for _ in range(6)), a_wheel(draw)]
        for body, spin in zip(bodies, draw.uniform(1.5, 6, 7) * draw.choice([-1, 1], 7), strict=True):
            way = "positive" if spin > 0 else "negative"
            calls.append(given(axis, spin, inertia=body).on(f"a {way} spin about axis {axis}"))
        ball = given(axis, draw.uniform(1.5, 6), inertia=np.full(3, draw.uniform(0.5, 2)))
        calls += [ball.on("three equal inertias"), given(axis, 0.0, inertia=a_body(draw)).on("no spin")]
    return calls


def tumbling(draw, sign, kind):
    """For tumble_period, on one side of the separatrix, in principal planes too."""
    drawn = [on_side(draw, sign) for _ in range(6)]
    calls = [given(omega[np.argsort(body)], inertia=np.sort(body)).on(kind) for body, omega in drawn]
    tiny = calls[0].but(inertia=1e-6 * calls[0].kwargs["inertia"])  # the period is the same
    calls[0] = tiny.on(f"{kind}, a tiny body")
    A, B, C = body = np.sort(a_body(draw))
    first, middle, last = np.diag([1 / math.sqrt(A * (B - A)), 1 / B, 1 / math.sqrt(C * (C - B))])
    about, other = (last, first) if sign > 0 else (first, last)
    omegas = about + other / 2, about - other / 2, middle - about, -about - middle
    return calls + [given(omega, inertia=body).on(f"{kind}, in a principal plane") for omega in omegas]


def pure_spins(draw):
    return [
        given(sign * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0, inertia=np.sort(a_body(draw))).on(
            f"pure spin about axis {axis}{', at a negative rate' if sign < 0 else ''}"
        )
        for axis in (0, 2)
        for sign in (1, -1)
    ]


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
