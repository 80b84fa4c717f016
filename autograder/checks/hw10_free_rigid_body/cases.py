"""Hidden inputs of hw10: bodies of any size, wheels, spins about axes, motions on both sides of the separatrix."""

import math

import numpy as np

from tam570_grader import KEPT, SOME_TIMES, Case, uneven

from . import reference


def random_body(rng):
    """Return inertias of any size in any order, each less than the sum of the other two."""
    spread = rng.permutation(rng.uniform((0.1, 0.4, 0.8), (0.25, 0.6, 1)))
    return (spread.sum() - spread) * 10 ** rng.uniform(-2, 2)


def random_wheel(rng):
    """Return inertias with A = B, and C from that of a rod to that of a disk."""
    A = 10 ** rng.uniform(-2, 2)
    return np.array([A, A, A * rng.choice([rng.uniform(0.2, 0.7), rng.uniform(1.3, 1.9)])])


def random_omega(rng):
    """Return an omega without small components, of a size between .5 and 6 rad/s."""
    return rng.uniform(0.4, 1, 3) * rng.choice([-1, 1], 3) * 10 ** rng.uniform(0, 0.5)


def fast_omega(rng):
    """Return an omega of 15 to 18 rad/s, which steps of 1 ms can follow, and steps of 10 ms cannot."""
    omega = random_omega(rng)
    return omega * rng.uniform(15, 18) / np.linalg.norm(omega)


OMEGAS = ("omega zero", "omega along a principal axis", "omega in a principal plane", "omega of one sign")


def plain_omegas(rng):
    """Return (omega, label): none, about each axis, in each plane, and of one sign."""
    size, sign = np.abs(random_omega(rng)), rng.choice([-1, 1])
    omegas = [sign * size * parts + 0.0 for parts in np.ndindex(2, 2, 2)]  # + 0.0 removes the sign of zeros
    return [(omega, OMEGAS[np.count_nonzero(omega)]) for omega in omegas]


def random_attitude(rng):
    return reference.turned(rng.uniform(0.4, 1.2, 3) * rng.choice([-1, 1], 3))


def attitudes(rng):
    """Return (R, label): a random one, and R = I, a quarter turn and a half turn about an axis."""
    axis, turns = rng.permutation(np.eye(3))[0], {"R = I": 0, "R of a quarter turn": 1, "R of a half turn": 2}
    plain = [(np.round(reference.turned(turn * math.pi / 2 * axis)) + 0.0, label) for label, turn in turns.items()]
    return [(random_attitude(rng), "a random R"), *plain]


def turning(rng):
    """Return (omega, inertia=...)."""
    A, k = 2.0 ** rng.integers(-1, 2), rng.uniform(0.5, 2)  # if all inertias are A, H is along omega to the last digit
    near = 1 + rng.choice([-1, 1]) * rng.uniform(2e-6, 8e-6)  # nearer to 1 than isclose and allclose detect
    bodies = [(random_body(rng), "a random body and omega") for _ in range(3)]
    bodies += [(random_wheel(rng), "a body with A = B"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(np.roll([1.0, near, 1.6], i), "two inertias that are equal to five digits, no more") for i in range(3)]
    bodies.append((np.array([A, A, A]), "three equal inertias"))
    calls = [(body, random_omega(rng), label) for body, label in bodies]
    calls += [(random_body(rng), *omega) for omega in plain_omegas(rng)]
    return [Case(omega, inertia=body).labelled(label) for body, omega, label in calls]


def turning_in_space(rng):
    """Return (R, omega, inertia=...)."""
    cases, (first, *plain) = turning(rng), attitudes(rng)
    pairs = [(case, first) for case in cases] + [(cases[0], attitude) for attitude in plain]
    return [case.with_leading(R).labelled(f"{case.label}, {label}") for case, (R, label) in pairs]


def euler_angles(rng):
    """Return arguments of euler_rates_313: theta of any sign, and a right angle."""
    thetas = [("theta from 0 to pi", 0.3, 2.8), ("a negative theta", -2.8, -0.3), ("theta from pi to 2 pi", 3.5, 5.9)]
    calls = [(rng.uniform((-4, low, -4), (4, high, 4)), random_omega(rng), label) for label, low, high in thetas * 2]
    turns = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    calls += [(angles, random_omega(rng), "theta a right angle") for angles in turns]
    calls += [(turns[2], omega, f"theta a right angle, {label}") for omega, label in plain_omegas(rng)]
    return [Case(angles, omega).labelled(label) for angles, omega, label in calls]


def undetermined(rng):
    """Return angles with rates, where psi' is large, then angles next to them without rates."""
    omega, psi = random_omega(rng), rng.uniform(-3, 3)
    phi = math.atan2(omega[0], omega[1]) + rng.uniform(-1, 1)  # half of p and q or more is psi' sin(theta)
    thetas = [(theta, "sin theta small, but not below 1e-12") for theta in (1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8)]
    thetas += [(0.0, "theta = 0"), (math.pi, "theta = pi"), (-math.pi, "theta = -pi"), (7e-13, "theta next to 0")]
    return [Case(np.array([psi, theta, phi]), omega).labelled(label) for theta, label in thetas]


def motion(rng, label, body, omega, radians, count, side=0, R=None):
    """Return a motion over some radians at uneven times, which begin on this side of t = 0."""
    start = (side or rng.choice([-1, 1])) * rng.uniform(0.5, 3)
    t = uneven(rng, radians / (np.linalg.norm(omega) or 1.0), count, start)
    return Case(t, random_attitude(rng) if R is None else R, omega, inertia=body).labelled(label)


def tumbling(rng, label, way):
    """Return a case of tumble_period; (1, q, 1) is a way on the separatrix."""
    A, B, C = body = np.sort(random_body(rng))
    omega = way * rng.uniform(0.5, 1.5) * B / np.sqrt([A * (B - A), B * B, C * (C - B)])
    return Case(omega, inertia=body).labelled(label)


def round_last(rng):
    """Return a way well on one side of the separatrix; reversed, it is on the other."""
    return rng.uniform((0.2, 0.4, 1), (0.7, 2, 1)) * rng.choice([-1, 1], 3)


def tumbles(rng):
    """Yield motions on both sides of the separatrix and near it, with inertias in any order."""
    side = rng.choice([-1, 1])
    far, near = round_last(rng)[::side], rng.uniform((0, 1, 0.008), (0.002, 1, 0.012))[::-side]
    for label, way, radians, sign, orders in (
        ("omega round the last axis or the first, t[0] < 0", far, 9, -1, [(0, 1, 2), (2, 1, 0)]),
        ("omega near the middle axis, t[0] > 0", near, 25, 1, [(1, 2, 0), (2, 0, 1)]),  # the middle axis is 0 or 2
    ):
        order, case = rng.permutation(orders)[0], tumbling(rng, label, way)
        yield motion(rng, label, case.kwargs["inertia"][order], case.args[0][order], radians, 15, sign)


def general_motions(rng):
    return [motion(rng, "a general motion", random_body(rng), random_omega(rng), 8, 15)]


def many_turns(rng):
    return [motion(rng, "many fast turns", random_body(rng), fast_omega(rng), 30, 7)]


FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


def special_motions(rng):
    """Return equal inertias, rest, a spin about an axis, starts at half turns, other times; one change at a time."""
    # the trace of a half turn is -1, where no quaternion can be computed by a division by its scalar part
    halves = {n: 2 * np.outer(n, n) / np.dot(n, n) - np.eye(3) for n in ((1, 2, 2), (0, 1, 0))}
    label = "a body with A = B, a start half a turn about (1, 2, 2)"
    first = motion(rng, label, random_wheel(rng), random_omega(rng), 4, 4, R=halves[1, 2, 2])
    t, _, omega = first.args
    spin = omega * rng.permutation(np.eye(3))[0] + 0.0
    return [
        first,
        first.replace(t[0] + (t - t[0]) ** 2 / (t[-1] - t[0])).labelled("the motion before at other times", KEPT),
        first.replace(t, halves[0, 1, 0], spin).labelled("spin about a principal axis, a start half a turn about y"),
        first.replace(inertia=np.full(3, first.kwargs["inertia"][0])).labelled("three equal inertias"),
        first.replace(t[[0, -1]], random_attitude(rng), np.zeros(3)).labelled("a wheel at rest, two times"),
        motion(rng, FAST_AND_FAR, random_wheel(rng), fast_omega(rng), 20, 2),
    ]


def wheels(rng):
    """Return (omega, inertia=...) with A = B; p of both signs, which arctan(q/p) does not distinguish."""
    label = "a random body with A = B"
    omegas = [(np.copysign(random_omega(rng), (sign, *rng.choice([-1, 1], 2))), label) for sign in (-1, 1, -1)]
    omegas.append((random_omega(rng) * [0.01, 0.01, 1], label))
    return [Case(omega, inertia=random_wheel(rng)).labelled(label) for omega, label in omegas + plain_omegas(rng)]


def wobbling(rng):
    """Return cases of wobble_rate; a spin about the symmetry axis alone does not wobble."""
    return [case for case in wheels(rng) if case.args[0][:2].any()]


def precessing(rng):
    """Yield cases of symmetric_solution: (t, omega, inertia=...), also of two times, one, and descending ones."""
    ball = Case(random_omega(rng), inertia=np.full(3, rng.uniform(0.1, 10))).labelled("three equal inertias")
    wheel, *others = wheels(rng)
    for case in (wheel, *others, ball):
        yield case.with_leading(uneven(rng, 40 / (math.hypot(*case.args[0]) or 1.0), 25))
    t = uneven(rng, 3 / math.hypot(*wheel.args[0]), 2)
    for label, some in {"two times": slice(None), **SOME_TIMES}.items():
        yield wheel.with_leading(t[some]).labelled(f"{label}, {wheel.label}")


def spins(rng):
    """Yield cases of growth_rate_squared: each axis of the smallest, middle and largest inertia, both ways."""
    body, ball = np.sort(random_body(rng)), np.full(3, rng.uniform(0.5, 2))
    for axis in (0, 1, 2):
        bodies = [(np.roll(body, shift), "a spin", sign) for shift, sign in enumerate(rng.choice([-1, 1], 3))]
        bodies += [(random_wheel(rng), "a spin", -1), (ball, "three equal inertias", 1), (body, "no spin", 0)]
        for inertia, label, sign in bodies:
            yield Case(axis, sign * rng.uniform(1.5, 6) + 0.0, inertia=inertia).labelled(f"{label}, axis {axis}")


def on_side(rng, label, sign):
    """Return omega round the axis of the largest inertia (1) or the smallest (-1); in principal planes; a tiny body."""
    calls = [tumbling(rng, label, round_last(rng)[::sign]) for _ in range(3)]
    planes = np.array([(rng.choice([-0.5, 0.5]), 0, 1), (0, rng.choice([-1, 1]), -1)])[:, ::sign]
    calls += [tumbling(rng, f"{label}, in a principal plane", way) for way in planes]
    return [*calls, calls[0].replace(inertia=1e-6 * calls[0].kwargs["inertia"]).labelled(f"{label}, a tiny body")]


def pure_spins(rng):
    for axis, sign in ((0, 1), (0, -1), (2, 1), (2, -1)):
        yield tumbling(rng, f"pure spin about axis {axis}", sign * np.eye(3)[axis] + 0.0)


def near_separatrix(rng):
    """Yield motions next to the separatrix: C (C - B) r^2 = (1 + distance) A (B - A) p^2.

    At 1e-6, k by energy and H^2 gives the period to 4e-10, events of solve_ivp at 1e-9 to 4e-7 (RK45).
    """
    for way in np.array([(0, 1, -1e-3), (-2e-5, -1, 0)]):
        yield tumbling(rng, "omega almost about the middle axis", way)
    for distance in (1e-2, -1e-4, 1e-6, -1e-6):
        way = rng.choice([-1, 1], 3) * [1, rng.uniform(0.8, 2), math.sqrt(1 + distance)]
        yield tumbling(rng, "omega next to the separatrix, not about the middle axis", way)


ON_SEPARATRIX = np.array([[3.0, 4.0, 6.0], [2.0, 1.0, -1.0]])  # inertia, omega: 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2


def on_separatrix(rng):
    """Return motions on the separatrix, scaled so that nothing is rounded."""
    body, omega = ON_SEPARATRIX * np.array([[2.0 ** rng.integers(-5, 6)], [0.25 * rng.integers(1, 9)]])
    ways = {"pure spin about the middle axis": omega * [0, 1, 0], "omega on the separatrix": omega}
    return [Case(way, inertia=body).labelled(label) for label, way in ways.items()]


def boxes(rng):
    for R, label in attitudes(rng):
        yield R, rng.permutation(10 ** rng.uniform(-1, 1) * np.array([1, 1.7, 2.9])), f"a box, {label}"
    yield random_attitude(rng), np.full(3, 10 ** rng.uniform(-1, 1)), "a cube"


def pictured(rng):
    """Return a body with three inertias, from a time that is not 0; 401 times."""
    spin, start, inertia = rng.uniform(1, 4), rng.uniform(-2, 2), np.array([1.0, 1.7, 2.2]) * 10 ** rng.uniform(-2, 2)
    t, omega = np.linspace(start, start + rng.uniform(4, 6) / spin, 401), spin * np.array([0.5, -0.7, 0.5])
    return Case(t, random_attitude(rng), omega, inertia=inertia, radius=10 ** rng.uniform(-1, 1))
