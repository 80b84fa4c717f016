"""Hidden checks of hw04. What is right comes from a matrix exponential and from the oscillator's (Fradkin's) tensor."""

import math
from functools import partial

import numpy as np
from scipy.linalg import expm

from tam570_grader import (
    SOME_TIMES,
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
)
from tam570_grader.writing.curves import along

RESULTS = {
    "state_derivative": array(6),
    "simulate": rows(6),
    "solution": rows(6),
    "energy": number,
    "orbit": group(array(3), array(2, 3)),
    "project": array("n", 2),
    "plot_projection": drawing,
}
NEEDS = ("numpy", "matplotlib.figure")
OFF_LIMITS = {"*": ("tam570.lectures",)}
MANUAL = {"b": (2, "the wildest motion found, with its plot"), "c": (2, "why nothing wild can happen")}

POINTWISE = 1e-9  # a few roundings make 1e-14
TRAJECTORY = 1e-5  # solve_ivp at rtol 1e-9, atol 1e-9 is off by less than 1e-6 after three periods
ENERGY = 1e-5  # the same solvers lose less than 1e-6 of it in ten periods
NEARLY = 1e-2  # of the size; below it a right equation is solved coarsely, to choose the words
# Of the square of the larger axis. Axes that are sought along a simulated orbit are off by up to 8e-9 (LSODA at rtol
# 1e-9, atol 1e-9). A circle's by their sum and difference, sqrt(r^2 + v^2/k^2 +- 2 abs(r x v)/k), are good to half of
# the digits, where the difference is the root of a rounding: 1.5e-8; of ten roundings it is 5e-8.
TENSOR = 1e-7
# Of the motion's size; no ellipse counts as smaller. A zero axis comes out as the rounding of |centre|, and its square
# as that of |centre|^2, 1e-15 of the size's square, if it is a difference of such: TENSOR * NOUGHT^2 lets both pass.
NOUGHT = 1e-3
RIGHT_ANGLE = 1e-7  # of the larger axis, along the smaller; eigenvectors are good to rounding over the gap
SAMPLES = 401  # every 2nd, 4th, 5th, 8th, 10th or 20th is a series that ends with the last
DRAWN = 1e-3  # of the picture; chords of the 400 points that it is compared with leave the path by 1e-5
PASSED = 2e-2  # of the picture; chords of a line of twenty points leave the path by (3.8/20)^2/8 = 5e-3


def parameters(draw, *, gravity=None):
    """A random mass, stiffness and gravity; the spring is stretched by 0.2 to 5 m by the weight."""
    stiffness, sag = 10 ** draw.uniform(-0.3, 1.3), draw.uniform(0.2, 5.0)
    strength = draw.uniform(2.0, 25.0) if gravity is None else gravity
    mass = 10 ** draw.uniform(-0.5, 0.5) if gravity == 0 else stiffness * sag / strength
    return {"mass": mass, "stiffness": stiffness, "gravity": strength}


def rate_of(mass, stiffness, gravity):
    return math.sqrt(stiffness / mass)


def start(draw, k):
    """A random position and velocity of similar importance."""
    return draw.normal(size=3) * draw.uniform(1, 3), k * draw.normal(size=3) * draw.uniform(1, 3)


def generator(mass, stiffness, gravity):
    """The matrix of the linear equation for (r, v, 1)."""
    matrix = np.zeros((7, 7))
    matrix[:3, 3:6] = np.eye(3)
    matrix[3:6, :3] = -stiffness / mass * np.eye(3)
    matrix[5, 6] = -gravity
    return matrix


def motion(t, position, velocity, *, mass, stiffness, gravity):
    """The state at times t, with position and velocity at t = 0."""
    matrix = generator(mass, stiffness, gravity)
    return np.array([expm(matrix * time) @ [*position, *velocity, 1.0] for time in t])[:, :6]


def extent(position, velocity, *, mass, stiffness, gravity):
    """The size of the motion, m, and of its velocities, m/s: six numbers for the six of a state."""
    k = rate_of(mass, stiffness, gravity)
    length = np.linalg.norm(position) + np.linalg.norm(velocity) / k + gravity / k**2
    return np.array([length] * 3 + [k * length] * 3)


def size(position, velocity, known):
    """As `extent`; of a mass at rest for good at the origin, 1."""
    return extent(position, velocity, **known) if np.any([*position, *velocity, known["gravity"]]) else np.ones(6)


def cases(draw, number, without=2):
    """Random starts and parameters, the last ones without gravity."""
    found = []
    for gravity in [None] * (number - without) + [0.0] * without:
        known = parameters(draw, gravity=gravity)
        found.append((*start(draw, rate_of(**known)), known))
    return found


WHOLE = {"mass": 1.0, "stiffness": 1.0, "gravity": 1.0}
PLAIN = {
    "at rest": lambda r, v, centre: (r, 0 * v),
    "at the origin": lambda r, v, centre: (0 * r, v),
    "at rest at the origin": lambda r, v, centre: (0 * r, 0 * v),
    "at the place of rest": lambda r, v, centre: (centre, v),
    "above the origin, going up": lambda r, v, centre: (abs(r) * Z, abs(v) * Z),
    "below the origin, going down": lambda r, v, centre: (-abs(r) * Z, -abs(v) * Z),
    "level with the origin": lambda r, v, centre: (r * (1 - Z), v * (1 - Z)),
    "in the plane y = 0": lambda r, v, centre: (r * [1, 0, 1], v * [1, 0, 1]),
}  # kind: the position and velocity, of random ones and the place of rest


@once
def plain_cases(draw):
    """As `cases`, each with its kind: positions and velocities with zeros, with gravity and without; whole numbers."""
    found = []
    for kind, plain in PLAIN.items():
        for r, v, known in cases(draw, 2, 1):
            centre = -known["mass"] * known["gravity"] / known["stiffness"] * Z
            without = "" if known["gravity"] else ", without gravity"
            found.append((*plain(r, v, centre), known, f"a mass {kind}{without}"))
    whole = np.array([1.0, -1.0, 2.0]), np.array([-1.0, 1.0, 1.0])
    return [*found, (*whole, WHOLE, "whole numbers"), (whole[0], np.zeros(3), WHOLE, "whole numbers, at rest")]


@once
def plain_motions(draw, shifted):
    """As `timed`, two times each, with the kind of case; shifted times need not start at zero."""
    found = []
    for r, v, known, kind in plain_cases(draw):
        period = 2 * math.pi / rate_of(**known)
        t = np.array([0.0, draw.uniform(0.3, 1.3) * period])
        later = shifted * draw.integers(2) * draw.uniform(-1, 1) * period
        found.append(((t + later, motion(t, r, v, **known), (r, v, known)), kind))
    return found


def judge_plain_motions(student, name, found, within, hint):
    for case, kind in found:
        judge_motion(student, name, [case], within, f"two times, {kind}", hint)


def named(calls, found):
    """Calls with the kinds of the cases, which come last in each."""
    return [call.on(kind) for call, (*_, kind) in zip(calls, found, strict=True)]


# The equations


def wrong_force(says, force):
    """With force(r, length, mass, stiffness, gravity) in place of the right one."""

    def derivative(t, state, *, mass, stiffness, gravity):
        r = np.asarray(state[:3])
        return np.hstack([state[3:], force(r, np.linalg.norm(r), mass, stiffness, gravity) / mass])

    return suspect(says, state_derivative=derivative)


Z = np.array([0.0, 0.0, 1.0])
FORCE_SUSPECTS = [
    wrong_force("gravity pulling up", lambda r, d, m, k, g: -k * r + m * g * Z),
    wrong_force("a spring with a rest length of 1 m", lambda r, d, m, k, g: -k * (d - 1) / d * r - m * g * Z),
    wrong_force("the equilibrium at the origin: no weight", lambda r, d, m, k, g: -k * r),
    wrong_force("a weight without the mass in it", lambda r, d, m, k, g: -k * r - g * Z),
    wrong_force("the spring's force not divided by the mass", lambda r, d, m, k, g: -m * k * r - m * g * Z),
    wrong_force("a spring that pushes", lambda r, d, m, k, g: k * r - m * g * Z),
    wrong_force("the force for the acceleration: divide by the mass", lambda r, d, m, k, g: m * (-k * r - m * g * Z)),
]


@check(points=1.5, part="a", suspects=FORCE_SUSPECTS)
def derivative_is_velocity_and_force_over_mass(student, draw):
    """state_derivative: the velocity, and the acceleration by the spring and the weight."""
    found = [(*case, "a random state") for case in cases(draw, 12)] + plain_cases(draw)
    calls = [given(draw.uniform(-5, 5), np.hstack([r, v]), **known) for r, v, known, _ in found]
    for rates, call, (r, v, known, kind) in zip(
        student.state_derivative.many(named(calls, found)), calls, found, strict=True
    ):
        k = rate_of(**known)
        expect(
            rates,
            (generator(**known) @ [*r, *v, 1.0])[:6],
            within=POINTWISE,
            scale=k * size(r, v, known),
            of="a rate",
            unit="of its size",
            kind=kind,
            at=call,
            hint="which two forces act on the mass, and which way, when it is below the origin?",
        )


def wrong_energy(says, potential):
    """With potential(r, mass, stiffness, gravity) in place of the right one."""

    def total(state, *, mass, stiffness, gravity):
        r, v = np.asarray(state[:3]), np.asarray(state[3:])
        return mass * v @ v / 2 + potential(r, mass, stiffness, gravity)

    return suspect(says, energy=total)


ENERGY_SUSPECTS = [
    wrong_energy("the weight's potential energy of the wrong sign", lambda r, m, k, g: k * r @ r / 2 - m * g * r[2]),
    wrong_energy(
        "the energy of a spring with a rest length of 1 m",
        lambda r, m, k, g: k * (np.linalg.norm(r) - 1) ** 2 / 2 + m * g * r[2],
    ),
    wrong_energy("the equilibrium at the origin: no weight", lambda r, m, k, g: k * r @ r / 2),
    wrong_energy(
        "zero energy at the equilibrium in place of the origin",
        lambda r, m, k, g: k * np.sum((r + m * g / k * Z) ** 2) / 2,
    ),
    wrong_energy("the energy of the spring without its half", lambda r, m, k, g: k * r @ r + m * g * r[2]),
]


@check(points=1, part="a", suspects=ENERGY_SUSPECTS)
def energy_is_that_of_motion_spring_and_weight(student, draw):
    """energy: kinetic, of the spring, of the weight; zero at rest at the origin."""
    found = [(*case, kind) for kind in ("a random state", "rest at the origin") for case in cases(draw, 8)]
    states = [np.hstack([r, v]) * (kind == "a random state") for r, v, _, kind in found]
    found, states = found + plain_cases(draw), states + [np.hstack(case[:2]) for case in plain_cases(draw)]
    calls = [given(state, **case[2]) for state, case in zip(states, found, strict=True)]
    for energy, call, state, (r, v, known, kind) in zip(
        student.energy.many(named(calls, found)), calls, states, found, strict=True
    ):
        matrix = np.diag([known["stiffness"]] * 3 + [known["mass"]] * 3)
        right = state @ matrix @ state / 2 + known["mass"] * known["gravity"] * state[2]
        expect(
            energy,
            right,
            within=POINTWISE,
            scale=known["stiffness"] * size(r, v, known)[0] ** 2,
            of="the energy",
            unit="of its size",
            kind=kind,
            at=call,
            hint="three terms: speed, stretch, height",
        )


# The closed form


def formula_suspect(says, names, wrong):
    """With wrong(t, r, v, k, sag) in place of the motion: the state (n, 6) at the time t since the given state."""

    def states(t, position, velocity, *, mass, stiffness, gravity):
        k = rate_of(mass, stiffness, gravity)
        r, v, since = np.asarray(position), np.asarray(velocity), np.asarray(t)[:, None]
        return wrong(since, r, v, k, gravity / k**2 * Z)

    def from_start(t, *args, **kwargs):
        return states(np.asarray(t) - t[0], *args, **kwargs)

    variants = {"solution": states, "simulate": from_start}
    return suspect(says, within=1e-5, **{name: variants[name] for name in names})


def oscillation(t, r, v, k, centre):
    c, s = np.cos(k * t), np.sin(k * t)
    return np.hstack([centre + (r - centre) * c + v / k * s, -k * (r - centre) * s + v * c])


def motion_suspects(*names):
    return [
        formula_suspect("gravity pulling up", names, lambda t, r, v, k, sag: oscillation(t, r, v, k, sag)),
        formula_suspect(
            "the equilibrium at the origin: no weight", names, lambda t, r, v, k, sag: oscillation(t, r, v, k, 0 * sag)
        ),
        formula_suspect(
            "the position measured from the equilibrium",
            names,
            lambda t, r, v, k, sag: oscillation(t, r, v, k, 0 * sag) - np.hstack([sag, 0 * sag]),
        ),
        formula_suspect(
            "the sine's amplitude not divided by the frequency",
            names,
            lambda t, r, v, k, sag: oscillation(t, r, v * k, k, -sag),
        ),
        formula_suspect(
            "velocities that lack a factor, the frequency",
            names,
            lambda t, r, v, k, sag: oscillation(t, r, v, k, -sag) / np.repeat([1, k], 3),
        ),
    ]


def exact(since, position, velocity, **known):
    """States at times since the start."""
    k = rate_of(**known)
    return oscillation(since[:, None], position, velocity, k, -known["gravity"] / k**2 * Z)


TIME_SUSPECTS = mistimed(lambda t, *start, **known: exact(t - t[0], *start, **known), from_zero=exact, within=1e-5)


@once
def timed(draw, number, periods, shifted, without):
    """For random starts: uneven times, the states there, and the case; shifted times do not start at zero."""
    found = []
    for r, v, known in cases(draw, number, without):
        period = 2 * math.pi / rate_of(**known)
        first = draw.uniform(0.2, 0.9) * period * draw.choice([-1, 1]) if shifted else 0.0
        t = uneven(draw, periods * period, 12, first)
        found.append((t, motion(t - first, r, v, **known), (r, v, known)))
    return found


@once
def stiff(draw):
    """As `timed`, two times: a mass at 20 to 30 rad/s, whom steps of a millisecond follow, those of ten do not."""
    mass = 10 ** draw.uniform(-0.5, 0.5)
    known = {"mass": mass, "stiffness": mass * draw.uniform(20, 30) ** 2, "gravity": draw.uniform(2, 25)}
    t = np.array([0.0, draw.uniform(1.2, 1.4) * 2 * math.pi / rate_of(**known)])
    r, v = start(draw, rate_of(**known))
    return [(1 + t, motion(t, r, v, **known), (r, v, known))]


@once
def alike(draw):
    """As `plain_motions`, all like the first of them but for one argument."""
    ((r, v, known),) = cases(draw, 1, 0)
    t = uneven(draw, 2 * math.pi / rate_of(**known), 3, 0.0)
    first = {"t": t, "r": r, "v": v, **known}
    others = {"times": {"t": uneven(draw, t[-1], 3, 0.0)}, "position": {"r": 0.8 * r}, "velocity": {"v": -v}}
    others |= {name: {name: 1.4 * value} for name, value in known.items()}
    found = []
    for name, change in {"": {}, **others}.items():
        arguments = {**first, **change}
        t, r, v = (arguments.pop(each) for each in ("t", "r", "v"))
        kind = f"a motion like the one before but for its {name}" if name else "three times"
        found.append(((t, motion(t, r, v, **arguments), (r, v, arguments)), kind))
    return found


def judge_motion(student, name, found, within, kind, hint):
    calls = [given(t, r, v, **known).on(kind) for t, _, (r, v, known) in found]
    for states, call, (t, expected, (r, v, known)) in zip(
        getattr(student, name).many(calls), calls, found, strict=True
    ):
        expect(
            states,
            expected,
            within=within,
            scale=size(r, v, known),
            of="the motion",
            unit="of its size",
            t=t,
            kind=kind,
            hint=partial(motion_hint, states, expected, size(r, v, known), within, hint),
            at=call,
            keeps=lambda t=t, states=states, known=known: kept(
                t, energy_along(states, known), within=ENERGY, of="the energy", unit="of its start"
            ),
        )


ROWS = "row i is the state at t[i], and the given state is that at t[0]"


def motion_hint(states, expected, scale, within, hint):
    """What to say of a motion of which the start, the positions or the velocities are right, or all of it nearly."""
    errors = np.abs(states - expected) / scale
    if hint == ROWS and errors.max() <= NEARLY:
        return "it is nearly right: are the steps short, and the tolerances of the integrator tight enough?"
    if errors[:, :3].max() <= within:
        return "the positions are right: are the velocities their derivatives?"
    if errors[:, 3:].max() <= within:
        return "the velocities are right, the positions are not"
    if hint == ROWS and errors[0].max() <= within:
        return "row 0 is right: is your state_derivative, and is row i the state at t[i]?"
    return hint


def energy_along(states, known):
    """2 E along a motion, from the place of rest, over its first value."""
    centre = -known["mass"] * known["gravity"] / known["stiffness"] * Z
    energies = known["stiffness"] * np.sum((states[:, :3] - centre) ** 2, axis=1)
    energies += known["mass"] * np.sum(states[:, 3:] ** 2, axis=1)
    return energies / (energies[0] or 1.0)


@check(points=1.5, part="a", suspects=motion_suspects("solution"))
def solution_is_the_motion(student, draw):
    """solution: position and velocity in closed form, given those at t = 0."""
    judge_motion(
        student,
        "solution",
        timed(draw, 4, 1.7, False, 0),
        POINTWISE,
        "a random start",
        "about which point does it oscillate, and how fast?",
    )
    heavy = [(case, kind) for case, kind in plain_motions(draw, False) if case[2][2]["gravity"]]
    judge_plain_motions(student, "solution", heavy, POINTWISE, "the given state is that at t = 0")


@check(points=0.5, part="a", after=solution_is_the_motion)
def solution_holds_without_gravity_and_from_any_time(student, draw):
    """solution: without gravity too, and at times of which none is zero."""
    for count, shifted, without, kind in ((2, False, 2, "no gravity"), (2, True, 0, "times that do not start at 0")):
        found = [(t, expected, case) for t, expected, case in timed(draw, count, 1.3, shifted, without)]
        if shifted:
            found = [(t, motion(t, r, v, **known), (r, v, known)) for t, _, (r, v, known) in found]
        judge_motion(student, "solution", found, POINTWISE, kind, "the given state is that at t = 0")
    light = [(case, kind) for case, kind in plain_motions(draw, False) if not case[2][2]["gravity"]]
    judge_plain_motions(student, "solution", light, POINTWISE, "is anything divided by gravity?")
    ((t, states, case),) = timed(draw, 1, 1.3, False, 0)
    for kind, some in SOME_TIMES.items():
        found = [(t[some], states[some], case)]
        judge_motion(student, "solution", found, POINTWISE, kind, "row i is the state at t[i]")
    for case, kind in alike(draw):
        judge_motion(student, "solution", [case], POINTWISE, kind, "is anything kept between calls?")


# The simulation


@check(points=1, part="a", suspects=motion_suspects("simulate") + TIME_SUSPECTS)
def simulate_moves_as_it_must(student, draw):
    """simulate: the state at few and uneven times, the first of which is not 0."""
    judge_motion(student, "simulate", timed(draw, 4, 2.3, True, 1), TRAJECTORY, "uneven times, t[0] not 0", ROWS)


@check(points=0.5, part="a", after=simulate_moves_as_it_must)
def simulate_does_not_depend_on_the_sampling(student, draw):
    """simulate: only two times, many periods apart, and the same state as by many, whatever was asked before."""
    found = [(t[[0, -1]], states[[0, -1]], case) for t, states, case in timed(draw, 2, 6.4, True, 0)]
    judge_motion(
        student,
        "simulate",
        found,
        3 * TRAJECTORY,
        "two times far apart",
        "steps between the times, as short as the motion asks for",
    )
    judge_plain_motions(
        student, "simulate", plain_motions(draw, True), TRAJECTORY, "row 0 is the given state, that at t[0]"
    )
    judge_motion(
        student,
        "simulate",
        stiff(draw),
        TRAJECTORY,
        "two times, a stiff spring",
        "a step of fixed length does not do for every spring",
    )
    for case, kind in alike(draw):
        judge_motion(student, "simulate", [case], TRAJECTORY, kind, "is anything kept between calls?")


@check(points=0.5, part="a", after=simulate_moves_as_it_must)
def energy_stays(student, draw):
    """simulate: the energy after ten periods is that of the start."""
    ((r, v, known),) = cases(draw, 1, 0)
    t = uneven(draw, 20 * math.pi / rate_of(**known), 60, 1.0)
    states = student.simulate(t, r, v, **known)
    moved, expected = (np.ptp(path[:, :3], axis=0).max() for path in (states, exact(t - t[0], r, v, **known)))
    # whoever loses half of it has long lost the energy, too
    expect_that(moved > expected / 2, "the mass does not move", kind="ten periods, t[0] not 0")
    energies = energy_along(states, known)
    expect(
        energies,
        1.0,
        within=ENERGY,
        of="the energy",
        unit="of its start",
        t=t,
        at=(r, v, known),
        kind="ten periods, t[0] not 0",
        hint="ask the integrator for a smaller error",
        partial={1e-3: 0.6, 1e-2: 0.3},
    )


# The ellipse


FLAT = ("a line", "a point")


def orbit_cases(draw):
    """Starts whose ellipse is general, a circle, a line, a point; with what to call them."""
    found = [(*case, "a general ellipse") for case in cases(draw, 6)]
    for kind in ("a circle", "a circle", "a line", "a line", "a point") * 2:
        r, v, known = cases(draw, 1, len(found) > 10)[0]
        k, centre = rate_of(**known), -known["mass"] * known["gravity"] / known["stiffness"] * Z
        if kind == "a circle":
            v = np.cross(r - centre, draw.normal(size=3))
            v *= k * np.linalg.norm(r - centre) / np.linalg.norm(v)
        if kind == "a line":
            v = k * draw.uniform(-2, 2) * (r - centre) * draw.integers(2)
        if kind == "a point":
            r, v = centre, np.zeros(3)
        found.append((r, v, known, kind))
    return found + plain_orbits()


def plain_orbits():
    """As `orbit_cases`, of whole numbers, about (0, 0, -1): level or upright circle and ellipse, lines, the point."""
    x, y, centre = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), -Z
    return [
        (centre + x, y, WHOLE, "a circle"),
        (centre + x, Z, WHOLE, "a circle"),
        (centre + 2 * x, y, WHOLE, "a general ellipse"),
        (centre + x, 2 * y, WHOLE, "a general ellipse"),
        (0 * x, x, WHOLE, "a circle"),
        (0 * x, 0 * x, WHOLE, "a line"),
        (centre + x, 0 * x, WHOLE, "a line"),
        (centre, y, WHOLE, "a line"),
        (centre, 0 * x, WHOLE, "a point"),
        *((centre + p, v, WHOLE, kind) for kind, (p, v) in NEARLY_PLAIN.items()),
        *(
            (centre + 2 * x, y, {**WHOLE, name: 2.0}, f"an ellipse of a start as before, with another {name}")
            for name in WHOLE
        ),
    ]


def radii(a, b):
    """Two radii of the ellipse with these semi-axes along x and y, one where the mass is at 1 rad and the velocity."""
    c, s = math.cos(1.0), math.sin(1.0)
    return np.array([a * c, b * s, 0.0]), np.array([-a * s, b * c, 0.0])


# kind: position from the place of rest, and velocity, of WHOLE; each is far enough beyond the limits to be told
NEARLY_PLAIN = {
    "a thin ellipse": radii(1.0, 1e-2),
    "an ellipse that is nearly a circle": radii(1.003, 0.997),
    "radii of equal length, which are no axes": math.sqrt(2) * np.array([[math.sqrt(2), 0, 0], [1, 1, 0]]),
    "radii that are nearly axes": np.array([[2, 0, 0], [5e-4, 1, 0]]),
}


def tensor(r, v, centre, k):
    """Fradkin's tensor, over stiffness/2: constant; the ellipse's squared axes are its eigenvalues."""
    return np.outer(r - centre, r - centre) + np.outer(v, v) / k**2


def wrong_orbit(says, ellipse):
    """With ellipse(r, v, k, centre): centre and two conjugate radii."""

    def mistaken(position, velocity, *, mass, stiffness, gravity):
        k, r, v = rate_of(mass, stiffness, gravity), np.asarray(position), np.asarray(velocity)
        centre, *radii = ellipse(r, v, k, -gravity / k**2 * Z)
        _, lengths, directions = np.linalg.svd(np.array(radii), full_matrices=False)
        return centre, lengths[:, None] * directions

    return suspect(says, orbit=mistaken)


ORBIT_SUSPECTS = [
    wrong_orbit("gravity pulling up", lambda r, v, k, centre: (-centre, r + centre, v / k)),
    wrong_orbit("the equilibrium at the origin", lambda r, v, k, centre: (0 * centre, r, v / k)),
    wrong_orbit("the velocity not divided by the frequency", lambda r, v, k, centre: (centre, r - centre, v)),
    wrong_orbit(
        "the velocity divided by k/m, which is the frequency squared",
        lambda r, v, k, centre: (centre, r - centre, v / k**2),
    ),
]


@check(points=0.5, part="c", suspects=ORBIT_SUSPECTS)
def orbit_has_its_centre_at_the_equilibrium(student, draw):
    """orbit: the centre is where the mass can rest."""
    found = [case for case in orbit_cases(draw) if case[3] not in FLAT]
    calls = [given(r, v, **known) for r, v, known, _ in found]
    for (centre, _), call, (r, v, known, kind) in zip(
        student.orbit.many(named(calls, found)), calls, found, strict=True
    ):
        rest = np.linalg.solve(generator(**known)[3:6, :3], [0, 0, known["gravity"]])
        above = np.allclose(centre, -rest, rtol=0, atol=POINTWISE * extent(r, v, **known)[0])
        expect(
            centre,
            rest,
            within=POINTWISE,
            scale=extent(r, v, **known)[0],
            of="the centre",
            kind=kind,
            at=call,
            unit="of the motion's size",
            hint="it is above the origin" if above else "where do spring and weight balance?",
        )


def judge_axes(student, draw, flat):
    """Semi-axes a, b are perpendicular, a the larger, and a a^T + b b^T is Fradkin's tensor."""
    found = [case for case in orbit_cases(draw) if (case[3] in FLAT) == flat]
    calls = [given(r, v, **known) for r, v, known, _ in found]
    for (_, (a, b)), call, (r, v, known, kind) in zip(
        student.orbit.many(named(calls, found)), calls, found, strict=True
    ):
        k, centre = rate_of(**known), -known["mass"] * known["gravity"] / known["stiffness"] * Z
        whole = tensor(r, v, centre, k)
        square = np.trace(whole) + (NOUGHT * size(r, v, known)[0]) ** 2
        what = {"kind": kind, "at": call}
        ellipse = np.outer(a, a) + np.outer(b, b)
        twice = np.allclose(ellipse, 4 * whole, rtol=0, atol=4 * TENSOR * square)
        expect(
            ellipse,
            whole,
            within=TENSOR,
            scale=square,
            **what,
            of="the ellipse",
            unit="of the square of its size",
            hint="it is twice as large: these are its axes, not semi-axes"
            if twice
            else "do r and v/sqrt(k/m) lie on your ellipse, as seen from its centre?",
        )
        expect(
            a @ b,
            0.0,
            within=RIGHT_ANGLE,
            scale=square,
            of="the product of the axes",
            unit="of the larger one's square",
            **what,
            hint="two radii that give the ellipse need not be its axes",
        )
        expect_that(a @ a >= b @ b - RIGHT_ANGLE * square, "the larger axis is not the first", **what)


@check(points=1, part="c", suspects=ORBIT_SUSPECTS)
def orbit_is_the_ellipse_of_the_motion(student, draw):
    """orbit: the semi-axes, perpendicular, the larger first."""
    judge_axes(student, draw, flat=False)


@check(points=0.5, part="c", after=orbit_is_the_ellipse_of_the_motion)
def orbit_may_be_a_line_or_a_point(student, draw):
    """orbit: an ellipse with one axis or both zero."""
    judge_axes(student, draw, flat=True)


# The picture


def wrong_projection(says, right, up):
    """With right(ca, sa, ce, se) and up(...) in place of the right directions."""

    def projected(points, azimuth, elevation):
        c = math.cos(azimuth), math.sin(azimuth), math.cos(elevation), math.sin(elevation)
        return np.asarray(points) @ np.column_stack([right(*c), up(*c)])

    return suspect(says, project=projected)


PROJECTION_SUSPECTS = [
    wrong_projection(
        "left for right", lambda ca, sa, ce, se: (sa, -ca, 0), lambda ca, sa, ce, se: (-se * ca, -se * sa, ce)
    ),
    wrong_projection(
        "the elevation's sign reversed",
        lambda ca, sa, ce, se: (-sa, ca, 0),
        lambda ca, sa, ce, se: (se * ca, se * sa, ce),
    ),
    wrong_projection(
        "up for right", lambda ca, sa, ce, se: (-se * ca, -se * sa, ce), lambda ca, sa, ce, se: (-sa, ca, 0)
    ),
    wrong_projection(
        "the azimuth's sign reversed",
        lambda ca, sa, ce, se: (sa, ca, 0),
        lambda ca, sa, ce, se: (-se * ca, se * sa, ce),
    ),
    suspect(
        "azimuth and elevation swapped", project=lambda points, azimuth, elevation: seen(points, elevation, azimuth)
    ),
    suspect("angles taken for degrees", project=lambda points, *view: seen(points, *map(math.radians, view))),
]


@check(points=1, part="a", suspects=PROJECTION_SUSPECTS)
def projection_is_orthographic(student, draw):
    """project: what an eye far away sees, right and up."""
    for count in (1, 5, 30):
        points, azimuth, elevation = (draw.normal(size=(count, 3)), draw.uniform(-6, 6), draw.uniform(-1.5, 1.5))
        eye = np.array([math.cos(azimuth), math.sin(azimuth)]) * math.cos(elevation)
        eye = np.append(eye, math.sin(elevation))  # towards it
        right = np.cross(Z, eye) / math.cos(elevation)
        expected = np.column_stack([points @ right, points @ np.cross(eye, right)])
        picture = student.on("random points and directions").project(points, azimuth, elevation)
        expect(
            picture,
            expected,
            within=POINTWISE,
            of="a point of the picture",
            unit="m",
            kind="random points and directions",
            at=(points, azimuth, elevation),
            hint="try one axis at a time: where does (0, 0, 1) go?",
        )
    calls = [given(points, *view) for view in PLAIN_VIEWS for points in (np.eye(3), draw.normal(size=(2, 3)))]
    views = [call.on(f"a view from {PLAIN_VIEWS[call.args[1:]]}") for call in calls]
    for found, call in zip(student.project.many(views), views, strict=True):
        expect(
            found,
            seen(*call.args),
            within=POINTWISE,
            of="a point of the picture",
            unit="m",
            at=call,
            kind=call.kind,
            hint="try one axis at a time: where does (0, 0, 1) go?",
        )


PLAIN_VIEWS = {
    (0.0, 0.0): "along x",
    (math.pi / 2, 0.0): "along y",
    (-math.pi / 2, 0.0): "along y, from behind",
    (math.pi, 0.0): "along x, from behind",
    (0.0, math.pi / 2): "straight above",
    (0.0, -math.pi / 2): "straight below",
    (1.0, math.pi / 2): "straight above, turned",
    (0.0, 1.0): "above the x axis",
    (1.0, 0.0): "the level of the origin",
    (1.0, 2.0): "beyond straight above",
}  # azimuth and elevation: what to call them


@check(points=0.5, part="a", after=projection_is_orthographic)
def the_path_is_drawn(student, draw):
    """plot_projection draws the projected path from t[0] to t[-1], with labels and equal scales."""
    ((r, v, known),) = cases(draw, 1, 0)
    azimuth, elevation = draw.uniform(-3, 3), draw.uniform(0.3, 1.2)
    t = np.linspace(0.0, 0.6 * 2 * math.pi / rate_of(**known), SAMPLES)
    picture = student.plot_projection.draw(t, r, v, azimuth, elevation, **known)
    expect_that(
        len(picture.lines) == 1,
        f"there are {len(picture.lines)} curves on the axes, not one",
        hint="fewer than ten points are no curve",
    )
    places = motion(np.linspace(t[0], t[-1], 400), r, v, **known)[:, :3]
    expected = seen(places, azimuth, elevation)
    judge_path(along(picture.lines[0], expected), expected, places)
    judge_axes_of_lengths(picture, "right and up")


def seen(points, azimuth, elevation):
    """The points in coordinates turned by the azimuth about z, then by the elevation about the y axis."""
    plane = (points[:, 0] + 1j * points[:, 1]) * np.exp(-1j * azimuth)
    tilted = (plane.real + 1j * points[:, 2]) * np.exp(-1j * elevation)
    return np.column_stack([plane.imag, tilted.imag])


def judge_path(path, expected, places):
    """The line begins and ends where the motion does, and each has all of its points next to the other."""
    scale = np.abs(expected - expected.mean(axis=0)).max()
    expect_that(len(path) >= 20, "the curve has fewer than twenty points")
    expect(
        path[[0, -1]],
        expected[[0, -1]],
        within=DRAWN,
        scale=scale,
        of="an end of the curve",
        unit="of its size",
        hint=partial(end_hint, path, expected, places, DRAWN * scale),
    )
    for points, polygon, of, within in (
        (path, expected, "a point of the curve", DRAWN),
        (expected, path, "a point that the mass passes", PASSED),
    ):
        expect(
            distances(points, polygon),
            0.0,
            within=within,
            scale=scale,
            of=of,
            unit="of the curve's size",
            hint="is it the path of the mass, projected?",
        )


def end_hint(path, expected, places, near):
    """What to say of a curve with a wrong end."""

    def at(points, others):
        return np.abs(points - others).max() <= near

    if at(path[[0, -1]], places[[0, -1], :2]):
        return "these are x and y, not right and up"
    if at(path[0], expected[0]):
        return "it begins right and ends wrong: is your motion right, and does the curve end at t[-1]?"
    if at(path[-1], expected[-1]):
        return "it ends right and begins wrong: draw from t[0] on"
    return "draw from t[0] to t[-1]; right is drawn to the right"
