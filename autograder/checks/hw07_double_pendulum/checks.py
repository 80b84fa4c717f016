"""Hidden checks of hw07. What is right comes from the motion of the two mass centres as complex numbers, x + iy, and
d'Alembert's principle, for any bars: the known mistakes are bars of another kind.
"""

import cmath
import functools
import math

import numpy as np
from scipy.integrate import solve_ivp

from tam570_grader import (
    array,
    check,
    distances,
    drawing,
    expect,
    expect_that,
    given,
    group,
    judge_axes_of_lengths,
    kept,
    mistimed,
    number,
    once,
    rows,
    suspect,
    uneven,
    words,
)
from tam570_grader.writing.curves import along

RESULTS = {
    "mass_matrix": array(2, 2),
    "velocity_terms": array(2),
    "gravity_terms": array(2),
    "angular_acceleration": array(2),
    "on_the_fly": group(array(2), array(2, 2)),
    "energy": number,
    "angular_momentum": number,
    "simulate": rows(4),
    "small_oscillation_frequencies": array(2),
    "wireframe": array(2, 2, 2),
    "plot_tip_path": drawing,
}
NEEDS = ("numpy", "matplotlib.figure")
MANUAL = {"c": (2, "the special cases checked, and what they showed")}

POINTWISE = 1e-8  # a few roundings make 1e-15, derivatives of energies by central differences 1e-9
# Ten equations for unscaled unknowns, one bar 1e-9 of the other, are solved to 1e-14 by LU, to 6e-6 by least squares
# or a pseudoinverse (the largest of 5000 draws); by the Schur complement of the constraints to 2e-6.
MASSLESS = 5e-5
FREQUENCY = 1e-6  # an eigenvalue of a matrix that is not symmetric, next to another: 1e-9
# RK45, DOP853 and LSODA at rtol 1e-9, atol 1e-9 are off by 1e-5 at most, sensitive starts included
FOLLOWED = 1e-4
# of m g l; the same solvers lose 5e-8 of it in ten seconds, a symplectic method of fixed steps 1e-6
ENERGY = 1e-5
NEARLY = 1e-3  # of the largest number, to say what a wrong motion is
DRAWN = 1e-3  # of the length; the path between 400 points bends by 2e-4 of it


def kinematics(theta, omega, lengths, centre):
    """Of each mass centre: its place, the velocities per unit of om1 and om2, the acceleration without alpha."""
    (l1, l2), (om1, om2) = lengths, omega
    bar1, bar2 = -1j * l1 * cmath.exp(1j * theta[0]), -1j * l2 * cmath.exp(1j * theta[1])
    places = centre * bar1, bar1 + centre * bar2
    levers = (centre * 1j * bar1, 0j), (1j * bar1, centre * 1j * bar2)
    rest = -centre * om1**2 * bar1, -(om1**2) * bar1 - centre * om2**2 * bar2
    return places, levers, rest


def dot(a, b):
    return (a.conjugate() * b).real


def terms(theta, omega, masses, lengths, gravity, *, centre=1 / 2, inertia=1 / 12, sine=1, weight=1):
    """M, f, g of bars with the mass centre at centre l and the inertia m l^2 about it; sine and weight are signs."""
    _, (one, two), rest = kinematics(theta, omega, lengths, centre)
    (m1, m2), (l1, l2) = masses, lengths
    coupling = m1 * dot(one[0], one[1]) + m2 * dot(two[0], two[1])
    M = [
        [m1 * dot(one[0], one[0]) + m2 * dot(two[0], two[0]) + inertia * m1 * l1**2, coupling],
        [coupling, m1 * dot(one[1], one[1]) + m2 * dot(two[1], two[1]) + inertia * m2 * l2**2],
    ]
    f = [sine * (m1 * dot(a, rest[0]) + m2 * dot(b, rest[1])) for a, b in zip(one, two, strict=True)]
    g = [weight * gravity * (m1 * a.imag + m2 * b.imag) for a, b in zip(one, two, strict=True)]
    return M, f, g


def accelerations(theta, omega, masses, lengths, gravity, **bars):
    M, f, g = terms(theta, omega, masses, lengths, gravity, **bars)
    pull1, pull2 = -f[0] - g[0], -f[1] - g[1]
    determinant = M[0][0] * M[1][1] - M[0][1] * M[1][0]
    return (M[1][1] * pull1 - M[0][1] * pull2) / determinant, (M[0][0] * pull2 - M[1][0] * pull1) / determinant


def forces(theta, omega, masses, lengths, gravity, **bars):
    """(2, 2): by Newton's law for bar 2, and for both bars together."""
    al1, al2 = accelerations(theta, omega, masses, lengths, gravity, **bars)
    _, levers, rest = kinematics(theta, omega, lengths, bars.get("centre", 1 / 2))
    moved = [
        m * (lever[0] * al1 + lever[1] * al2 + a + 1j * gravity)
        for m, lever, a in zip(masses, levers, rest, strict=True)
    ]
    return np.array([[sum(moved).real, sum(moved).imag], [moved[1].real, moved[1].imag]])


def energy(theta, omega, masses, lengths, gravity, **bars):
    (places, *_), M = (
        kinematics(theta, omega, lengths, bars.get("centre", 1 / 2)),
        mass_matrix(theta, masses, lengths, **bars),
    )
    return omega @ M @ omega / 2 + gravity * (masses[0] * places[0].imag + masses[1] * places[1].imag)


def angular_momentum(theta, omega, masses, lengths, *, centre=1 / 2, inertia=1 / 12):
    """Sum of r x m v and I omega."""
    places, levers, _ = kinematics(theta, omega, lengths, centre)
    velocities = [lever[0] * omega[0] + lever[1] * omega[1] for lever in levers]
    orbital = [m * (r.conjugate() * v).imag for m, r, v in zip(masses, places, velocities, strict=True)]
    return sum(orbital) + inertia * np.sum(masses * lengths**2 * omega)


def mass_matrix(theta, masses, lengths, **bars):
    return np.array(terms(theta, (0.0, 0.0), masses, lengths, 0.0, **bars)[0])


def velocity_terms(theta, omega, masses, lengths, **bars):
    return np.array(terms(theta, omega, masses, lengths, 0.0, **bars)[1])


def gravity_terms(theta, masses, lengths, gravity, **bars):
    return np.array(terms(theta, (0.0, 0.0), masses, lengths, gravity, **bars)[2])


def angular_acceleration(theta, omega, masses, lengths, gravity, **bars):
    return np.array(accelerations(theta, omega, masses, lengths, gravity, **bars))


def on_the_fly(theta, omega, masses, lengths, gravity, **bars):
    known = theta, omega, masses, lengths, gravity
    return angular_acceleration(*known, **bars), forces(*known, **bars)


def motion(t, theta, omega, masses, lengths, gravity, *, rtol=1e-11, rates=accelerations, **bars):
    """(n, 4) states at the times t."""

    def derivative(_, state):
        th1, th2, om1, om2 = state.tolist()
        return om1, om2, *rates((th1, th2), (om1, om2), masses, lengths, gravity, **bars)

    start = np.concatenate([theta, omega])
    found = solve_ivp(derivative, t[[0, -1]], start, method="DOP853", t_eval=t, rtol=rtol, atol=rtol)
    return found.y.T


def frequencies(masses, lengths, gravity, **bars):
    """By a symmetric eigenvalue problem: M^(-1/2) K M^(-1/2)."""
    stiffness = gravity_terms((math.pi / 2, math.pi / 2), masses, lengths, gravity, **bars)  # sin = 1
    inverse = np.linalg.inv(np.linalg.cholesky(mass_matrix((0.0, 0.0), masses, lengths, **bars)))
    return np.sqrt(np.linalg.eigvalsh(inverse @ np.diag(stiffness) @ inverse.T))


def wireframe(theta, lengths):
    elbow, tip = (lengths * np.exp(1j * (theta - math.pi / 2))).cumsum()
    return np.array([[[0, 0], [elbow.real, elbow.imag]], [[elbow.real, elbow.imag], [tip.real, tip.imag]]])


RIGHT = {
    "mass_matrix": mass_matrix,
    "velocity_terms": velocity_terms,
    "gravity_terms": gravity_terms,
    "angular_acceleration": angular_acceleration,
    "on_the_fly": on_the_fly,
    "energy": energy,
    "angular_momentum": angular_momentum,
    "simulate": motion,
    "small_oscillation_frequencies": frequencies,
    "wireframe": wireframe,
}

# Known mistakes

BARS = {
    "point masses at the ends of the bars; here the bars are uniform": {"centre": 1, "inertia": 0},
    "m l^2/12 where m l^2/3 belongs": {"inertia": 1 / 12 - 1 / 4},
    "m l^2/3 where m l^2/12 belongs": {"inertia": 1 / 3},
    "bars without inertia about their mass centres": {"inertia": 0},
    "the wrong sign of the sine term, that of om^2": {"sine": -1},
    "the wrong sign of gravity": {"weight": -1},
}
EARTHS = "9.81 m/s^2 for whatever gravity is given"
RELATIVE = "th2 taken as the relative angle, measured from bar 1; it is measured from straight down"
B = np.array([[1.0, 0.0], [1.0, 1.0]])  # of relative to absolute angles
BACK = np.linalg.inv(B)


def of_bars(name, bars):
    """The contract's function with other bars."""
    return lambda *args, **known: RIGHT[name](*args, **{**known, **bars})


def back(name, result):
    """A result of absolute angles turned into that of relative ones."""
    if name == "mass_matrix":
        return B.T @ result @ B
    if name in ("velocity_terms", "gravity_terms"):
        return B.T @ result
    if name == "on_the_fly":
        return BACK @ result[0], result[1]
    if name == "simulate":
        return result @ np.kron(np.eye(2), BACK.T)
    return BACK @ result if name == "angular_acceleration" else result


def relative(name):
    """The contract's function for a pendulum whose second angle is taken between the bars."""
    head = 1 if name == "simulate" else 0

    def wrong(*args, **known):
        args = [*args[:head], *(B @ arg for arg in args[head:])]
        return back(name, RIGHT[name](*args, **known))

    return wrong


def mistakes(name, *fragments, within=1e-6):
    """Suspects of a function: bars whose name has one of the fragments, and the relative angle."""
    wrong = {says: of_bars(name, bars) for says, bars in BARS.items() if any(part in says for part in fragments)}
    wrong[RELATIVE] = relative(name)
    if name in OF_GRAVITY:
        wrong[EARTHS] = of_bars(name, {"gravity": 9.81})
    return [suspect(says, within=within, **{name: variant}) for says, variant in wrong.items()]


def made(name, says, change, within=1e-6):
    """A suspect that gives change(result) for the right result of a function."""
    return suspect(says, within=within, **{name: lambda *args, **known: change(RIGHT[name](*args, **known))})


def from_zero(t, *start, **known):
    """The given state is that at t = 0."""
    if t[0] == 0:
        return motion(t, *start, **known)
    at_first = motion(np.array([0.0, t[0]]), *start, **known)[1]
    return motion(t, at_first[:2], at_first[2:], **known)


def after_a_step(t, *start, **known):
    """The start left out, and one more row at the end."""
    return motion(np.append(t, 2 * t[-1] - t[-2]), *start, **known)[1:]


def wrapped(states):
    """With angles between -pi and pi."""
    return np.hstack([(states[:, :2] + math.pi) % (2 * math.pi) - math.pi, states[:, 2:]])


OF_GRAVITY = ("gravity_terms", "angular_acceleration", "on_the_fly", "energy", "simulate")
INERTIA = ("point", "l^2", "without inertia")
SIGNS = ("sine", "gravity")
SIMULATE_SUSPECTS = [
    *mistakes("simulate", *INERTIA, *SIGNS, within=1e-3),
    made("simulate", "the columns th1, om1, th2, om2", lambda states: states[:, [0, 2, 1, 3]], 1e-3),
    made("simulate", "angles wrapped to -pi and pi", wrapped, 1e-3),
    *mistimed(motion, from_zero, within=1e-3),
    suspect("the state after a step for the start in the first row", within=1e-3, simulate=after_a_step),
]


# Inputs


def pendulum(draw, *names, **fixed):
    """Random masses, lengths and gravity, those of these names; unequal, and not of size one."""
    known = {
        "masses": 10 ** draw.uniform(-0.5, 0.7, 2),
        "lengths": 10 ** draw.uniform(-0.4, 0.4, 2),
        "gravity": draw.uniform(1.5, 25.0),
        **fixed,
    }
    return {name: known[name] for name in names or known}


def angles(draw):
    return draw.uniform(-5, 5, 2)


def rates(draw):
    return draw.uniform(0.5, 5, 2) * draw.choice([-1, 1], 2)


def moving(draw, n, *names, **fixed):
    return [given(angles(draw), rates(draw), **pendulum(draw, *names, **fixed)) for _ in range(n)]


def resting(draw, n, *names):
    return [given(angles(draw), **pendulum(draw, *names)) for _ in range(n)]


def sizes(call):
    """Moment of inertia and square of the angular velocities, for scales."""
    known, omega = call.kwargs, call.args[1] if len(call.args) > 1 else np.zeros(2)
    inertia = sum(known.get("masses", (1.0,))) * np.max(known["lengths"]) ** 2
    return inertia, np.max(omega**2) + known.get("gravity", 0.0) / np.min(known["lengths"])


RANDOM = "random angles, masses and lengths"
UNIT_BARS = {"masses": np.ones(2), "lengths": np.ones(2), "gravity": 1.0}


def plain(call):
    """(call, kind): like a random call, but with exact angles and angular velocities, or with bars that are alike."""
    (theta, *omega), known = call.args, call.kwargs
    (th1, th2), right = theta, math.pi / 2
    places = {
        "hanging straight down": (0.0, 0.0),
        "bar 1 straight down": (0.0, th2),
        "bar 2 straight down": (th1, 0.0),
        "th1 = th2": (th1, th1),
        "th2 = -th1": (th1, -th1),
        "bars at a right angle": (th1, th1 + right),
        "both bars horizontal": (right, right),
        "bar 1 horizontal to the left": (-right, th2),
        "both bars upright": (math.pi, math.pi),
        "folded upwards": (0.0, math.pi),
        "bars in line": (th1, th1 + math.pi),
        "angles beyond 2 pi": (7.5, 20.0),
        "negative angles beyond 2 pi": (-7.5, -20.0),
        "whole angles, negative": (-1.0, -2.0),
    }
    cases = [(given(np.array(place), *omega, **known), where) for where, place in places.items()]
    if omega:
        for where in ("th1 = th2", "bar 1 straight down", "both bars horizontal"):
            cases.append((given(np.array(places[where]), np.zeros(2), **known), f"{where}, at rest"))
        for how, pace in plain_rates(*omega).items():
            cases.append((given(theta, pace, **known), f"{RANDOM}, {how}"))
            cases.append((given(np.full(2, th1), pace, **known), f"th1 = th2, {how}"))
    alike = {"equal masses": ["masses"], "equal lengths": ["lengths"], "equal bars": ["masses", "lengths"]}
    for kind, names in alike.items():
        bars = {name: np.full(2, known[name][0]) for name in names if name in known}
        cases.append((given(*call.args, **{**known, **bars}), kind))
    unit = {name: UNIT_BARS[name] for name in known}
    cases.append((given(*call.args, **unit), "masses, lengths and gravity 1"))
    if "gravity" in known and omega:
        cases += [(given(*case.args, **{**known, "gravity": 0.0}), f"{kind}, no gravity") for case, kind in cases[:7]]
    return cases


def plain_rates(omega):
    """Pairs of angular velocities by what to call them."""
    om1, om2 = omega
    both = {
        "at rest": (0.0, 0.0),
        "om1 = 0": (0.0, om2),
        "om2 = 0": (om1, 0.0),
        "om1 = om2": (om1, om1),
        "om1, om2 < 0": (-abs(om1), -abs(om2)),
    }
    return {how: np.array(pace) for how, pace in both.items()}


def vanishes(name, call):
    """Whether some result is nothing but roundings, by which no mistake can be told from another."""
    result = RIGHT[name](*call.args, **call.kwargs)
    parts = result if isinstance(result, tuple) else (result,)
    least = 0.0 if len(parts) == 1 else -1.0  # ten equations leave roundings where two leave nothing
    return any(least < np.max(np.abs(part)) < 1e-9 for part in parts)


def with_plain(name, calls):
    """Random calls to a function and plain ones, each with its kind."""
    cases = [(call, kind) for call, kind in plain(calls[0]) if not vanishes(name, call)]
    return [(call, RANDOM) for call in calls] + cases


def judge(student, name, calls, scale, of, unit, hint):
    """Compare what a function gives with what is right; scale takes inertia and square of the angular velocity."""
    cases = with_plain(name, calls)
    for found, (call, kind) in zip(
        getattr(student, name).many([call.on(kind) for call, kind in cases]), cases, strict=True
    ):
        told = functools.partial(hint, found, call) if callable(hint) else hint
        expect(
            found,
            RIGHT[name](*call.args, **call.kwargs),
            within=POINTWISE,
            scale=scale(*sizes(call)) or 1.0,
            of=of,
            unit=unit,
            kind=kind,
            hint=told,
            at=call,
        )


def in_equations(found, call):
    """What to say of accelerations."""
    if not np.any(found) and call.kwargs["gravity"] == 0:
        return STILL_COUPLED
    return "put alpha back into [M]{alpha} + {f} + {g}: is it zero?"


STILL_COUPLED = "neither bar accelerates in it, but without gravity the bars still act on each other"


# The equations of motion


def coupled(change):
    """The mass matrix with change(coupling, th1 - th2, lengths) for the coupling."""

    def wrong(theta, masses, lengths):
        (one, coupling), (_, two) = mass_matrix(theta, masses, lengths)
        coupling = change(masses[1] * lengths[0] * lengths[1] / 2, coupling, theta[0] - theta[1], lengths)
        return np.array([[one, coupling], [coupling, two]])

    return wrong


def with_added(row, share):
    """The mass matrix with share(masses) l^2 added on the diagonal."""

    def wrong(theta, masses, lengths):
        added = np.zeros((2, 2))
        added[row, row] = share(*masses) * lengths[row] ** 2
        return mass_matrix(theta, masses, lengths) + added

    return wrong


def of_the_sum(theta, masses, lengths):
    return mass_matrix(theta * [1, -1], masses, lengths)


MASS_SUSPECTS = [
    *mistakes("mass_matrix", *INERTIA),
    suspect("m1 l1^2/12 in M11, where m1 l1^2/3 belongs", mass_matrix=with_added(0, lambda m1, m2: -m1 / 4)),
    suspect("m2 l2^2/12 for M22, where m2 l2^2/3 belongs", mass_matrix=with_added(1, lambda m1, m2: -m2 / 4)),
    suspect("m2 l1^2/2 in M11, where m2 l1^2 belongs", mass_matrix=with_added(0, lambda m1, m2: -m2 / 2)),
    suspect("the cosine of th1 + th2, where that of th1 - th2 belongs", mass_matrix=of_the_sum),
    suspect(
        "l1^2 in the coupling, where l1 l2 belongs",
        mass_matrix=coupled(lambda size, right, _, lengths: right * lengths[0] / lengths[1]),
    ),
    suspect(
        "l2^2 in the coupling, where l1 l2 belongs",
        mass_matrix=coupled(lambda size, right, _, lengths: right * lengths[1] / lengths[0]),
    ),
    suspect(
        "the cosine of small angles, 1 - (th1 - th2)^2/2",
        mass_matrix=coupled(lambda size, right, between, _: size * (1 - between**2 / 2)),
    ),
    suspect("the cosine of no angle, 1", mass_matrix=coupled(lambda size, *_: size)),
    suspect("no coupling", mass_matrix=coupled(lambda *_: 0.0)),
]


@check(points=1, part="a", suspects=MASS_SUSPECTS)
def mass_matrix_makes_the_kinetic_energy(student, draw):
    """mass_matrix: half of omega . M omega is the kinetic energy of the two bars."""
    judge(
        student,
        "mass_matrix",
        resting(draw, 8, "masses", "lengths"),
        lambda inertia, _: inertia,
        "[M]",
        "of m l^2",
        "write the velocities of both mass centres by the absolute angular velocities",
    )


def without_lengths(theta, omega, masses, lengths):
    """As a formula: bars in line leave no roundings."""
    return masses[1] / 2 * math.sin(theta[0] - theta[1]) * omega[::-1] ** 2 * [1, -1]


VELOCITY_SUSPECTS = [
    *mistakes("velocity_terms", "sine"),
    made(
        "velocity_terms", "twice what is right, which is {f} of point masses at the ends of the bars", lambda f: 2 * f
    ),
    made("velocity_terms", "the second one with the wrong sign", lambda f: f * [1, -1]),
    suspect("lengths of 1 m", velocity_terms=without_lengths),
]


@check(points=1, part="a", suspects=VELOCITY_SUSPECTS)
def velocity_terms_are_centripetal(student, draw):
    """velocity_terms: {f} of Lagrange's equations."""
    judge(
        student,
        "velocity_terms",
        moving(draw, 8, "masses", "lengths"),
        lambda inertia, rate2: inertia * rate2,
        "{f}",
        "of m l^2 omega^2",
        "which way does each mass centre accelerate when alpha is zero?",
    )


def with_half_of_bar_2(theta, masses, lengths, gravity):
    missing = masses[1] / 2 * gravity * lengths[0] * math.sin(theta[0])
    return gravity_terms(theta, masses, lengths, gravity) - [missing, 0.0]


GRAVITY_SUSPECTS = [
    *mistakes("gravity_terms", "point", "gravity"),
    suspect(
        "the weight of bar 2 left out of the first one",
        gravity_terms=lambda theta, masses, lengths, gravity: gravity * masses * lengths / 2 * np.sin(theta),
    ),
    made("gravity_terms", "moments that are never negative: the sign of the sine lost", np.abs),
    made("gravity_terms", "m2 g l2 in the second one, where m2 g l2/2 belongs", lambda g: g * [1, 2]),
    suspect("(m1 + m2)/2 in the first one, where m1/2 + m2 belongs", gravity_terms=with_half_of_bar_2),
]


@check(points=0.75, part="a", suspects=GRAVITY_SUSPECTS)
def gravity_terms_are_moments_of_the_weights(student, draw):
    """gravity_terms: {g}, the derivatives of the potential energy by th1 and th2."""
    judge(
        student,
        "gravity_terms",
        resting(draw, 8, "masses", "lengths", "gravity"),
        lambda inertia, rate2: inertia * rate2,
        "{g}",
        "of m g l",
        "how does the height of each mass centre change with each angle?",
    )


def of_one_mass(*state, masses, **known):
    return angular_acceleration(*state, masses=masses[[1, 1]], **known)


ALPHA_SUSPECTS = [
    *mistakes("angular_acceleration", *INERTIA, *SIGNS),
    suspect("the mass of bar 2 for both", angular_acceleration=of_one_mass),
    made("angular_acceleration", "the sign reversed: M^-1 (f + g), where -M^-1 (f + g) belongs", np.negative),
]


@check(points=0.75, part="a", suspects=ALPHA_SUSPECTS)
def accelerations_obey_the_equations(student, draw):
    """angular_acceleration: [M]{alpha} + {f} + {g} = 0, without gravity too."""
    calls = moving(draw, 8) + moving(draw, 3, gravity=0.0)
    judge(student, "angular_acceleration", calls, lambda _, rate2: rate2, "alpha", "of omega^2 + g/l", in_equations)


@once
def nearly_massless(draw):
    """Calls with one bar of a mass 1e-9 of the other's; the lighter bar, and what alpha goes over into."""
    cases = []
    for light in (1, 0):
        for _ in range(3):
            masses = draw.uniform(0.5, 4) * np.where(np.arange(2) == light, 1e-9, 1.0)
            (call,) = moving(draw, 1, masses=masses)
            cases.append((call, ("upper", "lower")[light], angular_acceleration(*call.args, **call.kwargs)))
    return cases


def massless_calls(cases):
    return [call.on(f"a nearly massless {light} bar") for call, light, _ in cases]


def judge_massless(found, cases):
    for alpha, call, (*_, expected) in zip(found, massless_calls(cases), cases, strict=True):
        expect(
            alpha,
            expected,
            within=MASSLESS,
            scale=sizes(call)[1],
            of="alpha",
            unit="of omega^2 + g/l",
            kind=call.kind,
            at=call,
            hint="below a massless bar, or above one, the other moves by an equation that you know; if it is "
            "nearly that, rows of a linear system that differ in size by 1e-9 lose the digits",
        )


@check(points=0.25, part="a", after=accelerations_obey_the_equations)
def accelerations_with_a_nearly_massless_bar(student, draw):
    """angular_acceleration keeps its digits when one bar has 1e-9 of the other's mass."""
    cases = nearly_massless(draw)
    judge_massless(student.angular_acceleration.many(massless_calls(cases)), cases)


def fly(student, draw, which):
    """Compare one of the two results of on_the_fly."""
    cases = with_plain("on_the_fly", moving(draw, 7) + moving(draw, 3, gravity=0.0))
    results = student.on_the_fly.many([call.on(kind) for call, kind in cases])
    for found, (call, kind) in zip(results, cases, strict=True):
        inertia, rate2 = sizes(call)
        scale = rate2 if which == 0 else inertia / np.max(call.kwargs["lengths"]) * rate2
        expect(
            found[which],
            on_the_fly(*call.args, **call.kwargs)[which],
            within=POINTWISE,
            scale=scale or 1.0,
            of=("alpha", "a hinge force")[which],
            unit=("of omega^2 + g/l", "of m (l omega^2 + g)")[which],
            kind=kind,
            at=call,
            hint=FLY_HINTS[which],
        )


FLY_HINTS = (
    "two bars with three equations each, and two hinges with two constraints each: ten unknowns",
    "hanging at rest, the ceiling carries both weights, and bar 1 carries bar 2: which rows, which signs?",
)


def of_ten_equations(theta, omega, masses, lengths, gravity, *, reaction=1, centripetal=1):
    """on_the_fly with, or without, the force of bar 2 on bar 1 and the centripetal acceleration at the ceiling."""
    half = np.column_stack([np.sin(theta), -np.cos(theta)]) * np.reshape(lengths, (2, 1)) / 2
    across = [np.array([-y, x]) for x, y in half]
    matrix, known, one = np.zeros((10, 10)), np.zeros(10), np.eye(2)
    A1, A2, CEILING, ELBOW = slice(0, 2), slice(2, 4), slice(6, 8), slice(8, 10)  # alpha1 is 4, alpha2 is 5
    for bar, (own, m) in enumerate(zip((A1, A2), masses, strict=True)):
        matrix[own, own], known[own] = m * one, [0, -m * gravity]
        matrix[4 + bar, 4 + bar] = m * lengths[bar] ** 2 / 12
    matrix[A1, CEILING], matrix[A1, ELBOW], matrix[A2, ELBOW] = -one, reaction * one, -one
    matrix[4, CEILING], matrix[4, ELBOW], matrix[5, ELBOW] = across[0], across[0], across[1]
    matrix[CEILING, A1], matrix[CEILING, 4] = one, -across[0]
    known[CEILING] = -centripetal * omega[0] ** 2 * half[0]
    matrix[ELBOW, A1], matrix[ELBOW, 4], matrix[ELBOW, A2], matrix[ELBOW, 5] = one, across[0], -one, across[1]
    known[ELBOW] = omega[0] ** 2 * half[0] + omega[1] ** 2 * half[1]
    found = np.linalg.solve(matrix, known)
    return found[4:6], found[6:].reshape(2, 2)


def at_rates(change):
    """on_the_fly with other angular velocities, change(om1, om2)."""
    return lambda theta, omega, **known: on_the_fly(theta, np.array(change(*omega)), **known)


FLY_SUSPECTS = [
    *mistakes("on_the_fly", *INERTIA, *SIGNS),
    suspect("om2 - om1 for the angular velocity of bar 2", on_the_fly=at_rates(lambda om1, om2: (om1, om2 - om1))),
    suspect("om1 + om2 for the angular velocity of bar 2", on_the_fly=at_rates(lambda om1, om2: (om1, om1 + om2))),
    suspect(
        "the force of bar 2 left out of bar 1's linear momentum balance",
        on_the_fly=functools.partial(of_ten_equations, reaction=0),
    ),
    suspect(
        "the centripetal acceleration of bar 1 left out at the ceiling's hinge",
        on_the_fly=functools.partial(of_ten_equations, centripetal=0),
    ),
]


def other_forces(change):
    def wrong(*args, **known):
        alpha, hinges = on_the_fly(*args, **known)
        return alpha, change(hinges, known["masses"], known["gravity"])

    return wrong


def without_centripetal_force(theta, omega, **known):
    alpha, hinges = on_the_fly(theta, omega, **known)
    outwards = np.array([math.sin(theta[0]), -math.cos(theta[0])])
    missing = known["masses"][0] * known["lengths"][0] / 2 * omega[0] ** 2 * outwards
    return alpha, hinges + [missing, np.zeros(2)]


FORCE_SUSPECTS = [
    suspect(
        "the centripetal acceleration of bar 1's own mass centre left out in the first row",
        on_the_fly=without_centripetal_force,
    ),
    *(
        suspect(says, on_the_fly=other_forces(change))
        for says, change in {
            "the force of bar 2 on bar 1 in the second row": lambda F, *_: F * [[1], [-1]],
            "the forces of the bars on the ceiling and of bar 2 on bar 1": lambda F, *_: -F,
            "the force of bar 1 on the ceiling in the first row": lambda F, *_: F * [[-1], [1]],
            "the two rows swapped": lambda F, *_: F[::-1],
            "rows and columns swapped": lambda F, *_: F.T,
            "forces without the weights": lambda F, m, g: F - [[0, (m[0] + m[1]) * g], [0, m[1] * g]],
            "the weight of bar 1 left out of the first row": lambda F, m, g: F - [[0, m[0] * g], [0, 0]],
            "in the first row the resultant of bar 1's hinges": lambda F, *_: np.array([F[0] - F[1], F[1]]),
        }.items()
    ),
]


@check(points=0.5, part="a", suspects=FLY_SUSPECTS)
def free_bars_accelerate_as_lagranges(student, draw):
    """on_the_fly: alpha from two free bars and two hinge constraints."""
    fly(student, draw, 0)


@check(points=0.75, part="a", suspects=FORCE_SUSPECTS, after=free_bars_accelerate_as_lagranges)
def hinge_forces_balance(student, draw):
    """on_the_fly: with the hinge forces and the weights each bar obeys Newton's law."""
    fly(student, draw, 1)


@check(points=0.25, part="a", after=free_bars_accelerate_as_lagranges)
def free_bars_with_a_nearly_massless_one(student, draw):
    """on_the_fly keeps its digits when one bar has 1e-9 of the other's mass, and when both hang straight down."""
    cases = nearly_massless(draw)
    judge_massless([alpha for alpha, _ in student.on_the_fly.many(massless_calls(cases))], cases)
    (call,) = moving(draw, 1)
    for omega, kind in ((np.zeros(2), "hanging at rest"), (call.args[1], "hanging straight down, moving")):
        still = given(np.zeros(2), omega, **call.kwargs)
        alpha, _ = student.on(kind).on_the_fly(*still.args, **still.kwargs)
        expect(
            alpha,
            0.0,
            within=POINTWISE,
            scale=sizes(still)[1],
            of="alpha",
            unit="of omega^2 + g/l",
            kind=kind,
            at=still,
            hint=FLY_HINTS[0],
        )


# Energy, angular momentum


def raised(*args, **known):
    """The energy with its zero at the lowest position."""
    (m1, m2), (l1, l2) = known["masses"], known["lengths"]
    return energy(*args, **known) + known["gravity"] * (m1 * l1 / 2 + m2 * (l1 + l2 / 2))


def spun_relative(theta, omega, masses, lengths, gravity):
    """With om2 - om1 for the rate at which bar 2 turns about its mass centre."""
    spin = masses[1] * lengths[1] ** 2 / 24
    return energy(theta, omega, masses, lengths, gravity) + spin * ((omega[1] - omega[0]) ** 2 - omega[1] ** 2)


def without_coupling(theta, omega, masses, lengths, gravity):
    coupling = mass_matrix(theta, masses, lengths)[0, 1]
    return energy(theta, omega, masses, lengths, gravity) - coupling * omega[0] * omega[1]


def without_spin_of_bar_2(theta, omega, masses, lengths, gravity):
    return energy(theta, omega, masses, lengths, gravity) - masses[1] * lengths[1] ** 2 / 24 * omega[1] ** 2


def uncoupled(theta, omega, **known):
    M = mass_matrix(theta, **known)
    return M[0, 0] * omega[0] + M[1, 1] * omega[1]


ENERGY_SUSPECTS = [
    *mistakes("energy", *INERTIA),
    suspect("the potential energy zero at the lowest position", energy=raised),
    suspect("om2 - om1 for the rate at which bar 2 turns", energy=spun_relative),
    suspect("the kinetic energy without its term with om1 om2", energy=without_coupling),
    suspect("the kinetic energy without the turning of bar 2, I om2^2/2", energy=without_spin_of_bar_2),
    suspect(
        "the sign of the potential energy reversed",
        energy=lambda *args, gravity, **known: energy(*args, **known, gravity=-gravity),
    ),
    suspect("kinetic energy alone", energy=lambda *args, gravity, **known: energy(*args, **known, gravity=0.0)),
]
MOMENTUM_SUSPECTS = [
    *mistakes("angular_momentum", *INERTIA),
    suspect("the coupling left out: M11 om1 + M22 om2", angular_momentum=uncoupled),
    suspect(
        "I om2 of bar 2 left out",
        angular_momentum=lambda theta, omega, masses, lengths: (
            angular_momentum(theta, omega, masses, lengths) - masses[1] * lengths[1] ** 2 / 12 * omega[1]
        ),
    ),
    suspect(
        "the momentum conjugate to th2 alone",
        angular_momentum=lambda theta, omega, **known: (mass_matrix(theta, **known) @ omega)[1],
    ),
    suspect(
        "the momentum conjugate to th1 alone",
        angular_momentum=lambda theta, omega, **known: (mass_matrix(theta, **known) @ omega)[0],
    ),
]


@check(points=0.75, part="a", suspects=ENERGY_SUSPECTS)
def energy_is_kinetic_and_potential(student, draw):
    """energy: of both bars, the potential energy zero at the ceiling."""
    judge(
        student,
        "energy",
        moving(draw, 7) + moving(draw, 3, gravity=0.0),
        lambda inertia, rate2: inertia * rate2,
        "the energy",
        "of m l (l omega^2 + g)",
        "each bar: m v^2/2, I omega^2/2, m g y of its centre",
    )


@check(points=0.75, part="a", suspects=MOMENTUM_SUSPECTS)
def angular_momentum_is_about_the_ceiling(student, draw):
    """angular_momentum: of both bars, about the ceiling hinge."""
    judge(
        student,
        "angular_momentum",
        moving(draw, 8, "masses", "lengths"),
        lambda inertia, rate2: inertia * math.sqrt(rate2),
        "the angular momentum",
        "of m l^2 omega",
        "each bar: r x m v of its mass centre, r from the ceiling hinge, and I omega",
    )


# Motion


def since(start):
    return "times from zero on" if start == 0 else f"times from {'below' if start < 0 else 'above'} zero on"


@once
def motions(draw, starts):
    """Calls with random starts, times from `starts` on for a period or so, and the right states."""
    cases = []
    for start in starts:
        known = pendulum(draw)
        time = math.sqrt(np.max(known["lengths"]) / known["gravity"])
        turns = 2 * math.pi * np.sign(start) * np.array([1, -1])  # an angle beyond pi stays there
        theta, omega = draw.uniform(-2, 2, 2) + turns, draw.uniform(-1, 1, 2) / time
        call = given(uneven(draw, draw.uniform(4, 6) * time, 40, start), theta, omega, **known)
        cases.append((call, motion(*call.args, **call.kwargs), f"a random start, {since(start)}"))
    return cases


# theta and omega over the usual rate of a motion from there, what is not random
PLAIN_STARTS = {
    "hanging at rest": ((0.0, 0.0), (0.0, 0.0), {}),
    "a start from hanging straight down": ((0.0, 0.0), (0.8, -0.5), {}),
    "a start with bar 1 straight down": ((0.0, 1.0), (0.5, 0.0), {}),
    # more than half a turn from one time to another: angles unwrapped from row to row are off by whole turns
    "a fast start with th1 = th2, om1 = om2": ((0.3, 0.3), (4.5, 4.5), {}),
    "a start with negative angles": ((-0.5, -1.0), (0.3, 0.6), {}),
    "masses, lengths and gravity 1": ((1.0, 0.0), (0.0, 1.0), UNIT_BARS),
    "equal bars": ((0.7, -1.2), (0.4, 0.6), {"masses": np.full(2, 1.7), "lengths": np.full(2, 0.6)}),
}


@once
def plain_motions(draw):
    """As `motions`, at two or three times, from plain starts."""
    cases = []
    for kind, (theta, omega, fixed) in PLAIN_STARTS.items():
        for count in (2, 3):
            known = pendulum(draw, **fixed)
            time = math.sqrt(np.max(known["lengths"]) / known["gravity"])
            t = uneven(draw, draw.uniform(1.5, 2.5) * time, count, draw.uniform(-3, 3))
            call = given(t, np.array(theta), np.array(omega) / time, **known)
            cases.append((call, motion(*call.args, **call.kwargs), f"{kind}, {count} times, {since(t[0])}"))
    return cases


@once
def in_turn(draw):
    """As `motions`, a motion and others of which one thing alone is another: what is kept from a call is wrong then."""
    known = pendulum(draw)
    time = math.sqrt(np.max(known["lengths"]) / known["gravity"])

    def times():
        return uneven(draw, draw.uniform(1.5, 2.5) * time, 4, draw.uniform(-3, 3))

    first = times(), draw.uniform(-2, 2, 2), draw.uniform(-1, 1, 2) / time
    # of two numbers one changes: masses alone that grow alike change nothing
    others = times(), first[1] + [0.0, 0.5], first[2] + [0.0, 0.5 / time]
    calls = [(given(*first, **known), "a motion that is asked for again")]
    for k, name in enumerate(("other times", "another theta", "another omega")):
        calls.append((given(*first[:k], others[k], *first[k + 1 :], **known), BUT_FOR + name))
    for name, value in known.items():
        more = draw.uniform(1.2, 1.5)
        other = value * np.array([more, 1.0]) if np.ndim(value) else value * more
        calls.append((given(*first, **{**known, name: other}), f"{BUT_FOR}other {name}"))
    return [(call, motion(*call.args, **call.kwargs), kind) for call, kind in calls]


BUT_FOR = "the motion of a call before, but for "


def energy_along(states, call):
    """What becomes of the energy along a motion, for a picture."""
    known = call.kwargs
    scale = known["gravity"] * np.sum(known["masses"]) * np.sum(known["lengths"]) or 1.0
    return kept(call.args[0], drift(states, known) / scale, within=ENERGY, of="the energy", unit="of m g l")


@check(points=0.75, part="a", suspects=SIMULATE_SUSPECTS)
def simulation_follows_the_equations(student, draw):
    """simulate: angles and angular velocities at uneven times, whatever t[0] is."""
    cases = motions(draw, (0.0, 2.3, -1.7)) + plain_motions(draw) + in_turn(draw)
    for states, (call, expected, kind) in zip(
        student.simulate.many([call.on(kind) for call, _, kind in cases]), cases, strict=True
    ):
        largest = np.abs(expected).max(0).reshape(2, 2).max(1)
        expect(
            states,
            expected,
            within=FOLLOWED,
            scale=np.repeat(np.where(largest, largest, 1.0), 2),
            of="the state",
            unit="of the largest angle or angular velocity",
            t=call.args[0],
            at=call,
            kind=kind,
            hint=functools.partial(of_motion, states, expected, kind),
            partial={1e-3: 0.5},
            keeps=functools.partial(energy_along, states, call),
        )


def of_motion(states, expected, kind):
    """What to say of a wrong motion: what it is instead, if that can be told."""
    if (states == states[0]).all():
        return "every row is the start"
    if kind.startswith(BUT_FOR):
        return "is something kept from one call to the next?"
    turns = np.rint((states - expected) / [2 * math.pi, 2 * math.pi, np.inf, np.inf])
    if turns.any() and np.max(np.abs(states - expected - 2 * math.pi * turns)) <= NEARLY * np.abs(expected).max():
        return "it is off by whole turns alone, as if an angle were wrapped; angles are never wrapped"
    return (
        "is the first row the start? are the tolerances of the integrator tight, and the states at t its own, not "
        "interpolated linearly?"
    )


def drift(states, known):
    """Energy along a motion, from its start, relative to m g l of both bars; the bars may be without gravity."""
    values = np.array([energy(state[:2], state[2:], **known) for state in states])
    return values - values[0]


@check(points=0.5, part="a", after=simulation_follows_the_equations)
def energy_is_conserved_from_horizontal(student, draw):
    """simulate: from (pi/2, pi/2) at rest the energy stays for ten seconds."""
    known = pendulum(draw, masses=draw.uniform(0.5, 2.0, 2), lengths=draw.uniform(0.7, 1.3, 2), gravity=9.81)
    t = uneven(draw, 10.0, 101, 0.0)
    start = "a start at rest, both bars horizontal"
    states = student.on(start).simulate(t, np.full(2, math.pi / 2), np.zeros(2), **known)
    scale = 9.81 * np.sum(known["masses"]) * np.sum(known["lengths"])
    expect_that(np.ptp(states[:, 0]) > 1, "the bars do not move", kind=start)
    expect(
        drift(states, known),
        0.0,
        within=ENERGY,
        scale=scale,
        of="the energy",
        unit="of m g l",
        t=t,
        at=known,
        kind=start,
        hint="tighter tolerances, or a smaller step",
        partial={1e-4: 0.75, 1e-3: 0.5, 1e-2: 0.25},
    )


@check(points=0.25, part="a", after=simulation_follows_the_equations)
def momentum_is_conserved_without_gravity(student, draw):
    """simulate: without gravity energy and angular momentum stay."""
    (call,) = moving(draw, 1, gravity=0.0)
    t, bars = uneven(draw, 3.0, 40, 0.0), {name: call.kwargs[name] for name in ("masses", "lengths")}
    states = student.on("a pendulum without gravity").simulate(t, *call.args, **call.kwargs)
    values = np.array([angular_momentum(state[:2], state[2:], **bars) for state in states])
    inertia, rate2 = sizes(call)
    expect(
        values,
        angular_momentum(*call.args, **bars),
        within=ENERGY,
        scale=inertia * math.sqrt(rate2),
        t=t,
        at=call,
        of="the angular momentum",
        unit="of m l^2 omega",
        kind="a pendulum without gravity",
        hint=functools.partial(of_no_gravity, states),
    )
    expect(
        drift(states, call.kwargs),
        0.0,
        within=ENERGY,
        scale=inertia * rate2,
        of="the energy",
        t=t,
        at=call,
        unit="of m l^2 omega^2",
        kind="a pendulum without gravity",
    )
    theta = call.args[0]
    expect(
        student.simulate(t[[0, -1]], theta, np.zeros(2), **call.kwargs),
        np.tile([*theta, 0.0, 0.0], (2, 1)),
        within=ENERGY,
        of="an angle or angular velocity",
        unit="rad or rad/s",
        t=t[[0, -1]],
        at=call,
        kind="a pendulum at rest without gravity, two times",
        hint="what would make it move?",
    )


def of_no_gravity(states):
    """What to say of a motion without gravity."""
    if np.allclose(states[:, 2:], states[0, 2:], rtol=NEARLY, atol=0):
        return STILL_COUPLED
    return "without gravity the same equations hold; nothing may be divided by it"


# Small oscillations


FREQUENCY_SUSPECTS = [
    *(
        suspect(says, small_oscillation_frequencies=of_bars("small_oscillation_frequencies", bars))
        for says, bars in BARS.items()
        if "sign" not in says and bars != {"inertia": 1 / 12 - 1 / 4}  # it has no real frequencies
    ),
    suspect(
        "the frequencies of equal bars, of the first one's length",
        small_oscillation_frequencies=lambda **known: np.sqrt(
            known["gravity"] / known["lengths"][0] * (3 + np.array([-6, 6]) / math.sqrt(7))
        ),
    ),
    suspect(
        "the frequencies of two bars that each hang from a ceiling",
        small_oscillation_frequencies=lambda **known: np.sort(np.sqrt(1.5 * known["gravity"] / known["lengths"])),
    ),
    suspect("frequencies in Hz", small_oscillation_frequencies=lambda **known: frequencies(**known) / (2 * math.pi)),
    suspect("the squares of the frequencies", small_oscillation_frequencies=lambda **known: frequencies(**known) ** 2),
    suspect(
        "the coupling of [M] left out",
        small_oscillation_frequencies=lambda **known: np.sort(
            np.sqrt(
                gravity_terms((math.pi / 2, math.pi / 2), **known)
                / np.diag(mass_matrix((0.0, 0.0), known["masses"], known["lengths"]))
            )
        ),
    ),
    suspect(
        "the frequencies in descending order", small_oscillation_frequencies=lambda **known: frequencies(**known)[::-1]
    ),
]


def judge_frequencies(student, calls, kind, hint):
    for found, call in zip(student.on(kind).small_oscillation_frequencies.many(calls), calls, strict=True):
        known = call.kwargs
        scale = math.sqrt(known["gravity"] / np.min(known["lengths"])) or 1.0
        right = frequencies(**known)
        expect(
            found,
            right,
            within=FREQUENCY,
            scale=scale,
            of="a frequency",
            unit="of sqrt(g/l)",
            kind=kind,
            at=call,
            hint=functools.partial(of_order, found, right, hint),
        )


def of_order(found, right, hint):
    swapped = np.allclose(np.sort(found), right, rtol=FREQUENCY, atol=0)
    return "they are right but not in ascending order" if swapped else hint


@check(points=0.5, part="a", suspects=FREQUENCY_SUSPECTS)
def small_oscillations_have_two_frequencies(student, draw):
    """small_oscillation_frequencies: of [M]{th}'' + [K]{th} = 0 about hanging straight down."""
    judge_frequencies(
        student,
        [given(**pendulum(draw)) for _ in range(10)],
        "random masses and lengths",
        "for small angles sin th is th, and terms with omega^2 are nothing",
    )


@check(points=0.25, part="a", after=small_oscillations_have_two_frequencies)
def frequencies_in_special_cases(student, draw):
    """small_oscillation_frequencies: equal bars, a nearly massless bar, no gravity."""
    length, heavy = draw.uniform(0.5, 2), draw.uniform(0.5, 2)
    special = {
        "equal bars": {"masses": np.full(2, heavy), "lengths": np.full(2, length)},
        "equal masses": {"masses": np.full(2, heavy)},
        "equal lengths": {"lengths": np.full(2, length)},
        "masses, lengths and gravity 1": UNIT_BARS,
        "equal bars, no gravity": {"masses": np.full(2, heavy), "lengths": np.full(2, length), "gravity": 0.0},
        "a nearly massless lower bar": {
            "masses": heavy * np.array([1.0, 1e-9]),
            "lengths": length * np.array([1, 1.6]),
        },
        "a nearly massless upper bar": {"masses": heavy * np.array([1e-9, 1.0])},
        "no gravity": {"gravity": 0.0},
    }
    for kind, fixed in special.items():
        judge_frequencies(student, [given(**pendulum(draw, **fixed))], kind, "what should this case give?")


# Pictures


def turned(theta, lengths, *, x, y):
    """The wireframe with other unit vectors along the bars."""
    ends = np.cumsum(np.array([[length * x(th), length * y(th)] for th, length in zip(theta, lengths, strict=True)]), 0)
    return np.array([[np.zeros(2), ends[0]], ends])


WIRE_SUSPECTS = [
    suspect("th2 taken as measured from bar 1: bar 2 drawn at th1 + th2", wireframe=relative("wireframe")),
    suspect(
        "bar 2 drawn at th2 - th1; th2 is measured from straight down",
        wireframe=lambda theta, lengths: wireframe(theta - [0, theta[0]], lengths),
    ),
    suspect("y pointing down", wireframe=lambda theta, lengths: turned(theta, lengths, x=math.sin, y=math.cos)),
    suspect("angles from the x axis", wireframe=lambda theta, lengths: turned(theta, lengths, x=math.cos, y=math.sin)),
    suspect("angles clockwise positive", wireframe=lambda theta, lengths: wireframe(-theta, lengths)),
    suspect(
        "the tip as seen from the elbow; both points of a bar are seen from the ceiling",
        wireframe=lambda theta, lengths: (
            wireframe(theta, lengths) - [[[0, 0], [0, 0]], [[0, 0], wireframe(theta, lengths)[0, 1]]]
        ),
    ),
    suspect(
        "both bars at the ceiling hinge",
        wireframe=lambda theta, lengths: (
            wireframe(theta, lengths) - [[[0, 0], [0, 0]], [wireframe(theta, lengths)[0, 1]] * 2]
        ),
    ),
]


@check(points=0.5, part="a", suspects=WIRE_SUSPECTS)
def wireframe_shows_the_bars(student, draw):
    """wireframe: ceiling hinge to elbow, elbow to tip."""
    judge(
        student,
        "wireframe",
        [given(angles(draw), lengths=10 ** draw.uniform(-0.4, 0.4, 2)) for _ in range(8)],
        lambda *_: 1.0,
        "an end of a bar",
        "m",
        "theta zero is down, a positive angle to the right",
    )


@once
def tip_path(draw):
    """A call, and the right paths of elbow and tip."""
    known = pendulum(draw)
    time = math.sqrt(np.max(known["lengths"]) / known["gravity"])
    theta, omega = draw.uniform(1, 2, 2) * draw.choice([-1, 1], 2), draw.uniform(-1, 1, 2) / time
    # long enough to go to and fro, not from zero: a path from there has another end
    t = (draw.choice([-1, 1]) * draw.uniform(1, 3) + np.linspace(0.0, 8.0, 601)) * time
    call = given(t, theta, omega, **known)
    frames = [wireframe(state[:2], known["lengths"]) for state in motion(*call.args, **call.kwargs)]
    return call, *np.array(frames)[:, :, 1].swapaxes(0, 1)


def arc_length(path):
    return np.sum(np.linalg.norm(np.diff(path, axis=0), axis=1))


@check(points=0.5, part="d")
def tip_path_is_drawn(student, draw):
    """plot_tip_path draws the tip's path from t[0] to t[-1], at equal scales."""
    call, elbows, tips = tip_path(draw)
    picture = student.on("t[0] not 0").plot_tip_path.draw(*call.args, **call.kwargs)
    expect_that(
        len(picture.lines) == 1,
        f"there are {len(picture.lines)} curves on the axes, not one",
        hint="fewer than ten points are no curve",
    )
    scale, curve = np.sum(call.kwargs["lengths"]), along(picture.lines[0], tips)
    expect(
        curve[[0, -1]],
        tips[[0, -1]],
        within=DRAWN,
        scale=scale,
        of="an end of the curve",
        unit="of l1 + l2",
        hint=functools.partial(of_path, curve, elbows, tips, DRAWN * scale),
        at=call,
    )
    for points, path, of, within in (
        (curve, tips, "a point of the curve", DRAWN),
        (tips, curve, "a point that the tip passes", 10 * DRAWN),  # the curve may have fewer points
    ):
        expect(
            distances(points, path),
            0.0,
            within=within,
            scale=scale,
            of=of,
            unit="of l1 + l2",
            hint="is it the tip of bar 2?",
            at=call,
        )
    # a curve through the same points in another order is longer; one of fewer points is shorter
    in_order = picture.lines[0].scatter or arc_length(curve) < 1.05 * arc_length(tips)
    expect_that(
        in_order,
        "the curve goes to and fro between the points of the path",
        at=call,
        hint="its points belong in the order of time",
    )
    judge_axes_of_lengths(picture)
    swapped = "y" in words(picture.xlabel) and "x" in words(picture.ylabel)
    expect_that(not swapped, "the label of x stands at the axis of y")


def of_path(curve, elbows, tips, within):
    """What to say of a curve that does not begin or end where the tip does."""
    others = {
        "it is the elbow's path": elbows,
        "it is the path of bar 2's mass centre": (elbows + tips) / 2,
        "it is the tip's path as seen from the elbow": tips - elbows,
    }
    for says, path in others.items():
        if np.allclose(curve[[0, -1]], path[[0, -1]], rtol=0, atol=within):
            return says
    return "it begins at the tip's place at t[0] and ends at that at t[-1]"
