"""Hidden checks of hw05. What is right comes from the linear equations for acceleration and constraint force together,
and from elliptic functions."""

import math
from functools import partial

import numpy as np
from scipy.special import ellipj, ellipkinc

from tam570_grader import (
    Failed,
    array,
    check,
    expect,
    expect_that,
    given,
    kept,
    mistimed,
    number,
    once,
    rows,
    suspect,
    uneven,
)

RESULTS = {
    "constraint_force": array(2),
    "acceleration": array(2),
    "consistent_state": array(4),
    "energy": number,
    "simulate": rows(4),
    "wireframe": array(1, 2, 2),
}
NEEDS = ("numpy",)

KNOWN = 1e-6  # to tell one mistake from another
NEARLY = 1e-2  # of its size: what is off by less is integrated badly, what is off by more is wrong, to choose the words
POINTWISE = 1e-9  # a few roundings make 1e-15, a linear system 1e-14
TRAJECTORY = 3e-5  # solve_ivp at rtol 1e-9, atol 1e-9 is off by 3e-6 after three periods
# of m g l: in the 100 s the same solvers lose 5e-6 of it (LSODA, the rows put back onto the circle), and 5e-5 (RK45)
# where the rates take the distance from the hinge for l, whatever it has become between the rows
ENERGY = 5e-5
CONSTRAINT = 1e-9  # of the contract: any step back onto the circle makes 1e-15, and 1e-12 between steps
TOP = 1e-6  # an angle of pi, which is rounded, falls by 1e-16 exp(8) = 4e-13
LONG = 100.0  # s
BETTER = 0.1  # of the error is left where the steps are what is wrong, with so many times for one, to choose the words
BETWEEN = 20
SAMPLED = "with more times in between, the same motion comes out far better: how t is sampled must not change it"
UNITS = ("mass", "length", "gravity")


def parameters(draw, *, gravity=None, length=None):
    """A random mass, length and gravity."""
    return {
        "mass": 10 ** draw.uniform(-1, 1),
        "length": 10 ** draw.uniform(-0.5, 0.8) if length is None else length,
        "gravity": draw.uniform(2.0, 25.0) if gravity is None else gravity,
    }


def on_circle(theta, omega, length):
    """The state (..., 4) at an angle from straight down."""
    s, c, speed = np.sin(theta), np.cos(theta), length * np.asarray(omega)
    return np.stack([length * s, -length * c, speed * c, speed * s], axis=-1)


def kinds(draw):
    """Random consistent states with parameters: moving, at rest, without gravity; and what to call them."""
    found = []
    for kind in ["a random state"] * 10 + ["a particle at rest"] * 3 + ["no gravity"] * 4:
        known = parameters(draw, gravity=0.0 if kind == "no gravity" else None)
        omega = draw.uniform(1, 5) * draw.choice([-1, 1]) * (kind != "a particle at rest")
        found.append((on_circle(draw.uniform(-3, 3), omega, known["length"]), known, kind))
    return found + plain(draw)


PLACES = {"the bottom": (0.0, -1.0), "the top": (0.0, 1.0), "the right": (1.0, 0.0), "the left": (-1.0, 0.0)}
PACES = {"moving either way": (1.0, -1.0), "at rest": (0.0,)}


def plain(draw):
    """As `kinds`: states with exact zeros in them, moving and at rest, with gravity and without, and of unit size."""
    found = []
    for place, (x, y) in PLACES.items():
        for pace, signs in PACES.items():
            for known, rest in (
                (parameters(draw), ""),
                (parameters(draw, gravity=0.0), ", no gravity"),
                (dict.fromkeys(UNITS, 1.0), ", all parameters 1"),
            ):
                length, speed = known["length"], 1.0 if "1" in rest else draw.uniform(1, 5)
                for sign in signs:
                    state = np.array([x * length, y * length, -y * sign * speed, x * sign * speed])
                    found.append((state, known, f"a particle at {place}, {pace}{rest}"))
    return found


def size(state, *, mass, length, gravity):
    """The size of an acceleration, m/s^2."""
    return state[2:] @ state[2:] / length + gravity or 1.0


def together(state, *, mass, length, gravity):
    """Acceleration and constraint force as one linear system: m a - N r = (0, -m g), r . a = -v . v."""
    r, v = state[:2], state[2:]
    matrix = np.block([[mass * np.eye(2), -r[:, None]], [r, np.zeros(1)]])
    *a, pull = np.linalg.solve(matrix, [0.0, -mass * gravity, -v @ v])
    return np.array(a), pull * r


def wrong_law(says, outward):
    """With outward(y, v^2, m, l, g) for the radial component of the constraint force."""

    def force(state, *, mass, length, gravity):
        x, y, vx, vy = state
        return outward(y, vx**2 + vy**2, mass, length, gravity) * np.array([x, y]) / length

    def sum_over_mass(state, *, mass, length, gravity):
        return force(state, mass=mass, length=length, gravity=gravity) / mass - [0.0, gravity]

    return suspect(says, constraint_force=force, acceleration=sum_over_mass)


LAW_SUSPECTS = [
    wrong_law(
        "the constraint differentiated once, to r . v = 0, and r . a = 0 for the second time: the centripetal "
        "term is missing",
        lambda y, vv, m, L, g: m * g * y / L,
    ),
    wrong_law("a radial force without the weight's share", lambda y, vv, m, L, g: -m * vv / L),
    wrong_law("the centripetal term of the wrong sign", lambda y, vv, m, L, g: m * (g * y + vv) / L),
    wrong_law("the weight's share of the wrong sign", lambda y, vv, m, L, g: -m * (g * y + vv) / L),
    wrong_law("the force for a length of 1 m", lambda y, vv, m, L, g: m * (g * y - vv)),
    wrong_law("the force on the hinge, which is opposite", lambda y, vv, m, L, g: m * (vv - g * y) / L),
    wrong_law("no constraint force, a free fall", lambda y, vv, m, L, g: 0.0),
    wrong_law("the mass left out of the centripetal term", lambda y, vv, m, L, g: (m * g * y - vv) / L),
    wrong_law(
        "the weight's share of the wrong sign above the hinge", lambda y, vv, m, L, g: -m * (g * abs(y) + vv) / L
    ),
    wrong_law("a string, which does not push", lambda y, vv, m, L, g: min(m * (g * y - vv) / L, 0.0)),
]


def summed(state, *, mass, length, gravity):
    """The sum of both forces."""
    return mass * together(state, mass=mass, length=length, gravity=gravity)[0]


def below(state, *, mass, length, gravity):
    """The acceleration at the point of the circle below the particle."""
    lower = np.array([state[0], -math.sqrt(max(length**2 - state[0] ** 2, 0.0)), *state[2:]])
    return together(lower, mass=mass, length=length, gravity=gravity)[0]


# What to say of these, which are no suspects: where they are zero nothing but rounding is left to compare.
# Of the acceleration, and of the force:
KNOWN_VECTORS = (
    {
        "it is the forces' sum, not divided by the mass": summed,
        "it is right below the hinge alone, where y = -sqrt(l^2 - x^2)": below,
    },
    {"the weight is counted in: the constraint force is that of the rod alone": summed},
)


def judge_law(student, draw, name, index, says, hint):
    """Compare acceleration (index 0) or force (index 1) with the solution of the linear system."""
    found = kinds(draw)
    vectors = getattr(student, name).many([given(state, **known).on(kind) for state, known, kind in found])
    for vector, (state, known, kind) in zip(vectors, found, strict=True):
        unit = known["mass"] if index else 1.0
        expect(
            vector,
            together(state, **known)[index],
            within=POINTWISE,
            scale=unit * size(state, **known),
            of=says,
            unit="of its size",
            kind=kind,
            at=(state, known),
            hint=lambda: known_vector(vectors, found, KNOWN_VECTORS[index]) or hint,
        )


def known_vector(vectors, found, mistakes):
    """What to say if the results are one of the mistakes."""
    for says, wrong in mistakes.items():
        pairs = [
            (vector - wrong(state, **known), known["mass"] * size(state, **known))
            for vector, (state, known, _) in zip(vectors, found, strict=True)
        ]
        if all(np.abs(off).max() <= KNOWN * largest for off, largest in pairs):
            return says
    return ""


UNIT_MASS = suspect(
    "the force on a mass of 1 kg",
    constraint_force=lambda state, mass, length, gravity: together(state, mass=1.0, length=length, gravity=gravity)[1],
)


@check(points=2, part="a", suspects=[*LAW_SUSPECTS, UNIT_MASS])
def force_keeps_the_particle_on_the_circle(student, draw):
    """constraint_force: radial, and such that F = m a keeps x^2 + y^2 as it is."""
    judge_law(
        student,
        draw,
        "constraint_force",
        1,
        "the constraint force",
        "differentiate x^2 + y^2 = l^2 twice; F = m a then leaves one unknown",
    )


@check(points=1.5, part="a", suspects=LAW_SUSPECTS)
def acceleration_is_that_of_both_forces(student, draw):
    """acceleration: by the weight and the constraint force."""
    judge_law(student, draw, "acceleration", 0, "the acceleration", "what is r . a on the circle?")


def wrong_state(says, mended):
    """With mended(x, y, vx, vy, l) for the consistent state."""
    return suspect(says, consistent_state=lambda state, length: np.array(mended(*state, length)))


def without_radial_part(x, y, vx, vy):
    along = (x * vx + y * vy) / (x**2 + y**2)
    return vx - along * x, vy - along * y


def above_or_below(x, y, vx, vy, L):
    """The point of the circle on the same upright line, the velocity tangent there."""
    y = math.copysign(math.sqrt(max(L**2 - x**2, 0)), y)
    along = (x * vx + y * vy) / L**2
    return x, y, vx - along * x, vy - along * y


def with_angular_momentum(x, y, vx, vy, L):
    """The tangent part larger as the radius is smaller."""
    vx, vy = without_radial_part(x, y, vx, vy)
    return *np.array([x, y]) * L / math.hypot(x, y), *np.array([vx, vy]) * math.hypot(x, y) / L


def sense(turning):
    """1 or -1; there is none, and no number, for a velocity along the radius."""
    return turning / abs(turning) if turning else math.nan


STATE_SUSPECTS = [
    wrong_state(
        "the velocity left as it was", lambda x, y, vx, vy, L: (*np.array([x, y]) * L / math.hypot(x, y), vx, vy)
    ),
    wrong_state("the position left as it was", lambda x, y, vx, vy, L: (x, y, *without_radial_part(x, y, vx, vy))),
    wrong_state(
        "a position moved along y, not along its radius",
        lambda x, y, vx, vy, L: (x, math.copysign(math.sqrt(max(L**2 - x**2, 0)), y), vx, vy),
    ),
    wrong_state("a position moved along y, not along its radius, and a velocity tangent there", above_or_below),
    wrong_state(
        "a velocity turned into the tangent with all of its speed",
        lambda x, y, vx, vy, L: (
            *np.array([x, y]) * L / math.hypot(x, y),
            *np.array([-y, x]) / math.hypot(x, y) * math.hypot(vx, vy) * sense(x * vy - y * vx),
        ),
    ),
    wrong_state(
        "the velocity's radial part over l^2, where the square of the distance from the hinge belongs",
        lambda x, y, vx, vy, L: (
            *np.array([x, y]) * L / math.hypot(x, y),
            *np.array([vx, vy]) - (x * vx + y * vy) / L**2 * np.array([x, y]),
        ),
    ),
    wrong_state(
        "the angular momentum about the hinge kept, where the tangent part of the velocity is to be",
        with_angular_momentum,
    ),
    wrong_state(
        "a velocity scaled as the position is",
        lambda x, y, vx, vy, L: (
            *np.array([x, y]) * L / math.hypot(x, y),
            *np.array(without_radial_part(x, y, vx, vy)) * L / math.hypot(x, y),
        ),
    ),
]


def plainly_off(call):
    """Calls on an axis, on the circle and just off it, its velocity along an axis, aslant or none."""
    (state,), length = call.args, call.kwargs["length"]
    speed = math.hypot(*state[2:])
    directions = *PLACES.values(), (0.0, 0.0), (0.6, 0.8)
    calls = [
        given(np.array([x * far, y * far, vx * speed, vy * speed]), length=length)
        for x, y in (*PLACES.values(), (0.6, -0.8))
        for far in (length, length * (1 + 1e-7), length / 2, length * 20)
        for vx, vy in directions
    ]
    calls += [
        given(np.array([*(5e-7 * np.array(place)), *state[2:]]), length=0.5) for place in ((0.6, -0.8), (0.0, 1.0))
    ]
    whole = (1.0, 0.0, 0.0, 1.0), (0.0, -2.0, 1.0, 1.0), (3.0, 4.0, 0.0, 0.0), (-3.0, 4.0, -3.0, 4.0)
    return calls + [given(np.array(numbers), length=1.0) for numbers in whole]


def where(call):
    """What to call a state by its distance from the circle."""
    far = math.hypot(*call.args[0][:2]) / call.kwargs["length"]
    if far < 1e-5:
        return "a particle close to the origin"
    off = abs(far - 1)
    beside = "just off the circle" if off < 1e-6 else "off the circle"
    return f"a particle {'on the circle already' if off < 1e-12 else beside}"


def of_speed(found, state):
    """What to say of a wrong state: whether it has all of the speed."""
    if math.isclose(math.hypot(*found[2:]), math.hypot(*state[2:]), rel_tol=POINTWISE):
        return "it has all of the speed, of which the radial part is to be lost"
    return "the nearest point of the circle is on the same radius; which part of v is along it?"


@check(points=1.25, part="a", suspects=STATE_SUSPECTS)
def consistent_state_is_the_nearest(student, draw):
    """consistent_state: the position goes along its radius onto the circle, the velocity loses its radial part."""
    calls = [given(draw.normal(size=4) * draw.uniform(0.5, 4), length=10 ** draw.uniform(-0.5, 0.8)) for _ in range(12)]
    calls += plainly_off(calls[0])
    kinds = [where(call) for call in calls]
    named = [call.on(kind) for call, kind in zip(calls, kinds, strict=True)]
    for found, call, kind in zip(student.consistent_state.many(named), calls, kinds, strict=True):
        (state,), length = call.args, call.kwargs["length"]
        place, velocity = complex(*state[:2]), complex(*state[2:])
        outward = place / abs(place)
        across = 1j * outward * (velocity / outward).imag
        right = [*(length * np.array([outward.real, outward.imag])), across.real, across.imag]
        expect(
            found,
            right,
            within=POINTWISE,
            scale=np.repeat([length, abs(velocity) or 1.0], 2),
            of="the state",
            unit="of its size",
            kind=kind,
            at=call,
            hint=partial(of_speed, found, state),
        )


@check(points=0.25, part="a", after=consistent_state_is_the_nearest)
def consistent_state_refuses_the_origin(student, draw):
    """consistent_state raises ValueError where no point of the circle is the nearest."""
    state = np.append([0.0, 0.0], draw.normal(size=2))
    expect_that(
        student.consistent_state.refuses(state, length=draw.uniform(0.5, 2)),
        at=state,
        says="a state at the origin is taken",
        hint="which point of the circle is nearest to its centre?",
    )


ENERGY_SUSPECTS = [
    suspect(
        "the weight's potential energy of the wrong sign",
        energy=lambda state, mass, gravity: mass * (state[2:] @ state[2:] / 2 - gravity * state[1]),
    ),
    suspect(
        "the kinetic energy without its half",
        energy=lambda state, mass, gravity: mass * (state[2:] @ state[2:] + gravity * state[1]),
    ),
    suspect(
        "the height without its sign",
        energy=lambda state, mass, gravity: mass * (state[2:] @ state[2:] / 2 + gravity * abs(state[1])),
    ),
    suspect(
        "the height taken along x",
        energy=lambda state, mass, gravity: mass * (state[2:] @ state[2:] / 2 + gravity * state[0]),
    ),
    suspect(
        "the energy of a mass of 1 kg",
        energy=lambda state, mass, gravity: state[2:] @ state[2:] / 2 + gravity * state[1],
    ),
]


@check(points=1, part="a", suspects=ENERGY_SUSPECTS)
def energy_is_kinetic_and_potential(student, draw):
    """energy: m v^2/2 and that of the weight, zero at y = 0."""
    found = kinds(draw)
    calls = [given(state, mass=known["mass"], gravity=known["gravity"]) for state, known, _ in found]
    calls = [call.on(kind) for call, (*_, kind) in zip(calls, found, strict=True)]
    for energy, call, (state, known, kind) in zip(student.energy.many(calls), calls, found, strict=True):
        weight = np.array([0.0, -known["mass"] * known["gravity"]])
        right = known["mass"] * abs(complex(*state[2:])) ** 2 / 2 - weight @ state[:2]
        scale = known["mass"] * known["length"] * size(state, **known)
        expect(
            energy,
            right,
            within=POINTWISE,
            scale=scale,
            of="the energy",
            unit="of its size",
            kind=kind,
            at=call,
            hint="how high is it above y = 0, and how fast?",
        )


def exact(t, theta, omega, *, mass, length, gravity):
    """States at times t since (theta, omega), |theta| < pi, by Jacobi's functions; above modulus one it turns."""
    if gravity == 0:
        return on_circle(theta + omega * t, np.full(len(t), omega), length)
    k, half = math.sqrt(gravity / length), theta / 2
    m = math.sin(half) ** 2 + (omega / (2 * k)) ** 2
    if m < 1:
        since = ellipkinc(math.atan2(math.sin(half), omega / (2 * k)), m)
        sn, cn, _, _ = ellipj(since + k * t, m)
        return on_circle(2 * np.arcsin(math.sqrt(m) * sn), 2 * k * math.sqrt(m) * cn, length)
    spin = math.copysign(k * math.sqrt(m), omega)
    _, _, dn, phase = ellipj(ellipkinc(half, 1 / m) + spin * t, 1 / m)
    return on_circle(2 * phase, 2 * spin * dn, length)


def beside_zero(draw, span, count, signs=(-1, 1)):
    """Uneven times over a span that do not start at zero, but before it or after."""
    return uneven(draw, span, count, 0.0) + span * draw.uniform(0.2, 0.8) * draw.choice(signs)


def start(draw, kind, known):
    """Angle and its rate of a motion of this kind, and the time that it takes to go round once, about."""
    sign = draw.choice([-1, 1], 2)
    if kind == "no gravity":
        omega = draw.uniform(1, 4) * sign[0]
        return draw.uniform(-3, 3), omega, 2 * math.pi / abs(omega)
    k = math.sqrt(known["gravity"] / known["length"])
    theta, omega = {
        "swinging": (draw.uniform(0.8, 2.2), draw.uniform(0.2, 0.6) * k),
        "going round over the top": (draw.uniform(0, 3), draw.uniform(2.3, 3) * k),
    }[kind]
    return theta * sign[0], omega * sign[1], 2 * math.pi / k


@once
def timed(draw, kind, turns, count, signs=(-1, 1)):
    """Uneven times, the right states, and the parameters of a random motion of this kind."""
    known = parameters(draw, gravity=0.0 if kind == "no gravity" else None)
    theta, omega, turn = start(draw, kind, known)
    t = beside_zero(draw, turns * turn, count, signs)
    return t, exact(t - t[0], theta, omega, **known), known


def speed_of(states, known):
    """The size of the speeds along a motion."""
    return max(np.abs(states[:, 2:]).max(), math.sqrt(known["gravity"] * known["length"])) or 1.0


def judge_motion(student, found, within, kind, hint):
    t, expected, known = found
    kind = f"{kind}, times from {'below' if t[0] < 0 else 'above'} zero on"
    states = student.on(kind).simulate(t, expected[0], **known)
    scale = np.repeat([known["length"], speed_of(expected, known)], 2)
    expect(
        states,
        expected,
        within=within,
        scale=scale,
        of="the motion",
        unit="of its size",
        t=t,
        kind=kind,
        hint=lambda: of_motion(student, found, states, scale, kind) or near_miss(found, states) or hint,
        at=found,
        keeps=lambda: kept(
            t, energies(states, known) / speed_of(expected, known) ** 2, within=ENERGY, of="the energy", unit="of m v^2"
        ),
    )


def of_motion(student, found, states, scale, kind):
    """What to say of a wrong motion: what it is instead, if that can be told."""
    if kind.startswith(BUT_FOR):
        return "is something kept from one call to the next?"
    t, expected, known = found
    if np.array_equal(states, np.tile(expected[0], (len(t), 1))):
        return "every row is the start: only at rest, and exactly at the top or at the bottom, does it stay"
    if states[1:, 1].max() <= 0 and expected[1:, 1].max() > NEARLY * known["length"]:
        return "every row but the first is below the hinge: x^2 + y^2 = l^2 has two y for an x"
    if np.max(np.abs(states - from_state(t, expected[0], **known))[1:] / scale) <= NEARLY:
        return "it starts at t = 0, where the given state is that at t[0]"
    if (turning(states[1:]) * turning(expected[1:]) < 0).all():
        return "it goes round the other way: a speed has lost the sense of the rotation"
    fine = np.append(np.linspace(t[:-1], t[1:], BETWEEN, endpoint=False).T.ravel(), t[-1])
    try:
        again = student.simulate(fine, expected[0], **known)[::BETWEEN]
    except Failed:
        return ""
    better = np.max(np.abs(again - expected) / scale) < BETTER * np.max(np.abs(states - expected) / scale)
    return SAMPLED if better else ""


def turning(states):
    """x vy - y vx, counter-clockwise above zero."""
    x, y, vx, vy = states.T
    return x * vy - y * vx


def near_miss(found, states):
    """What to say of rows that are right but for a little, on a fine enough scale."""
    t, expected, known = found
    off = np.max(np.abs(states - expected) / np.repeat([known["length"], speed_of(expected, known)], 2), axis=1)
    if TRAJECTORY < off.max() <= NEARLY and off[0] <= TRAJECTORY:
        return "the motion is nearly right: is the tolerance tight, or the step short enough for this rod?"
    return ""


def energies(states, known):
    """E/m along a motion."""
    return np.sum(states[:, 2:] ** 2, axis=1) / 2 + known["gravity"] * states[:, 1]


def integrated(law):
    """The motion by law(r, v, m, l, g) for the acceleration."""

    def motion(t, state, mass, length, gravity):
        from scipy.integrate import solve_ivp

        def rates(time, y):
            return [*y[2:], *law(y[:2], y[2:], mass, length, gravity)]

        return solve_ivp(rates, (t[0], t[-1]), state, t_eval=t, rtol=1e-10, atol=1e-10).y.T

    return motion


def wrong_motion(says, law):
    """With law(r, v, m, l, g) for the acceleration, integrated."""
    return suspect(says, simulate=integrated(law), within=1e-4)


def angles(state, length):
    """Angle from straight down, and its rate."""
    x, y, vx, vy = state
    return math.atan2(x, -y), (x * vy - y * vx) / length**2


def from_state(since, state, **known):
    """As `exact`, from a state."""
    return exact(since, *angles(state, known["length"]), **known)


def linear(t, state, *, mass, length, gravity):
    """The motion around the circle that small angles would have."""
    angle, rate = angles(state, length)
    k = math.sqrt(gravity / length) or 1e-9
    z = (angle - 1j * rate / k) * np.exp(1j * k * (t - t[0]))
    return on_circle(z.real, -k * z.imag, length)


def tangential(r, L, g):
    """The weight's part across the radius."""
    return np.array([g * r[0] * r[1], -g * r[0] ** 2]) / L**2


TIME_SUSPECTS = mistimed(lambda t, state, **known: from_state(t - t[0], state, **known), from_zero=from_state)
MOTION_SUSPECTS = [
    wrong_motion(
        "the centripetal term missing from the acceleration: the constraint differentiated once, r . a = 0",
        lambda r, v, m, L, g: tangential(r, L, g),
    ),
    wrong_motion("gravity pulling up", lambda r, v, m, L, g: -tangential(r, L, g) - v @ v * r / L**2),
    wrong_motion(
        "gravity divided by the mass: a heavy particle falls as a light one does",
        lambda r, v, m, L, g: tangential(r, L, g / m) - v @ v * r / L**2,
    ),
    suspect("the oscillation of small angles", within=1e-4, simulate=linear),
]


# kind, angle, its rate in sqrt(g/l) or 1/s, what is not random
WITHOUT_GRAVITY = (
    ("at rest, no gravity", 1.0, 0.0, {"gravity": 0.0}),
    ("moving at the bottom, no gravity", 0.0, 1.0, {"gravity": 0.0}),
)
SHORT = "a rod of 2 cm"
WITH_GRAVITY = (
    ("let go at rest", 1.3, 0.0, {}),
    ("let go at rest, the rod horizontal", math.pi / 2, 0.0, {}),
    ("let go at rest, close to the bottom", 1e-3, 0.0, {}),
    ("let go at rest, close to the top", math.pi - 1e-3, 0.0, {}),  # it falls by e^5 times that, as an error does
    ("at rest at the bottom", 0.0, 0.0, {}),
    ("moving at the bottom", 0.0, 1.2, {}),
    (f"moving at the top, {SHORT}", math.pi, 2.5, {"length": 0.02}),  # once round in 0.06 s or more
    ("moving, the rod horizontal, all parameters 1", -math.pi / 2, 1.0, dict.fromkeys(UNITS, 1.0)),
)


@check(points=0.75, part="a", suspects=MOTION_SUSPECTS[:1] + TIME_SUSPECTS)
def without_gravity_it_goes_round_uniformly(student, draw):
    """simulate: uniform motion around the circle where there is no gravity."""
    # after t = 0 first: an integrator from t = 0 on says nothing of times before it, but here what it takes t for
    judge_motion(
        student,
        timed(draw, "no gravity", 2.3, 12, (1,)),
        TRAJECTORY,
        "no gravity",
        "is the given state that at t[0], and row i that at t[i]? how does the velocity turn?",
    )
    for found, kind in plain_motions(draw, False):
        judge_motion(student, found, TRAJECTORY, kind, "what is there to change its velocity?")


@check(points=1, part="a", suspects=MOTION_SUSPECTS + TIME_SUSPECTS)
def with_gravity_it_swings_or_goes_round(student, draw):
    """simulate: the state at few and uneven times, the first of which is not 0."""
    for kind in ("swinging", "going round over the top"):
        judge_motion(
            student,
            timed(draw, kind, 1.8, 9),
            TRAJECTORY,
            kind,
            "does it turn by both forces, and is the given state that at t[0]?",
        )
    for found, kind in in_turn(timed(draw, "swinging", 1.8, 5)):
        judge_motion(student, found, TRAJECTORY, kind, "does it turn by both forces?")
    t, expected, known = timed(draw, "swinging", 3.1, 9)
    judge_motion(
        student,
        (t[[0, -1]], expected[[0, -1]], known),
        2 * TRAJECTORY,
        "two times far apart",
        "steps between the times, as short as the motion asks for",
    )
    for found, kind in plain_motions(draw, True):
        hint = "it is quick: are the steps as short as it asks for?" if SHORT in kind else "which force is zero there?"
        judge_motion(student, found, TRAJECTORY, kind, hint)


@once
def plain_motions(draw, weight):
    """As `timed`, at two or three times, each with its kind: from exact places, at rest or moving either way."""
    found = []
    for kind, theta, pace, fixed in WITH_GRAVITY if weight else WITHOUT_GRAVITY:
        side = draw.choice([-1, 1])
        for count, sign in ((2, side), (3, -side)):
            known = {**parameters(draw), **fixed}
            k = math.sqrt(known["gravity"] / known["length"])
            t = beside_zero(draw, draw.uniform(2, 5) / (k or 1.0), count)
            states = exact(t - t[0], theta * sign, pace * (k or 1.0) * sign, **known)
            states[0][np.abs(states[0]) < 1e-15 * np.abs(states[0]).max()] = 0.0  # sin pi and cos pi/2
            states[0][2:] *= pace != 0.0
            found.append(((t, states, known), f"{kind}; {count} times"))
    return found


BUT_FOR = "the motion of a call before, but for "


def in_turn(found):
    """As `plain_motions`: this motion, then each with one thing new to it: what is kept from a call is wrong there."""
    t, states, known = found
    span, more = t[-1] - t[0], {**known, "gravity": 1.3 * known["gravity"]}
    others = t[0] + (t - t[0]) ** 2 / span  # of the same first and last
    calls = {
        "other times": (others, states[0], known),
        "another gravity": (others, states[0], more),
        "another start": (others, states[0] * [-1, 1, -1, 1], more),
    }
    motions = [(found, "a motion that is asked for again")]
    for name, (t, state, known) in calls.items():
        states = from_state(t - t[0], state, **known)
        states[0] = state  # to the last digit, which is what one looks up what is kept by
        motions.append(((t, states, known), BUT_FOR + name))
    return motions


@once
def long_motion(draw):
    """Times over 100 s, a start and parameters: about ten to twenty swings."""
    known = parameters(draw, gravity=draw.uniform(3, 6), length=draw.uniform(3, 6))
    theta, omega, _ = start(draw, "swinging", known)
    return np.linspace(0.0, LONG, 60), on_circle(theta, omega, known["length"]), known


DRIFTS = {
    (False, False): (
        "x^2 + y^2 = l^2 or r . v = 0",
        "neither place nor velocity is kept: the acceleration keeps the second derivative of the "
        "constraint zero, and nothing takes back the errors of the steps",
    ),
    (True, False): ("r . v = 0", "the place is put back onto the circle, the velocity is not made tangent to it"),
    (False, True): ("x^2 + y^2 = l^2", "the velocity is made tangent, the place is not put back onto the circle"),
    (True, True): ("nothing", ""),
}
# whether place and velocity are right: what is off, and why


def expect_swings(states, length):
    """From 0.8 rad or more it goes 1.3 lengths to and fro; a motion that ends early keeps every invariant."""
    expect_that(
        np.ptp(states[len(states) // 2 :, 0]) > length / 2,
        "the particle does not move",
        kind="the second half of 100 s",
        hint="do all rows have the motion at their times?",
    )


@check(points=1, part="a", after=with_gravity_it_swings_or_goes_round)
def it_stays_on_the_circle(student, draw):
    """simulate: after 100 s the particle is still on the circle, and its velocity tangent to it."""
    t, state, known = long_motion(draw)
    states = student.simulate(t, state, **known)
    expect_swings(states, known["length"])
    (x, y, vx, vy), length = states.T, known["length"]
    off = (x**2 + y**2) / length**2 - 1
    out = (x * vx + y * vy) / (length * np.hypot(vx, vy).max())
    of, hint = DRIFTS[bool(np.abs(off).max() <= CONSTRAINT), bool(np.abs(out).max() <= CONSTRAINT)]
    expect(
        np.column_stack([off, out]),
        0.0,
        within=CONSTRAINT,
        of=of,
        t=t,
        unit="of its size",
        kind="100 s",
        at=(state, known),
        partial={1e-7: 0.5, 1e-5: 0.25},
        hint=hint,
    )


@check(points=0.25, part="a", after=with_gravity_it_swings_or_goes_round)
def energy_stays(student, draw):
    """simulate: after 100 s the energy is that of the start."""
    t, state, known = long_motion(draw)
    states = student.simulate(t, state, **known)
    expect_swings(states, known["length"])
    found = energies(states, known)
    expect(
        found,
        found[0],
        within=ENERGY,
        scale=known["gravity"] * known["length"],
        of="the energy",
        unit="of m g l",
        t=t,
        kind="100 s",
        at=state,
        hint="ask the integrator for a smaller error; does it leave the circle between the samples?",
        partial={1e-3: 0.6, 1e-2: 0.3},
    )


@check(points=0.5, part="a", after=with_gravity_it_swings_or_goes_round)
def at_the_very_top_it_stays(student, draw):
    """simulate: at rest straight above the hinge it is in equilibrium."""
    known = parameters(draw)
    t = np.linspace(0.0, 8 * math.sqrt(known["length"] / known["gravity"]), 9)
    states = student.simulate(t, np.array([0.0, known["length"], 0.0, 0.0]), **known)
    scale = np.repeat([known["length"], math.sqrt(known["gravity"] * known["length"])], 2)
    expect(
        states,
        [0.0, known["length"], 0.0, 0.0],
        within=TOP,
        scale=scale,
        of="the motion",
        t=t,
        unit="of its size",
        kind="a start at rest at the very top",
        at=known,
        hint="what do the two forces add up to there?",
    )


ROD_SUSPECTS = [
    suspect("a rod from the particle to the hinge", wireframe=lambda state, length: [[state[:2], [0.0, 0.0]]]),
    suspect("a rod of one metre", wireframe=lambda state, length: [[[0.0, 0.0], state[:2] / length]]),
]


@check(points=0.5, part="a", suspects=ROD_SUSPECTS)
def wireframe_is_the_rod(student, draw):
    """wireframe: one segment, from the hinge to the particle."""
    found = kinds(draw)
    rods = student.wireframe.many([given(state, length=known["length"]) for state, known, _ in found])
    for rod, (state, known, kind) in zip(rods, found, strict=True):
        expect(
            rod,
            [[[0.0, 0.0], state[:2]]],
            within=POINTWISE,
            scale=known["length"],
            of="the rod",
            unit="of its length",
            kind=kind,
            hint="its first end is the hinge, its second the particle",
            at=state,
        )
