"""Hidden checks of hw14. What is right comes from Jourdain's principle: balances along the velocities rolling allows.

Trajectories are integrated in the components w1, w2, w3 of omega along e1, e2, e3 (Appell, Korteweg), a fourth way.
"""

import itertools
import math

import numpy as np
from scipy.integrate import solve_ivp

from tam570_grader import Failed, array, check, expect, expect_that, given, mistimed, number, once, rows, suspect

RESULTS = {
    "euler_state_derivative": array(8),
    "matrix_state_derivative": array(15),
    "multiplier_state_derivative": array(15),
    "matrix_state": array(15),
    "simulate_euler": rows(8),
    "simulate_matrix": rows(15),
    "energy": number,
    "contact_force": array(3),
    "steady_residual": number,
    "critical_speed": number,
    "growth_rate_squared": number,
    "wireframe": array(None, 2, 3),
}
NEEDS = ("numpy",)
MANUAL = {"e": (2, "the demonstration: derivations and animation, with every source of help acknowledged")}

POINTWISE = 1e-9  # careful formulas agree to 1e-13, a numpy.linalg.solve of nine unknowns to 1e-12
FLAT = 1e-8  # at a tilt of 1e-3 a linear system for the angles loses six of its sixteen digits
# Relative limits of motions, with the most that solve_ivp at rtol = atol = 1e-9 was off by in 120 draws, which is by
# BDF; LSODA is off by a tenth of it, and the others by less. RK45 at 1e-6 is off by 5e-6 or more where it is followed.
TRAJECTORY = 5e-6  # 5e-7
KEPT = 1e-6  # 8e-8, of what does not change: omega along e2 and e3, and the height
AGREED = 2e-5  # 2e-6, of two simulations over a longer time
ROTATION = 2e-5  # 1.2e-6, of R^T R over that time
ENERGY = 5e-6  # 4.3e-7, over 20 sqrt(a/g)
# of the largest roll; `roughly` is off by 1e-4 in 200 draws of 20 sqrt(a/g), a disk that stands by 0.6
ROLLED = 0.03  # ten times from each and more
MOST_CALLS = 10_000  # of the rates; a motion that stays off the flat takes 3000
Z = np.array([0.0, 0.0, 1.0])


# The disk in vectors


def hat(v):
    """hat(v) @ r = v x r; for vectors one by one it is six times as fast as np.cross."""
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def frame(state):
    """Rows e1, e2, e3."""
    yaw, tilt = state[2:4]
    e1 = np.array([math.cos(yaw), math.sin(yaw), 0.0])
    e3 = math.cos(tilt) * Z + math.sin(tilt) * (hat(e1) @ Z)
    return np.array([e1, hat(e3) @ e1, e3])


def components(state):
    """w1, w2, w3 of omega along e1, e2, e3, and the rate of the frame about e3."""
    _, _, _, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    turn = yaw_rate * math.cos(tilt)
    return tilt_rate, yaw_rate * math.sin(tilt), roll_rate + turn, turn


def attitude(state):
    """R, column by column, of e1 and e2 turned by the roll."""
    (e1, e2, e3), roll = frame(state), state[4]
    c, s = math.cos(roll), math.sin(roll)
    return np.column_stack([c * e1 + s * e2, c * e2 - s * e1, e3])


def placed(state, *, radius):
    """The matrix state."""
    E = frame(state)
    centre = np.array([state[0], state[1], 0.0]) + radius * E[1]
    return np.concatenate([centre, attitude(state).ravel(), np.array(components(state)[:3]) @ E])


def jourdain(state, tensor=None, *, mass, radius, inertia, gravity):
    """(yaw'', tilt'', roll''), omega' and the acceleration of the centre; a wrong tensor of inertia may be given."""
    E, rates = frame(state), np.asarray(state[5:])
    about = np.array([Z, E[0], E[2]])  # omega = rates @ about
    omega, turning = rates @ about, rates[0] * Z + rates[1] * E[0]
    about_rate = about @ hat(turning).T * [[0.0], [1.0], [1.0]]
    moves, e2_rate = radius * about @ hat(E[1]), hat(turning) @ E[1]
    moves_rate = radius * (about_rate @ hat(E[1]) + about @ hat(e2_rate))
    if tensor is None:
        tensor = inertia[0] * np.eye(3) + (inertia[1] - inertia[0]) * np.outer(E[2], E[2])
    force = mass * (gravity * Z + rates @ moves_rate)
    moment = tensor @ (rates @ about_rate) + hat(omega) @ (tensor @ omega)
    second = np.linalg.solve(mass * moves @ moves.T + about @ tensor @ about.T, -moves @ force - about @ moment)
    return second, second @ about + rates @ about_rate, second @ moves + rates @ moves_rate


def euler_rates(state, **disk):
    roll_rate, yaw = state[7], state[2]
    contact = -disk["radius"] * roll_rate * np.array([math.cos(yaw), math.sin(yaw)])
    return np.concatenate([contact, state[5:], jourdain(state, **disk)[0]])


def matrix_rates_with(omega_rate):
    """Rates of a matrix state whose omega' this function of the Euler state gives."""

    def rates(state, **disk):
        E, R, w = frame(state), attitude(state), placed(state, radius=1.0)[12:]
        velocity = disk["radius"] * hat(w) @ E[1]
        return np.concatenate([velocity, (hat(w) @ R).ravel(), omega_rate(state, **disk)])

    return rates


matrix_rates = matrix_rates_with(lambda state, **disk: jourdain(state, **disk)[1])


def energy(state, *, mass, radius, inertia, gravity):
    w = np.array(components(state)[:3])
    velocity = radius * np.array([-w[2], 0.0, w[0]])
    turning = np.array([inertia[0], inertia[0], inertia[1]]) @ w**2
    return 0.5 * (mass * velocity @ velocity + turning) + mass * gravity * radius * math.sin(state[3])


def force(state, *, mass, gravity, **disk):
    return mass * (jourdain(state, mass=mass, gravity=gravity, **disk)[2] + gravity * Z)


# The same in w1, w2, w3, right and wrong


def spun(state, wrong=(), *, mass, radius, inertia, gravity):
    """(w1', w2', w3'), with the mistakes that are named; see WRONG."""
    (A, C), m, g = inertia, mass * radius**2, gravity
    w1, w2, w3, turn = components(state)
    if wrong:
        A, C = (m / 4, m / 2) if "thin" in wrong else (C / 2, C) if "half" in wrong else (A, C)
        m = 0.0 if "light" in wrong else mass if "unit" in wrong else m
        g = -g if "upwards" in wrong else 9.81 if "earth" in wrong else g / mass if "massless" in wrong else g
        w3 = state[7] if "rolled" in wrong else w3
        turn = w3 if "with_body" in wrong else turn
    fixed, still = m * ("fixed" in wrong), m * ("still" in wrong)
    H3 = A if "free" in wrong else C
    weight = mass * g * radius * math.cos(state[3])
    return (
        (w2 * ((A + fixed + still) * turn - (H3 + m + fixed) * w3) - weight) / (A + m),
        w1 * (H3 * w3 - A * turn) / A,
        (m - still) * w1 * w2 / (C + m),
    )


def euler_second(state, changed):
    """yaw'', tilt'', roll'' of these w1', w2', w3'."""
    tilt, yaw_rate, tilt_rate = state[3], state[5], state[6]
    c, s = math.cos(tilt), math.sin(tilt)
    yaw_second = (changed[1] - yaw_rate * tilt_rate * c) / s
    return yaw_second, changed[0], changed[2] - yaw_second * c + yaw_rate * tilt_rate * s


def spun_euler_rates(state, wrong=(), **disk):
    roll_rate, yaw = components(state)[2] if "centre" in wrong else state[7], state[2]
    contact = (-disk["radius"] * roll_rate * math.cos(yaw), -disk["radius"] * roll_rate * math.sin(yaw))
    return [*contact, *state[5:], *euler_second(state, spun(state, wrong, **disk))]


def spun_omega_rate(state, wrong=(), **disk):
    """omega': its components change, and the frame turns."""
    w1, w2, w3, turn = components(state)
    changed = np.array(spun(state, wrong, **disk))
    return (changed + np.cross([w1, w2, turn], [w1, w2, w3])) @ frame(state)


spun_matrix_rates = matrix_rates_with(spun_omega_rate)


class Flat(Exception):
    """The disk falls flat, and the steps never end."""


def path(t, state, wrong=(), rtol=1e-11, **disk):
    """(n, 8) Euler states; NaN where the motion, a wrong one as a rule, takes too many steps."""
    calls = itertools.count()

    def rates(_, y):
        if next(calls) > MOST_CALLS:
            raise Flat
        return spun_euler_rates(y.tolist(), wrong, **disk)

    try:
        found = solve_ivp(rates, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=rtol, atol=rtol)
    except (Flat, ArithmeticError, ValueError):  # or a tilt of 0, or infinite
        return np.full((len(t), 8), np.nan)
    return found.y.T if found.y.shape[1] == len(t) else np.full((len(t), 8), np.nan)


def matrix_path(t, state, wrong=(), **disk):
    return np.array([placed(row, radius=disk["radius"]) for row in path(t, state, wrong, **disk)])


# Wrong answers to name

WRONG = {
    "the contact point taken as fixed in the body (its place in the disk changes as the disk rolls)": ("fixed",),
    "the rate of the frame e1, e2, e3 taken for that of the body": ("with_body",),
    "m a^2 missing: the force that moves the centre has a moment about it too": ("light",),
    "m where m a^2 belongs: right for a radius of 1 m alone": ("unit",),
    "the inertia of a thin uniform disk, whatever A and C": ("thin",),
    "C/2 for A, as of a thin disk": ("half",),
    "the weight upwards": ("upwards",),
    "9.81 m/s^2, whatever the gravity": ("earth",),
}
SPIN = "roll' taken for the total spin (yaw' has a part along the axle)"


IN_EULER = {**WRONG, SPIN: ("rolled",)}
IN_MATRIX = {
    **WRONG,
    "the rate of the arm to the contact left out": ("still",),
    "omega x H left out of the balance of angular momentum": ("free",),
    "the weight without the mass": ("massless",),
}
CLOSE = 1e-10  # for what the right answer may agree with in the first calls: what is a little off is not that mistake


def told(name, build, wrongs=WRONG, within=1e-6):
    return [suspect(says, within=within, **{name: build(wrong)}) for says, wrong in wrongs.items()]


def euler_of(state):
    """The Euler state, x and y left out, of a matrix state."""
    R, w = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    axle = R[:, 2]
    s = math.hypot(axle[0], axle[1])
    yaw, tilt = math.atan2(axle[0], -axle[1]), math.atan2(s, axle[2])
    e1, e2, _ = frame([0, 0, yaw, tilt])
    roll = math.atan2(-R[:, 1] @ e1, R[:, 0] @ e1)
    yaw_rate = w @ e2 / s
    return np.array([0, 0, yaw, tilt, roll, yaw_rate, w @ e1, w @ axle - yaw_rate * axle[2]])


def wrong_euler(wrong):
    return lambda t, state, **disk: spun_euler_rates(state, wrong, **disk)


def wrong_matrix(wrong):
    def omega_rate(state, **disk):
        return spun_omega_rate(state, wrong, **disk)

    return lambda t, state, **disk: matrix_rates_with(omega_rate)(euler_of(state), **disk)


def wrong_path(wrong):
    return lambda t, state, **disk: path(t, state, wrong, **disk)


def wrong_matrix_path(wrong):
    return lambda t, state, **disk: on_ground(matrix_path(t, euler_of(state), wrong, **disk), state)


def centre_path(t, state, **disk):
    states = path(t, state, **disk)
    states[:, :2] = [placed(row, radius=disk["radius"])[:2] for row in states]
    return states


def by_default(t, state, **disk):
    """solve_ivp as it is when nothing is said of its tolerances."""
    return solve_ivp(lambda _, y: spun_euler_rates(y.tolist(), **disk), (t[0], t[-1]), state, t_eval=t).y.T


def wrapped(least):
    """A simulation with yaw and roll wrapped to a turn that starts there."""

    def simulate_euler(t, state, **disk):
        states = path(t, state, **disk)
        states[:, [2, 4]] = (states[:, [2, 4]] - least) % (2 * math.pi) + least
        return states

    return simulate_euler


def mistimed_suspects(name, simulate):
    def from_zero(t, state, **disk):
        return simulate(t, simulate(np.array([0.0, t[0]]), state, **disk)[1], **disk)

    return mistimed(simulate, from_zero, name=name, within=1e-5)


def on_ground(states, start):
    """Shifted to where the start is."""
    return states + np.concatenate([start[:2] - states[0, :2], np.zeros(13)])


def rolling_alone(state):
    """The state whose total spin is the roll rate of this one."""
    return np.array([*state[:7], state[7] - state[5] * math.cos(state[3])])


def steady(lean, precession, spin):
    """The Euler state of hw11's motion."""
    tilt = lean + math.pi / 2
    return np.array([0, 0, 0, tilt, 0, precession, 0, spin - precession * math.cos(tilt)])


def growth(speed, **disk):
    """d(tilt'')/d(tilt) at w2 = C/A spin d(tilt), the balance about e2; by a five-point difference."""
    spin, h = speed / disk["radius"], 1e-3

    def second(lean):
        yaw_rate = disk["inertia"][1] / disk["inertia"][0] * spin * lean / math.cos(lean)
        return jourdain(steady(lean, yaw_rate, spin), **disk)[0][1]

    return (8 * (second(h) - second(-h)) - second(2 * h) + second(-2 * h)) / (12 * h)


def critical(**disk):
    """The speed at which growth, linear in the square of the speed, is zero."""
    unit = usual(disk) * disk["radius"]
    still, moving = growth(0.0, **disk), growth(unit, **disk)
    return unit * math.sqrt(still / (still - moving))


def with_inertia(right, change):
    return lambda *args, **disk: right(*args, **{**disk, "inertia": change(*disk["inertia"])})


def thin_disk(right):
    """The same for m a^2/4 and m a^2/2, whatever the inertias."""

    def function(*args, **disk):
        size = disk["mass"] * disk["radius"] ** 2
        return right(*args, **{**disk, "inertia": (size / 4, size / 2)})

    return function


# The draws

SHAPES = {"a thin uniform disk": (0.25, 0.5), "a hoop": (0.5, 1.0), "a wheel": None}


def a_disk(draw, shape):
    mass, radius = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1, 0)
    C = draw.uniform(0.2, 1.1)
    A, C = SHAPES[shape] or (C * draw.uniform(0.6, 1.3), C)
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (A * size, C * size), "gravity": draw.uniform(1.6, 25.0)}


def usual(disk):
    """Size of angular rates, rad/s."""
    return math.sqrt((disk["gravity"] or 10.0) / disk["radius"])


def a_state(draw, disk, tilt):
    place, angles = draw.uniform(-2, 2, 2), draw.uniform(-4, 4, 2)
    return np.array([*place, angles[0], tilt, angles[1], *(usual(disk) * draw.uniform(-2, 2, 3))])


@once
def instants(draw):
    """(state, disk, kind) of any motion; the last without gravity."""
    found = []
    for kind in [*SHAPES] * 4:
        disk = a_disk(draw, kind)
        found.append((a_state(draw, disk, draw.uniform(0.3, 2.8)), disk, kind))
    found.append((found[-1][0], {**found[-1][1], "gravity": 0.0}, "no gravity"))
    return found


@once
def plain_instants(draw):
    """As `instants`: at rest, upright, rolling straight, spinning on a point, without yaw or roll, whole numbers."""
    disk, found = a_disk(draw, "a wheel"), []
    rates = usual(disk) * draw.uniform(0.5, 2, 3) * draw.choice([-1, 1], 3)
    motions = (
        ("a disk at rest", (0, 0, 0)),
        ("a disk that only rolls", (0, 0, 1)),
        ("a disk that only yaws", (1, 0, 0)),
        ("a disk that only tilts", (0, 1, 0)),
        ("a steady tilt", (1, 0, 1)),
        ("no roll", (1, 1, 0)),
    )
    for kind, some in motions:
        for tilt, how in ((math.pi / 2, "upright"), (draw.uniform(0.4, 1.4), "tilted"), (2.0, "tilted")):
            state = np.array([*draw.uniform(-2, 2, 2), draw.uniform(-4, 4), tilt, draw.uniform(-4, 4), *rates * some])
            found.append((state + 0.0, disk, f"{kind}, {how}"))
    ones = {"mass": 1.0, "radius": 1.0, "inertia": (0.25, 0.5), "gravity": 1.0}
    whole = np.array([0, 0, 0, math.pi / 4, 0, 1, 1, 1])
    far = a_state(draw, disk, 1.0) + [300, -200, 0, 0, 0, 0, 0, 0]
    return [*found, (whole, ones, "whole numbers, at the origin"), (far, disk, "a disk far from the origin")]


def roughly(t, state, disk):
    """The states at t, and whether the disk stays away from the flat all the time."""
    times, rows = np.unique([*t, *np.linspace(t[0], t[-1], 100)], return_inverse=True)
    states = path(times, state, rtol=1e-5, **disk)
    return states[rows[: len(t)]], np.sin(states[:, 3]).min() > 0.4


@once
def starts(draw, count, span, samples):
    """(t, state, disk, kind, rough states at t) of motions that stay away from the flat; the second without gravity."""
    found = []
    while len(found) < count:
        disk = a_disk(draw, ["a wheel", "a hoop"][len(found)])
        disk["gravity"] *= not found
        state = a_state(draw, disk, draw.uniform(0.8, 2.3))
        state[7] += 2 * usual(disk) * np.sign(state[7])
        # what needs t[0] > 0 gives one result
        start = draw.uniform(-3, -0.5) if found else draw.uniform(0.5, 3)
        t = start + span / usual(disk) * np.sort([0.0, 1.0, *draw.uniform(0, 1, samples - 2)])
        states, stays_up = roughly(t, state, disk)
        if stays_up:
            kind = "a motion without gravity" if found else "a general motion"
            found.append((t, state, disk, kind, states))
    return found


@once
def followed(draw):
    """(t, Euler states, disk, kind)."""
    return [(t, path(t, state, **disk), disk, kind) for t, state, disk, kind, _ in starts(draw, 2, 3.0, 60)]


@once
def critical_speeds(draw):
    """(disk, right, scale, kind); without gravity the square of the rate is below 0 at any speed but 0."""
    disks = [(a_disk(draw, kind), kind) for kind in [*SHAPES] * 2]
    disk, kind = disks[-1]
    disks.append(({**disk, "gravity": 0.0}, f"{kind} without gravity"))
    return [(it, critical(**it), critical(**it) or critical(**disk), kind) for it, kind in disks]


@once
def growths(draw):
    """(speed, disk, square of the rate, its scale, kind) from rest to four times the critical speed."""
    found = []
    for kind, ratio in zip([*SHAPES] * 2, (0.0, 0.5, 0.95, 1.05, 2.0, 4.0), strict=True):
        disk = a_disk(draw, kind)
        speed, scale = ratio * critical(**disk), growth(0.0, **disk)
        disk["gravity"] *= ratio != 2.0
        right = growth(speed, **disk)
        found.append((speed, disk, right, scale + abs(right), f"{kind}, {pace(ratio, disk['gravity'])}"))
    speed, other = found[-1][0], found[1][1]
    right = growth(speed, **other)
    scale = growth(0.0, **other) + abs(right)
    return [*found, (speed, other, right, scale, "the speed of the last disk, and another disk")]


def pace(ratio, gravity):
    if not gravity:
        return "without gravity"
    if not ratio:
        return "at rest"
    return "slower than the critical speed" if ratio < 1 else "faster than the critical speed"


def second_scale(state, disk):
    """Size of angular accelerations."""
    return (np.abs(state[5:]).sum() ** 2 + disk["gravity"] / disk["radius"]) / math.sin(state[3])


def euler_scale(state, disk):
    rate, second = 1e-3 + np.abs(state[5:]).sum(), second_scale(state, disk)
    return np.array([*[disk["radius"] * rate] * 2, *[rate] * 3, *[second] * 3])


def matrix_scale(state, disk):
    rate, second = 1e-3 + np.abs(state[5:]).sum(), second_scale(state, disk)
    return np.array([*[disk["radius"] * rate] * 3, *[rate] * 9, *[second] * 3])


def columns_scale(states, lengths, radius):
    """The largest magnitude in each column, no less than the radius for lengths, and than 1 for the others."""
    least = np.where(np.arange(states.shape[1]) < lengths, radius, 1.0)
    return np.maximum(np.abs(states).max(axis=0), least)


# (a) Three derivations


def exchanged(state):
    """Yaw for roll, and roll for yaw."""
    return np.asarray(state)[[0, 1, 4, 3, 2, 5, 6, 7]]


def with_attitude(change):
    """The matrix state, but R that of a changed state."""

    def turned_otherwise(state, *, radius):
        right = placed(state, radius=radius)
        return np.concatenate([right[:3], attitude(change(state)).ravel(), right[12:]])

    return turned_otherwise


@check(
    points=0.5,
    part="a",
    suspects=[
        suspect(
            "R column by column, or transposed",
            matrix_state=lambda state, *, radius: np.concatenate(
                [(m := placed(state, radius=radius))[:3], m[3:12].reshape(3, 3).T.ravel(), m[12:]]
            ),
        ),
        suspect(
            "omega in body axes",
            matrix_state=lambda state, *, radius: np.concatenate(
                [(m := placed(state, radius=radius))[:12], m[12:] @ attitude(state)]
            ),
        ),
        suspect(SPIN, matrix_state=lambda state, *, radius: placed(rolling_alone(state), radius=radius)),
        suspect(
            "the contact for the centre",
            matrix_state=lambda state, *, radius: np.concatenate([state[:2], [0.0], placed(state, radius=radius)[3:]]),
        ),
        suspect("yaw and roll exchanged in R", matrix_state=with_attitude(exchanged)),
        suspect("yaw and roll exchanged", matrix_state=lambda state, **disk: placed(exchanged(state), **disk)),
        suspect(
            "the centre straight above the contact",
            matrix_state=lambda state, *, radius: np.concatenate([state[:2], placed(state, radius=radius)[2:]]),
        ),
        suspect(
            "roll' along z: it is along the axle",
            matrix_state=lambda state, *, radius: np.concatenate(
                [placed(state, radius=radius)[:12], state[6] * frame(state)[0] + (state[5] + state[7]) * Z]
            ),
        ),
        suspect(
            "the frame e1, e2, e3 for R: the roll left out",
            matrix_state=lambda state, *, radius: np.concatenate(
                [(m := placed(state, radius=radius))[:3], frame(state).T.ravel(), m[12:]]
            ),
        ),
    ],
)
def matrix_state_places_the_disk(student, draw):
    """matrix_state has the centre, R row by row, and the total omega in space axes."""
    for state, disk, kind in instants(draw) + plain_instants(draw):
        right, radius = placed(state, radius=disk["radius"]), disk["radius"]
        sizes = (radius + np.abs(state[:2]).max(), 1.0, np.abs(state[5:]).sum() or 1.0)
        expect_parts(
            PLACE,
            student.on(kind).matrix_state(state, radius=radius),
            right,
            np.repeat(sizes, [3, 9, 3]),
            within=POINTWISE,
            at=(state, disk),
            kind=kind,
        )


CENTRE, MATRIX, OMEGA = slice(0, 3), slice(3, 12), slice(12, 15)
PLACE = {"the centre": CENTRE, "R, row by row,": MATRIX, "omega in space axes": OMEGA}
MATRIX_RATES = {"the centre's velocity": CENTRE, "dR/dt": MATRIX, "omega'": OMEGA}
EULER_RATES = {
    "the contact's velocity": slice(0, 2),
    "an angle's rate": slice(2, 5),
    "yaw''": slice(5, 6),
    "tilt''": slice(6, 7),
    "roll''": slice(7, 8),
}


def expect_parts(parts, found, right, scale, **said):
    """Part by part, so that the message names what is wrong."""
    for of, part in parts.items():
        expect(found[part], right[part], scale=scale[part], of=of, unit="of its size", **said)


def judged(function, cases, parts, *, given_as, right, scale, within, hint="", spins=None):
    """The student's derivatives against the right ones; spins(off, state) is the omega' in what a derivative is off."""
    calls = [given(0.0, given_as(state, disk), **disk).on(kind) for state, disk, kind in cases]
    results = function.many(calls)

    def where():
        states = [state for state, *_ in cases]
        offs = [found - right(state, **disk) for found, (state, disk, _) in zip(results, cases, strict=True)]
        sizes = [scale(state, disk) for state, disk, _ in cases]
        half = half_wrong(states, np.max(np.abs(offs) / sizes, axis=1) > within)
        if half or not spins:
            return half or hint
        turning = [spins(off, state) for off, state in zip(offs, states, strict=True)]
        return wrong_along("omega'", turning, states, [within * size[-1] for size in sizes]) or hint

    for found, (state, disk, kind) in zip(results, cases, strict=True):
        expected = np.asarray(right(state, **disk))
        expect_parts(parts, found, expected, scale(state, disk), within=within, at=(state, disk), kind=kind, hint=where)


def omega_rate_of_angles(rates, state):
    """What the second derivatives of the angles contribute to omega'."""
    e1, _, e3 = frame(state)
    return rates[5] * Z + rates[6] * e1 + rates[7] * e3


def omega_rate_of_matrix(rates, state):
    return rates[OMEGA]


def wrong_along(of, offs, states, limits):
    """Along which of e1, e2, e3 these vectors are off, if it is not along all of them; "" if it is."""
    errors = [np.abs(frame(state) @ off) for off, state in zip(offs, states, strict=True)]
    wrong = np.any(np.array(errors) > np.reshape(limits, (-1, 1)), axis=0)
    names = [name for name, off in zip(("e1", "e2", "e3"), wrong, strict=True) if off]
    return f"{of} is wrong along {' and '.join(names)} only" if 0 < len(names) < 3 else ""


HALVES = {
    "where cos(yaw) < 0, and only there: an arctan of a ratio knows half of all directions, arctan2 all": (
        lambda yaw, tilt: math.cos(yaw) < 0
    ),
    "where tilt > pi/2, and only there: an arcsin, or a root for the cosine, knows half of all tilts": (
        lambda yaw, tilt: tilt > math.pi / 2 + 1e-9
    ),
}


def half_wrong(states, wrong):
    """Of which states the results are wrong, if it is half of them; "" if it is not."""
    moving = np.array([np.all(state[5:]) for state in states])  # at rest a wrong angle may do no harm
    for says, is_among in HALVES.items():
        among = np.array([is_among(*state[2:4]) for state in states])
        if among.all() or np.any(wrong & ~among):
            continue
        if np.any(among & moving) and np.mean(wrong[among & moving]) > 0.7:
            return f"it is wrong {says}"
    return ""


@check(
    points=1.25,
    part="a",
    suspects=[
        *told("euler_state_derivative", wrong_euler, IN_EULER),
        suspect(
            "the contact moving as fast as the centre",
            euler_state_derivative=lambda t, state, **disk: np.concatenate(
                [-disk["radius"] * components(state)[2] * frame(state)[0, :2], euler_rates(state, **disk)[2:]]
            ),
        ),
        suspect(
            "the contact at rest (the point of the disk there is, the place is not)",
            euler_state_derivative=lambda t, state, **disk: euler_rates(state, **disk) * ([0] * 2 + [1] * 6),
        ),
    ],
)
def euler_equations_hold(student, draw):
    """euler_state_derivative balances momentum and angular momentum of a rolling disk, hoop and wheel."""
    judged(
        student.euler_state_derivative,
        [*instants(draw), *plain_instants(draw)],
        EULER_RATES,
        given_as=as_euler,
        right=euler_rates,
        spins=omega_rate_of_angles,
        scale=euler_scale,
        within=POINTWISE,
        hint="test it on straight rolling, then on hw11's circles",
    )


@check(points=0.25, part="a", after=euler_equations_hold)
def euler_equations_hold_next_to_flat_and_upright(student, draw):
    """euler_state_derivative holds at a tilt of 1e-3, and for a disk spinning upright on a point."""
    disk = a_disk(draw, "a wheel")
    nearly = nearly_flat(draw, disk)
    upright = a_state(draw, disk, math.pi / 2) * [1, 1, 1, 1, 1, 1, 0, 0]
    cases = [*nearly, (upright, disk, "an upright disk that spins on a point")]
    judged(
        student.euler_state_derivative,
        cases,
        EULER_RATES,
        given_as=as_euler,
        right=spun_euler_rates,
        scale=euler_scale,
        within=FLAT,
        hint=NO_SINGULAR_TILT,
    )


NO_SINGULAR_TILT = "no tilt but 0 and pi is singular"


def nearly_flat(draw, disk):
    return [(a_state(draw, disk, tilt), disk, "a nearly flat disk") for tilt in (1e-3, math.pi - 1e-3)]


def judge_balances(function, draw, hint):
    """The rates of a matrix state, those of a nearly flat disk last."""
    said = {"given_as": as_matrix, "scale": matrix_scale}
    judged(
        function,
        [*instants(draw), *plain_instants(draw)],
        MATRIX_RATES,
        right=matrix_rates,
        within=POINTWISE,
        hint=hint,
        spins=omega_rate_of_matrix,
        **said,
    )
    judged(
        function,
        nearly_flat(draw, a_disk(draw, "a wheel")),
        MATRIX_RATES,
        right=spun_matrix_rates,
        within=FLAT,
        hint=NO_SINGULAR_TILT,
        **said,
    )


def as_euler(state, disk):
    return state


def as_matrix(state, disk):
    return placed(state, radius=disk["radius"])


def balances_suspects(name):
    """Of both functions for the rates of a matrix state; their kinematics are those of the matrix."""

    def as_in_body_axes(t, state, **disk):
        rates = matrix_rates(euler_of(state), **disk)
        R, (x, y, z) = np.reshape(state[3:12], (3, 3)), state[12:]
        rates[MATRIX] = (R @ [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]).ravel()
        return rates

    def by_body_tensor(state, **disk):
        A, C = disk["inertia"]
        return jourdain(state, np.diag([A, A, C]), **disk)[1]

    def with_body_tensor(t, state, **disk):
        return matrix_rates_with(by_body_tensor)(euler_of(state), **disk)

    return [
        *told(name, wrong_matrix, IN_MATRIX),
        suspect(
            "the inertias of body axes taken along those of space: I is R diag(A, A, C) R^T", **{name: with_body_tensor}
        ),
        suspect("dR/dt of an omega in body axes, where it is in space axes", **{name: as_in_body_axes}),
    ]


@check(points=0.75, part="a", suspects=balances_suspects("matrix_state_derivative"))
def matrix_equations_hold(student, draw):
    """matrix_state_derivative balances momentum and angular momentum, and turns R by omega in space axes."""
    judge_balances(student.matrix_state_derivative, draw, hint="dR/dt from omega, then the balances in space axes")


@check(points=0.75, part="a", suspects=balances_suspects("multiplier_state_derivative"))
def multiplier_equations_hold(student, draw):
    """multiplier_state_derivative balances momentum and angular momentum, the contact held by multipliers."""
    judge_balances(
        student.multiplier_state_derivative,
        draw,
        hint="in space axes: m g, I = R diag(A, A, C) R^T; the constraint's rate, arm too",
    )


# (b) Simulation, (c) both ways

PARTIAL = {1e-4: 0.5, 1e-3: 0.25}
TOLERANCE = "is the tolerance tight? rtol and atol of 1e-9 do"
TIGHT = f"nearly right: {TOLERANCE}"
NEARLY = 10  # times the limit; what joins the states of an integrator by straight lines is off by more
BETTER = 0.1  # of the error is left where the times asked for are what matters, to choose the words
SAMPLED = "with more times in between, the same motion comes out far better: how t is sampled must not change it"
JOINED = (
    "asked for alone, its worst time comes out far better: are the states the integrator's own at t "
    "(t_eval, or dense_output), or joined by straight lines?"
)
TURNS = "it is whole turns that yaw or roll is off by: angles are never wrapped"


def near_hint(simulate, disks, parts):
    """The hint for motions that are followed from time to time, by the worst: other times are asked for, too."""
    error, worst = max((error_of_run(part), index) for index, part in enumerate(parts))
    (t, found, right, scale, _), disk = parts[worst], disks[worst]
    if whole_turns(found, right, scale):
        return TURNS
    if error <= NEARLY * TRAJECTORY:
        return TIGHT

    def within(limit, times, asked, rows):
        """Whether these rows are so near to the motion when other times are asked for."""
        again = another(simulate, times, right[0], disk)
        return again is not None and np.max(np.abs(again[asked] - right[rows]) / scale) <= limit

    places = np.arange(10 * len(t) - 9) / 10
    if within(BETTER * error, np.interp(places, np.arange(len(t)), t), slice(None, None, 10), slice(None)):
        return SAMPLED
    row = int(np.argmax(np.max(np.abs(found - right) / scale, axis=1)))
    if row and error <= NEARLY * max(PARTIAL) and within(TRAJECTORY, t[[0, row]], 1, row):
        return JOINED
    return not_rotations(found) or (TOLERANCE if error <= max(PARTIAL) else DERIVATIVES)


DERIVATIVES = "derivatives right? the times are unevenly spaced, the first is not 0"


def whole_turns(found, right, scale):
    """Whether Euler states are right but for whole turns of yaw and roll."""
    if found.shape[1] != 8:
        return False
    turns = np.zeros_like(found)
    turns[:, [2, 4]] = 2 * math.pi * np.round((found - right)[:, [2, 4]] / (2 * math.pi))
    return bool(turns.any() and np.max(np.abs(found - turns - right) / scale) <= TRAJECTORY)


def not_rotations(found):
    """The hint for an R that no longer is one: omega x R keeps it, whatever omega is, and tolerances of 1e-9 do."""
    if found.shape[1] != 15:
        return ""
    R = found[:, MATRIX].reshape(-1, 3, 3)
    off = np.abs(R.transpose(0, 2, 1) @ R - np.eye(3)).max()
    return f"R^T R leaves 1 by {off:.0e}: {TOLERANCE}" if off > NEARLY * ROTATION else ""


def another(simulate, t, start, disk):
    """A further simulation, to choose the words; None if there is none."""
    try:
        return simulate(t, start, **disk)
    except Failed:
        return None


def tight_hint(error, within):
    """The hint for a motion that was right over a shorter time."""
    return TIGHT if error <= NEARLY * within else TOLERANCE if error <= max(PARTIAL) else ""


def few_times_hint(error, within):
    """The hint for few times far apart; there were many, near each other, in what went well before."""
    steps = "the steps must not depend on the sampling"
    return steps if error > 100 * within else "is the tolerance tight enough?"


@check(
    points=0.75,
    part="b",
    suspects=[
        *told("simulate_euler", wrong_path, IN_EULER),
        *mistimed_suspects("simulate_euler", wrong_path(())),
        suspect("the angles wrapped to half a turn to either side", simulate_euler=wrapped(-math.pi)),
        suspect("the angles wrapped to a turn from 0", simulate_euler=wrapped(0.0)),
        suspect("the contact moving as fast as the centre", simulate_euler=wrong_path(("centre",))),
        suspect("x and y of the centre, where they are those of the contact", simulate_euler=centre_path),
        suspect("the tolerances that solve_ivp has when none are given", simulate_euler=by_default),
    ],
)
def euler_simulation_follows_the_motion(student, draw):
    """simulate_euler follows the motion from any start, row i at t[i], row 0 the given state."""
    parts, disks = [], []
    for t, right, disk, kind in followed(draw):
        found = student.on(kind).simulate_euler(t, right[0], **disk)
        parts.append((t, found, right, columns_scale(right, 2, disk["radius"]), kind))
        disks.append(disk)
    expect_all(
        parts,
        within=TRAJECTORY,
        of="the state",
        unit="of its largest",
        partial=PARTIAL,
        hint=lambda: near_hint(student.simulate_euler, disks, parts),
    )
    for t, right, disk, kind in plain_paths(draw):
        found = student.on(kind).simulate_euler(t, right[0], **disk)
        expect(
            found,
            right,
            within=TRAJECTORY,
            scale=columns_scale(right, 2, disk["radius"]),
            of="the state",
            unit="of its largest",
            t=t,
            kind=kind,
            at=(right[0], disk),
        )


@once
def plain_paths(draw):
    """As `followed`, for two times: let go at rest, rolling straight upright, spinning upright on a point, at rest.

    The last has the times and the start of the first: what is kept from call to call must not be the answer.
    """
    disk, found = a_disk(draw, "a wheel"), []
    rate, still = usual(disk), {**disk, "gravity": 0.0}
    for tilt, rates, kind in (
        (1.1, (0, 0, 0), "let go at rest"),
        (math.pi / 2, (0, 0, 3), "rolling straight, upright"),
        (math.pi / 2, (3, 0, 0), "spinning upright on a point"),
    ):
        start = np.array([*draw.uniform(-2, 2, 3), tilt, draw.uniform(-2, 2), *np.multiply(rates, rate)])
        t = draw.uniform(0.5, 3) + np.array([0.0, 0.6]) / rate
        found.append((t, path(t, start, **disk), disk, f"two times, a disk {kind}"))
    t, (start, _), *_ = found[0]
    kind = "two times, a disk at rest without gravity, where it stays"
    return [*found, (t, path(t, start, **still), still, kind)]


def expect_all(parts, **said):
    """All runs, (t, found, right, scale, kind) each; the worst first, for it decides about partial points."""
    for t, found, right, scale, kind in sorted(parts, key=error_of_run, reverse=True):
        expect(found, right, scale=scale, t=t, kind=kind, **said)


def expect_rolling(states, rough, *, hint, **said):
    """A disk that stands still breaks no law of what does not change: is it, roughly, where it should be?"""
    stands = "the disk does not move" if not np.ptp(states, axis=0).any() else hint
    expect(
        states[:, 4],
        rough[:, 4],
        within=ROLLED,
        scale=np.abs(rough[:, 4]).max(),
        of="roll",
        unit="of its largest",
        hint=stands,
        **said,
    )


def error_of_run(part):
    _, found, right, scale, _ = part
    return np.max(np.abs(found - right) / scale)


def appell_and_korteweg(tilts, start, *, mass, radius, inertia, gravity):
    """(n, 2): w2 and w3, functions of the tilt alone, from the linear equations in it."""
    (A, C), m = inertia, mass * radius**2

    def rates(tilt, w):
        return [C / A * w[1] - w[0] / math.tan(tilt), m / (C + m) * w[0]]

    found = []
    for end in (min(tilts) - 0.01, max(tilts) + 0.01):
        span, w = (start[3], end), components(start)[1:3]
        found.append(solve_ivp(rates, span, w, method="DOP853", rtol=1e-11, atol=1e-12, dense_output=True).sol)
    return np.array([found[int(tilt > start[3])](tilt) for tilt in tilts])


@check(points=0.5, part="b", after=euler_simulation_follows_the_motion)
def euler_simulation_keeps_two_integrals(student, draw):
    """simulate_euler keeps omega's parts along e2 and e3 functions of the tilt alone, however far apart the times."""
    parts, motions = [], []
    for t, state, disk, kind, rough in starts(draw, 2, 6.0, 4):
        states = student.on(kind).simulate_euler(t, state, **disk)
        expect_that(np.sin(states[:, 3]).min() > 0.1, "the disk falls flat", kind=kind, at=(state, disk))
        w = np.array([components(row)[1:3] for row in states])
        right = appell_and_korteweg(states[:, 3], state, **disk)
        parts.append((t, w, right, np.abs(state[5:]).sum(), kind))
        motions.append((states, rough, {"t": t, "kind": kind, "at": (state, disk)}))
    hint = few_times_hint(max(map(error_of_run, parts)), KEPT)
    for states, rough, said in motions:
        expect_rolling(states, rough, hint=hint, **said)
    expect_all(
        parts,
        within=KEPT,
        of="omega along e2 or e3 as a function of the tilt",
        unit="of the start's rates",
        hint=hint,
        partial={1e-4: 0.5},
    )


@check(
    points=0.75,
    part="b",
    suspects=[
        *told("simulate_matrix", wrong_matrix_path, IN_MATRIX),
        *mistimed_suspects("simulate_matrix", wrong_matrix_path(())),
    ],
)
def matrix_simulation_follows_the_motion(student, draw):
    """simulate_matrix follows the motion from any start, row i at t[i], row 0 the given state."""
    parts, disks = [], []
    for t, states, disk, kind in followed(draw):
        right = np.array([as_matrix(row, disk) for row in states])
        found = student.on(kind).simulate_matrix(t, right[0], **disk)
        parts.append((t, found, right, columns_scale(right, 3, disk["radius"]), kind))
        disks.append(disk)
    expect_all(
        parts,
        within=TRAJECTORY,
        of="the state",
        unit="of its largest",
        partial=PARTIAL,
        hint=lambda: near_hint(student.simulate_matrix, disks, parts),
    )
    for t, states, disk, kind in plain_paths(draw):
        right = np.array([as_matrix(row, disk) for row in states])
        found = student.on(kind).simulate_matrix(t, right[0], **disk)
        expect(
            found,
            right,
            within=TRAJECTORY,
            scale=columns_scale(right, 3, disk["radius"]),
            of="the state",
            unit="of its largest",
            t=t,
            kind=kind,
            at=(right[0], disk),
        )


@check(points=0.5, part="c", after=(euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion))
def both_simulations_agree(student, draw):
    """Both simulations give one motion over a long time, and R stays a rotation with the disk on the ground."""
    for t, state, disk, kind, rough in starts(draw, 1, 6.0, 4):
        found = student.on(kind).simulate_matrix(t, as_matrix(state, disk), **disk)
        states = student.on(kind).simulate_euler(t, state, **disk)
        other = np.array([as_matrix(row, disk) for row in states])
        R = found[:, 3:12].reshape(-1, 3, 3)
        products = R.transpose(0, 2, 1) @ R
        hint = few_times_hint(np.abs(products - np.eye(3)).max(), ROTATION)
        expect(
            products,
            np.broadcast_to(np.eye(3), R.shape),
            within=ROTATION,
            t=t,
            of="R^T R",
            kind=kind,
            at=(state, disk),
            hint=hint,
        )
        expect(
            found[:, 2],
            disk["radius"] * np.hypot(R[:, 0, 2], R[:, 1, 2]),
            within=KEPT,
            scale=disk["radius"],
            t=t,
            of="the centre's height",
            unit="of the radius",
            kind=kind,
            at=(state, disk),
        )
        scale = columns_scale(other, 3, disk["radius"])
        error = error_of_run((t, found, other, scale, kind))
        expect(
            found,
            other,
            within=AGREED,
            scale=scale,
            t=t,
            kind=kind,
            of="one simulation against the other",
            unit="of the largest",
            at=(state, disk),
            hint=tight_hint(error, AGREED),
        )
        expect_rolling(states, rough, hint="", t=t, kind=kind, at=(state, disk))


# (d) Steady circles


def steady_second(wrong):
    return lambda lean, p, spin, **disk: spun(steady(lean, p, spin), wrong, **disk)[0]


@check(
    points=0.75,
    part="d",
    suspects=[
        *told("steady_residual", steady_second, within=CLOSE),
        suspect(
            "the lean to the other side",
            steady_residual=lambda lean, *args, **disk: steady_second(())(-lean, *args, **disk),
        ),
        suspect(
            "a moment: it is not divided by the inertia about the contact",
            steady_residual=lambda *args, **disk: (
                steady_second(())(*args, **disk) * (disk["inertia"][0] + disk["mass"] * disk["radius"] ** 2)
            ),
        ),
        suspect(
            "the spin relative to the turning frame taken for the total spin",
            steady_residual=lambda lean, p, spin, **disk: steady_second(())(lean, p, spin - p * math.sin(lean), **disk),
        ),
        suspect("the sign turned round", steady_residual=lambda *a, **k: -steady_second(())(*a, **k)),
        suspect(
            "a moment divided by A alone: about the contact it is A + m a^2",
            steady_residual=lambda *args, **disk: (
                steady_second(())(*args, **disk) * (1 + disk["mass"] * disk["radius"] ** 2 / disk["inertia"][0])
            ),
        ),
        suspect(
            "the spin or the precession the other way",
            steady_residual=lambda lean, p, spin, **disk: steady_second(())(lean, p, -spin, **disk),
        ),
        suspect(
            "roll' = spin + yaw' cos(tilt): the spin is roll' + yaw' cos(tilt)",
            steady_residual=lambda lean, p, spin, **disk: steady_second(())(
                lean, p, spin - 2 * p * math.sin(lean), **disk
            ),
        ),
    ],
)
def steady_residual_is_the_tilt_acceleration(student, draw):
    """steady_residual is tilt'' of the motion with this lean, precession and total spin, steady or not."""
    drawn = [
        ((draw.uniform(-1.4, 1.4), *(usual(disk) * draw.uniform(-2, 2, 2))), disk, kind)
        for _, disk, kind in instants(draw)
    ]
    lean, precession, spin = abs(drawn[0][0][0]) + 0.1, *drawn[0][0][1:]
    plain = {
        "exactly upright": (0.0, precession, spin),
        "no precession": (lean, 0.0, spin),
        "no spin": (-lean, precession, 0.0),
        "a disk let go at rest": (lean, 0.0, 0.0),
        "straight rolling upright": (0.0, 0.0, spin),
        "spinning upright on a point": (0.0, precession, 0.0),
    }
    for (lean, precession, spin), disk, kind in [
        *drawn,
        *((motion, drawn[0][1], kind) for kind, motion in plain.items()),
        (drawn[0][0], drawn[1][1], "the motion of the first disk, and another disk"),
    ]:
        state = steady(lean, precession, spin)
        found = student.on(kind).steady_residual(lean, precession, spin, **disk)
        expect(
            found,
            jourdain(state, **disk)[0][1],
            kind=kind,
            within=POINTWISE,
            scale=usual(disk) ** 2,
            of="tilt''",
            unit="of g/a",
            at=(state, disk),
            hint="put tilt = lean + pi/2 and tilt' = 0 into your equations",
        )


# (e) The picture


def angles_in_disk(points, state, radius):
    """Angles in the body's plane, and how far the points are from the rim, in radii."""
    body = (points - placed(state, radius=radius)[:3]) @ attitude(state) / radius
    off = np.hypot(np.hypot(body[..., 0], body[..., 1]) - 1.0, body[..., 2])
    return np.arctan2(body[..., 1], body[..., 0]), off


def turned(angles, by):
    """Angles less a whole number of `by`, between -by/2 and by/2."""
    return (angles + by / 2) % by - by / 2


@check(points=0.5, part="e")
def wireframe_is_a_rolling_disk(student, draw):
    """wireframe is a closed regular polygon on the rim, and two perpendicular diameters that roll with the disk."""
    # five, always: a star of five sides is as regular as the pentagon
    for sides in (int(draw.integers(7, 30)), 3, 4, 5, 6):
        judge_wireframe(student, draw, a_disk(draw, "a wheel"), sides, f"{sides} sides" if sides < 7 else "many sides")


def judge_wireframe(student, draw, disk, sides, kind):
    radius, shape, step = disk["radius"], [], 2 * math.pi / sides
    for state in (a_state(draw, disk, tilt) for tilt in (0.7, 1.3, 2.5, math.pi / 2)):
        lines = student.on(kind).wireframe(state, radius=radius, sides=sides)
        expect(len(lines), sides + 2, within=0, of="the number of segments", kind=kind)
        angles, off = angles_in_disk(lines, state, radius)
        radii = off[sides:].min() <= POINTWISE
        rim_to_rim = "a diameter goes from rim to rim" if radii else "centre = contact + a e2"
        for ends, of, hint in (
            (off[:sides], "an end of a side", "centre = contact + a e2"),
            (off[sides:], "an end of a diameter", rim_to_rim),
        ):
            expect(ends.max(), 0.0, within=POINTWISE, of=of, unit="radii from the rim", at=state, kind=kind, hint=hint)
        across = turned(angles[:, 1] - angles[:, 0], 2 * math.pi)
        middle = np.sort((angles[:sides, 0] + across[:sides] / 2) % (2 * math.pi))
        expect(
            np.abs(across),
            [step] * sides + [math.pi] * 2,
            within=1e-8,
            of="the angle that a segment spans",
            unit="rad",
            at=state,
            kind=kind,
            hint="the polygon first, then the diameters",
        )
        apart = np.diff(middle).min() > step / 2
        expect_that(apart, "two sides are drawn in one place, and one is missing", kind=kind, at=state)
        expect(
            np.diff(middle),
            step,
            within=1e-8,
            of="the angle from side to side",
            unit="rad",
            at=state,
            kind=kind,
            hint="the polygon is closed",
        )
        quarter = abs(turned(angles[-1, 0] - angles[-2, 0], math.pi))
        expect(quarter, math.pi / 2, within=1e-8, of="the angle between the diameters", unit="rad", at=state, kind=kind)
        shape.append(angles[sides:, 0])
    expect(
        turned(np.diff(shape, axis=0), math.pi),
        0.0,
        within=1e-8,
        of="the diameters' place in the disk",
        unit="rad",
        at=shape,
        kind=kind,
        hint="do they roll with the disk?",
    )


# (f) Energy and force


def with_centre(axis, times):
    """The energy with that many times m (a w)^2/2 more, w the component of omega along one of e1, e2, e3."""
    return lambda state, **disk: (
        energy(state, **disk) + 0.5 * times * disk["mass"] * (disk["radius"] * components(state)[axis]) ** 2
    )


def weight_moment(*, mass, radius, gravity, **_):
    return mass * gravity * radius


@check(
    points=0.5,
    part="f",
    suspects=[
        suspect(SPIN, energy=lambda state, **disk: energy(rolling_alone(state), **disk)),
        suspect(
            "the energy of turning alone: that of the moving centre left out",
            energy=lambda state, **disk: (
                energy(state, **disk)
                - 0.5 * disk["mass"] * disk["radius"] ** 2 * (components(state)[0] ** 2 + components(state)[2] ** 2)
            ),
        ),
        *(
            suspect(f"the energy of the moving centre left out that comes from {rate}", energy=with_centre(axis, -1))
            for rate, axis in (("tilt'", 0), ("the spin", 2))
        ),
        suspect("m a^2 added to A for the rate along e2: the contact lies on e2", energy=with_centre(1, 1)),
        suspect(
            "the potential 0 where the disk is upright; it is 0 with the centre on the ground",
            energy=lambda state, **disk: energy(state, **disk) - weight_moment(**disk),
        ),
        suspect(
            "the height a of the upright disk, whatever the tilt",
            energy=lambda state, **disk: energy(state, **disk) + weight_moment(**disk) * (1 - math.sin(state[3])),
        ),
    ],
)
def energy_is_kinetic_and_potential(student, draw):
    """energy adds what moves, what turns and what is high."""

    def scale(state, disk):
        return (disk["mass"] * disk["radius"] ** 2 + sum(disk["inertia"])) * second_scale(state, disk)

    judge_instants(student.energy, draw, energy, scale=scale, of="the energy", look=wrong_energy)


def wrong_energy(offs, limits, cases):
    at_rest = [not np.any(state[5:]) for state, *_ in cases]
    if np.any((np.abs(offs) > limits)[at_rest]):
        return "at rest it is wrong too: what is the height of the centre?"
    return "at rest it is right: the speed of the centre, or the turning about it?"


def judge_instants(function, draw, right, *, scale, of, look):
    """A function of Euler states at all instants; look(offs, limits, cases) says more of what is wrong."""
    cases = instants(draw) + plain_instants(draw)
    results = function.many([given(state, **disk).on(kind) for state, disk, kind in cases])

    def where():
        offs = np.array([found - right(state, **disk) for found, (state, disk, _) in zip(results, cases, strict=True)])
        limits = np.array([POINTWISE * scale(state, disk) for state, disk, _ in cases])
        wrong = np.abs(offs).reshape(len(cases), -1).max(axis=1) > limits
        return half_wrong([state for state, *_ in cases], wrong) or look(offs, limits, cases)

    for found, (state, disk, kind) in zip(results, cases, strict=True):
        expect(
            found,
            right(state, **disk),
            within=POINTWISE,
            scale=scale(state, disk),
            of=of,
            unit="of its terms",
            at=(state, disk),
            kind=kind,
            hint=where,
        )


@check(points=0.25, part="f", after=(euler_simulation_follows_the_motion, energy_is_kinetic_and_potential))
def energy_is_conserved(student, draw):
    """The energy of simulate_euler's motion stays what it was, over a long time."""
    for t, state, disk, kind, rough in starts(draw, 1, 20.0, 6):
        states = student.on(kind).simulate_euler(t, state, **disk)
        found, right = np.array([energy(row, **disk) for row in states]), energy(state, **disk)
        hint = tight_hint(np.abs(found / right - 1).max(), ENERGY)
        said = {"t": t, "kind": kind, "at": (state, disk), "hint": hint}
        expect_rolling(states, rough, **said)
        expect(
            found,
            right,
            within=ENERGY,
            scale=right,
            of="the energy",
            unit="of itself",
            partial={1e-4: 0.6, 1e-3: 0.3},
            **said,
        )


def body_fixed_force(state, *, mass, radius, gravity, **rest):
    """a omega' x e2 + a omega x (omega x e2) for the acceleration, omega' as it would be then."""
    E, w = frame(state), placed(state, radius=1.0)[12:]
    alpha = spun_omega_rate(state, ("fixed",), mass=mass, radius=radius, gravity=gravity, **rest)
    arm = radius * E[1]
    return mass * (np.cross(alpha, arm) + np.cross(w, np.cross(w, arm)) + gravity * Z)


def force_by(wrong):
    """The force of the right kinematics, with omega' of wrong equations of motion."""

    def contact_force(state, **disk):
        E, w = frame(state), placed(state, radius=1.0)[12:]
        e2_rate = np.cross(state[5] * Z + state[6] * E[0], E[1])
        changed = np.cross(spun_omega_rate(state, wrong, **disk), E[1])
        acceleration = disk["radius"] * (changed + np.cross(w, e2_rate))
        return disk["mass"] * (acceleration + disk["gravity"] * Z)

    return contact_force


def with_weight(force, times=1, *, mass, gravity, **_):
    return force + times * mass * gravity * Z


def force_without_frame_rate(state, **disk):
    """As if the velocity of the centre, radius (-w3, 0, w1) along e1, e2, e3, changed by its components alone."""
    w1_rate, _, w3_rate = spun(state, **disk)
    return with_weight(disk["mass"] * disk["radius"] * np.array([-w3_rate, 0.0, w1_rate]) @ frame(state), **disk)


@check(
    points=0.75,
    part="f",
    suspects=[
        *told("contact_force", force_by, IN_EULER, within=CLOSE),
        suspect([*WRONG][0], contact_force=body_fixed_force),
        suspect(
            "the weight left out",
            contact_force=lambda state, **disk: force(state, **disk) - disk["mass"] * disk["gravity"] * Z,
        ),
        suspect("the force of the disk on the ground", contact_force=lambda *a, **k: -force(*a, **k)),
        suspect(
            "the components along e1, e2, e3", contact_force=lambda state, **disk: frame(state) @ force(state, **disk)
        ),
        suspect(
            "the components along axes that roll with the disk",
            contact_force=lambda state, **disk: attitude(state).T @ force(state, **disk),
        ),
        suspect(
            "the components of the acceleration along e1, e2, e3 brought to space by R, which rolls",
            contact_force=lambda state, **disk: with_weight(
                attitude(state) @ frame(state) @ with_weight(force(state, **disk), -1, **disk), **disk
            ),
        ),
        suspect(
            "the acceleration without the rate of e1, e2, e3, along which the velocity is taken",
            contact_force=force_without_frame_rate,
        ),
    ],
)
def contact_force_moves_the_centre(student, draw):
    """contact_force is what the centre's acceleration and the weight ask for, in space axes."""

    def scale(state, disk):
        return disk["mass"] * disk["radius"] * second_scale(state, disk)

    judge_instants(student.contact_force, draw, force, scale=scale, of="the force", look=wrong_force)


def wrong_force(offs, limits, cases):
    """What is wrong with the force, if it can be told."""
    rights = [with_weight(force(state, **disk), -1, **disk) for state, disk, _ in cases]
    sizes = [abs(np.linalg.norm(right + off) - np.linalg.norm(right)) for right, off in zip(rights, offs, strict=True)]
    if np.all(sizes <= limits):
        return "m a of G has the right size and a wrong direction: are its components those along space x, y, z?"
    along = wrong_along("it", offs, [state for state, *_ in cases], limits)
    return along or "F = m a of G; the axes along which its velocity is known turn"


# (g) and (h) Stability


def without_ma2(*, mass, radius, inertia, gravity):
    """What becomes of C + m a^2 when it is taken for C, as a part of itself."""
    return inertia[1] / (inertia[1] + mass * radius**2)


def growth_without_ma2(speed, **disk):
    still = growth(0.0, **disk)
    return still + (growth(speed, **disk) - still) * without_ma2(**disk)


@check(
    points=0.5,
    part="g",
    suspects=[
        suspect(says, critical_speed=with_inertia(critical, change))
        for says, change in (
            ("A and C swapped", lambda A, C: (C, A)),
            ("C/2 for A, as of a thin disk", lambda A, C: (C / 2, C)),
        )
    ]
    + [
        suspect(
            "the thin uniform disk's m a^2/4 and m a^2/2, whatever A and C",
            within=1e-8,
            critical_speed=thin_disk(critical),
        ),
        suspect(
            "m a^2 missing beside C", critical_speed=lambda **disk: critical(**disk) / math.sqrt(without_ma2(**disk))
        ),
        suspect(
            "9.81 m/s^2, whatever the gravity", critical_speed=lambda **disk: critical(**{**disk, "gravity": 9.81})
        ),
        suspect("the critical spin for the speed", critical_speed=lambda **disk: critical(**disk) / disk["radius"]),
    ],
)
def critical_speed_parts_stable_from_unstable(student, draw):
    """critical_speed is the centre's speed at which a small lean neither grows nor swings."""
    cases = critical_speeds(draw)
    speeds = student.critical_speed.many([given(**disk).on(kind) for disk, *_, kind in cases])
    for found, (disk, right, scale, kind) in zip(speeds, cases, strict=True):
        expect(
            found,
            right,
            within=1e-7,
            scale=scale,
            of="the critical speed",
            unit="of itself",
            at=disk,
            kind=kind,
            hint="linearise; what is yaw' to first order?",
        )


@check(
    points=0.75,
    part="h",
    suspects=[
        suspect("the sign turned round", growth_rate_squared=lambda *a, **k: -growth(*a, **k)),
        suspect("A and C swapped", growth_rate_squared=with_inertia(growth, lambda A, C: (C, A))),
        suspect(
            "m a^2 missing about the contact",
            growth_rate_squared=lambda speed, **disk: (
                growth(speed, **disk) * (1 + disk["mass"] * disk["radius"] ** 2 / disk["inertia"][0])
            ),
        ),
        suspect("m a^2 missing beside C", growth_rate_squared=growth_without_ma2),
        suspect(
            "C/2 for A, as of a thin disk",
            within=1e-8,
            growth_rate_squared=with_inertia(growth, lambda A, C: (C / 2, C)),
        ),
        suspect(
            "9.81 m/s^2, whatever the gravity",
            growth_rate_squared=lambda speed, **disk: growth(speed, **{**disk, "gravity": 9.81}),
        ),
        suspect(
            "the spin for the speed", growth_rate_squared=lambda speed, **disk: growth(speed * disk["radius"], **disk)
        ),
    ],
)
def growth_rate_is_that_of_a_small_lean(student, draw):
    """growth_rate_squared is the lean's, on both sides of the critical speed, at rest and without gravity."""
    cases = growths(draw)
    rates = student.growth_rate_squared.many([given(speed, **disk).on(kind) for speed, disk, *_, kind in cases])
    for found, (speed, disk, right, scale, kind) in zip(rates, cases, strict=True):
        expect(
            found,
            right,
            within=1e-7,
            scale=scale,
            at=(speed, disk),
            of="the square of the rate",
            unit="of its terms",
            kind=kind,
            hint="linearise about upright",
        )
