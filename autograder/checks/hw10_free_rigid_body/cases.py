"""Hidden inputs of hw10: bodies of any size, wheels, spins about axes, motions on both sides of the separatrix."""

import math
from itertools import product

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from . import reference


def a_body(rng):
    """Inertias in any order, each less than the sum of the other two, of any size."""
    spread = rng.permutation(rng.uniform((0.1, 0.4, 0.8), (0.25, 0.6, 1)))
    return (spread.sum() - spread) * 10 ** rng.uniform(-2, 2)


def a_wheel(rng):
    """A = B, and C from a rod's to that of a disk."""
    A = 10 ** rng.uniform(-2, 2)
    return np.array([A, A, A * rng.choice([rng.uniform(0.2, 0.7), rng.uniform(1.3, 1.9)])])


def an_omega(rng):
    """No component is small, and the size is between .5 and 6 rad/s."""
    return rng.uniform(0.4, 1, 3) * rng.choice([-1, 1], 3) * 10 ** rng.uniform(0, 0.5)


def a_fast_omega(rng):
    """At 15 to 18 rad/s: steps of a millisecond follow it, those of ten do not."""
    omega = an_omega(rng)
    return omega * rng.uniform(15, 18) / np.linalg.norm(omega)


OMEGAS = ("omega zero", "omega along a principal axis", "omega in a principal plane", "omega of one sign")


def plain_omegas(rng):
    """(omega, kind): spins about each axis both ways, with one zero, without one but of one sign, and none."""
    size = np.abs(an_omega(rng))
    ways = [sign * size * some + 0.0 for some in np.ndindex(2, 2, 2) for sign in (1, -1)]  # no zero has a sign
    return [(omega, OMEGAS[np.count_nonzero(omega)]) for omega in ways]


def an_attitude(rng):
    return reference.turned(rng.uniform(0.4, 1.2, 3) * rng.choice([-1, 1], 3))


def attitudes(rng):
    """(R, kind): a random one, and the body's axes along those of space, after a quarter turn and a half turn, too."""
    axis, turns = rng.permutation(np.eye(3))[0], {"R = I": 0, "R of a quarter turn": 1, "R of a half turn": 2}
    plain = [(np.round(reference.turned(turn * math.pi / 2 * axis)) + 0.0, label) for label, turn in turns.items()]
    return [(an_attitude(rng), "a random R"), *plain]


def turning(rng):
    """(omega, inertia=...)"""
    A, k = 2.0 ** rng.integers(-1, 2), rng.uniform(0.5, 2)  # H is along omega to the last digit where all are A
    near = 1 + rng.choice([-1, 1]) * rng.uniform(2e-6, 8e-6)  # less from 1 than isclose and allclose see
    bodies = [(a_body(rng), "a random body and omega") for _ in range(12)]
    bodies += [(a_wheel(rng), "a body with A = B") for _ in range(4)]
    bodies += [(np.array([A, A, A]), "three equal inertias"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(np.roll([1.0, near, 1.6], i), "two inertias that are equal to five digits, no more") for i in range(3)]
    calls = [(body, an_omega(rng), label) for body, label in bodies]
    calls += [(body, *omega) for body in (a_body(rng), np.array([2.0, 1.0, 2.0])) for omega in plain_omegas(rng)]
    return [Case(omega, inertia=body).labelled(label) for body, omega, label in calls]


def turning_in_space(rng):
    """(R, omega, inertia=...)"""
    for case in turning(rng):
        for R, way in attitudes(rng):
            yield case.with_leading(R).labelled(f"{case.label}, {way}")


def euler_angles(rng):
    """For euler_rates_313: theta of any sign, and a right angle."""
    thetas = [("theta from 0 to pi", 0.3, 2.8), ("a negative theta", -2.8, -0.3), ("theta from pi to 2 pi", 3.5, 5.9)]
    some = [(rng.uniform((-4, low, -4), (4, high, 4)), an_omega(rng), label) for label, low, high in thetas * 5]
    quarters = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    some += [(turns, omega, f"theta a right angle, {way}") for turns in quarters for omega, way in plain_omegas(rng)]
    return [Case(angles, omega).labelled(label) for angles, omega, label in some]


def undetermined(rng):
    """First angles with rates, where psi' is large, then angles next to them without rates."""
    omega, psi = an_omega(rng), rng.uniform(-3, 3)
    phi = math.atan2(omega[0], omega[1]) + rng.uniform(-1, 1)  # half and more of p and q is psi' sin(theta)
    thetas = [(theta, "sin theta small, but not below 1e-12") for theta in (1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8)]
    thetas += [(0.0, "theta = 0"), (math.pi, "theta = pi"), (-math.pi, "theta = -pi"), (7e-13, "theta next to 0")]
    return [Case(np.array([psi, theta, phi]), omega).labelled(label) for theta, label in thetas]


def moving(rng, label, body, omega, radians, count=25, side=0, R=None):
    """A motion over so many radians at uneven times, which begin on this side of t = 0."""
    start = (side or rng.choice([-1, 1])) * rng.uniform(0.5, 3)
    t = uneven(rng, radians / (np.linalg.norm(omega) or 1.0), count, start)
    return Case(t, an_attitude(rng) if R is None else R, omega, inertia=body).labelled(label)


def tumbling(rng, label, way):
    """For tumble_period; (1, q, 1) is a way on the separatrix."""
    A, B, C = body = np.sort(a_body(rng))
    omega = way * rng.uniform(0.5, 1.5) * B / np.sqrt([A * (B - A), B * B, C * (C - B)])
    return Case(omega, inertia=body).labelled(label)


def round_last(rng):
    """A way well on the one side of the separatrix; backwards it is on the other."""
    return rng.uniform((0.2, 0.4, 1), (0.7, 2, 1)) * rng.choice([-1, 1], 3)


def tumbles(rng):
    """Motions on both sides of the separatrix and near it, of inertias in any order; there each is the middle once."""
    for label, way, radians, side, orders in (
        ("omega round the last axis, t[0] > 0", round_last(rng), 14, 1, 1),
        ("omega round the first axis, t[0] < 0", round_last(rng)[::-1], 14, -1, 1),
        ("omega near the middle axis, t[0] > 0", rng.uniform((0, 1, 0.008), (0.002, 1, 0.012)), 25, 1, 3),
    ):
        places, case = rng.permutation(3), tumbling(rng, label, way)
        for order in (np.roll(places, k) for k in range(orders)):
            yield moving(rng, label, case.kwargs["inertia"][order], case.args[0][order], radians, side=side)


def general_motions(rng):
    kinds = {"a general motion, t[0] > 0": 1, "a general motion, t[0] < 0": -1}
    return [moving(rng, label, a_body(rng), an_omega(rng), 12, side=side) for label, side in kinds.items()]


def many_turns(rng):
    return [moving(rng, "many fast turns", a_body(rng), a_fast_omega(rng), 45, 12)]


ON_SEPARATRIX = np.array([[3.0, 4.0, 6.0], [2.0, 1.0, -1.0]])  # inertia, omega: 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2
FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


def special_motions(rng):
    """Equal inertias or nothing to turn, spins about axes, two times alone, starts at half turns."""
    ball, size = np.full(3, 10 ** rng.uniform(-2, 2)), 10 ** rng.uniform(-2, 2)
    calls = [
        moving(rng, "a body with A = B", a_wheel(rng), an_omega(rng), 10),
        moving(rng, "a flat disk", size * np.array([1.0, 1.0, 2.0]), an_omega(rng), 10),
        moving(rng, "three equal inertias", ball, an_omega(rng), 10),
        moving(rng, "a wheel at rest", a_wheel(rng), np.zeros(3), 10),
        moving(rng, "two times, R = I at the start", a_wheel(rng), an_omega(rng), 5, 2, R=np.eye(3)),
        moving(rng, FAST_AND_FAR, a_wheel(rng), a_fast_omega(rng), 40, 2),
    ]
    # of half turns the trace is -1: a quaternion that is made by a division by its scalar part has none there
    for about, n in {"x": [1, 0, 0], "y": [0, 1, 0], "(1, 2, 2)": [1, 2, 2]}.items():
        half, label = 2 * np.outer(n, n) / np.dot(n, n) - np.eye(3), f"a start half a turn about {about}"
        calls.append(moving(rng, f"{label} from the axes of space", a_wheel(rng), an_omega(rng), 4, 4, R=half))
    for axis in (0, 1, 2):
        omega = rng.choice([-1, 1]) * rng.uniform(1, 4) * np.eye(3)[axis] + 0.0
        calls.append(moving(rng, f"spin about the principal axis {axis}", a_body(rng), omega, 4))
        body, omega = np.roll(ON_SEPARATRIX, axis, axis=1)
        calls.append(moving(rng, f"omega on the separatrix, the middle axis {(axis + 1) % 3}", body, omega, 8))
    again = moving(rng, "", a_wheel(rng), an_omega(rng), 5, 4)
    return calls + repeated_calls(rng, again, start=(an_attitude(rng), an_omega(rng)), inertia=a_wheel(rng))


def wheels(rng):
    """(omega, inertia=...) with A = B"""
    label = "a random body with A = B"
    omegas = [(an_omega(rng), label) for _ in range(8)] + [(an_omega(rng) * [0.01, 0.01, 1], label) for _ in range(4)]
    return [Case(omega, inertia=a_wheel(rng)).labelled(label) for omega, label in omegas + plain_omegas(rng)]


def wobbling(rng):
    """For wobble_rate; about the symmetry axis alone nothing wobbles."""
    return [case for case in wheels(rng) if case.args[0][:2].any()]


def precessing(rng):
    """For symmetric_solution: (t, omega, inertia=...), of two times, too."""
    calls = [
        *wheels(rng),
        Case(an_omega(rng), inertia=np.full(3, rng.uniform(0.1, 10))).labelled("three equal inertias"),
    ]
    for case in calls:
        t = uneven(rng, 40 / (np.linalg.norm(case.args[0]) or 1.0), 25)
        yield case.with_leading(t)
        yield case.with_leading(t[[0, 5]]).labelled(f"two times, {case.label}")


WAYS = {1: "", -1: ", at a negative rate"}


def spins(rng):
    """For growth_rate_squared: each axis, both ways."""
    for axis, (sign, way) in product((0, 1, 2), WAYS.items()):
        bodies = [(body(rng), f"a spin about axis {axis}{way}") for body in (a_body, a_body, a_body, a_wheel)]
        for body, label in [*bodies, (np.full(3, rng.uniform(0.5, 2)), "three equal inertias")]:
            yield Case(axis, sign * rng.uniform(1.5, 6), inertia=body).labelled(label)
        yield Case(axis, 0.0, inertia=a_body(rng)).labelled("no spin")


def on_side(rng, label, sign):
    """1: round the axis of the largest inertia, -1: of the smallest; in principal planes, too, and of a tiny body."""
    calls = [tumbling(rng, label, round_last(rng)[::sign]) for _ in range(6)]
    planes = np.array([(0.5, 0, 1), (-0.5, 0, 1), (0, 1, -1), (0, -1, -1)])[:, ::sign]
    calls += [tumbling(rng, f"{label}, in a principal plane", way) for way in planes]
    return [*calls, calls[0].replace(inertia=1e-6 * calls[0].kwargs["inertia"]).labelled(f"{label}, a tiny body")]


def pure_spins(rng):
    for axis, (sign, way) in product((0, 2), WAYS.items()):
        yield tumbling(rng, f"pure spin about axis {axis}{way}", sign * np.eye(3)[axis] + 0.0)


def near_separatrix(rng):
    """Next to it C (C - B) r^2 = (1 + distance) A (B - A) p^2.

    At 1e-6, k by energy and H^2 gives the period to 4e-10, events of solve_ivp at 1e-9 give it to 4e-7 (RK45).
    """
    for way in np.array([(0, 1, 2e-5), (0, 1, -1e-3), (-2e-5, -1, 0), (1e-3, -1, 0)]):
        yield tumbling(rng, "omega almost about the middle axis", way)
    for distance in (1e-2, -1e-2, 1e-4, -1e-4, 1e-6, -1e-6):
        way = rng.choice([-1, 1], 3) * [1, rng.uniform(0.8, 2), math.sqrt(1 + distance)]
        yield tumbling(rng, "omega next to the separatrix, not about the middle axis", way)


def on_separatrix(rng):
    """Times powers of two: without any rounding, too."""
    body, omega = ON_SEPARATRIX * np.array([[2.0 ** rng.integers(-5, 6)], [0.25 * rng.integers(1, 9)]])
    ways = {"pure spin about the middle axis": omega * [0, 1, 0], "omega on the separatrix": omega}
    return [Case(way, inertia=body).labelled(label) for label, way in ways.items()]


def boxes(rng):
    for R, label in [(an_attitude(rng), "a random R"), (an_attitude(rng), "a random R"), *attitudes(rng)]:
        yield R, rng.permutation(10 ** rng.uniform(-1, 1) * np.array([1, 1.7, 2.9])), f"a box, {label}"
    yield an_attitude(rng), np.full(3, 10 ** rng.uniform(-1, 1)), "a cube"


def pictures(rng):
    """A disk near its spin axis, from any attitude and lying flat, and a body with three inertias; 401 times."""
    disk, tilted = np.array([1.0, 1.0, 2.0]), np.array([*rng.uniform(0.1, 0.2, 2), 1.0])
    flat = "a disk that lies flat, near its spin axis, t[0] not 0"
    for label, body, way in (
        ("a disk near its spin axis, t[0] not 0", disk, tilted),
        ("a body with three different inertias, t[0] not 0", np.array([1.0, 1.7, 2.2]), np.array([0.5, -0.7, 0.5])),
        (flat, disk, tilted),
    ):
        spin, start, inertia = rng.uniform(1, 4), rng.uniform(-2, 2), body * 10 ** rng.uniform(-2, 2)
        t = np.linspace(start, start + rng.uniform(4, 6) / spin, 401)
        R = yawed(rng.uniform(0, 2 * math.pi)) if label == flat else an_attitude(rng)
        yield Case(t, R, spin * way, inertia=inertia, radius=10 ** rng.uniform(-1, 1)).labelled(label)


def yawed(angle):
    """R about space z."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
