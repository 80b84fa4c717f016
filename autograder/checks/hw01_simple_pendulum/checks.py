"""Hidden checks of hw01. What is right comes from vectors in the plane, elliptic functions, and quadrature."""

import math
from functools import partial

import numpy as np
from scipy.special import ellipj, ellipk, ellipkinc, ellipkm1

from tam570_grader import (
    SOME_TIMES,
    array,
    check,
    expect,
    expect_that,
    formula,
    given,
    group,
    kept,
    mistimed,
    number,
    once,
    rows,
    suspect,
    uneven,
)

RESULTS = {
    "linear_momentum_balance": group(number, number),
    "angular_momentum_balance": group(number, number, number),
    "energy_balance": group(number, number, number),
    "power_balance": group(number, number),
    "virtual_work": group(number, number),
    "lagrangian": formula("theta", "omega", "m", "l", "g"),
    "lagrange_equation": formula("theta", "l", "g"),
    "action": array(),
    "small_angle_solution": rows(2),
    "period": number,
    "simulate": rows(2),
}
NEEDS = ("numpy", "sympy")
OFF_LIMITS = {"*": ("tam570.lagrange",)}

NEARLY = 1e-3  # below it a quantity is right in principle, to choose the words
POINTWISE = 1e-8  # a few roundings make 1e-15, a derivative by central differences 1e-10
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 is off by 1.4e-6 after three periods, RK45 and DOP853 by less
FAR = 1e-4  # the same solvers are off by 6e-6 after sixteen periods, a hundred Runge-Kutta steps for them by 0.6
ENERGY = 1e-5  # the same solvers lose 3e-7 of it in thirty periods
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, is good to 1e-8
PERIOD_NEXT_TO_TOP = 1e-5  # there the same simulation magnifies its errors tenfold
# at 1e-5 rad, and that far from the top, the same simulation is good to 7e-5; a difference of cosines has no digit left
PERIOD_AT_THE_ENDS = 1e-3
VARIATION = 1e-4  # (2 pi 1.5/2000)^2/3 = 7e-6 by any quadrature of second order
ACTION = 1e-5  # (4/4000)^2/3 = 3e-7 by any quadrature of second order; one of first order is off by 2e-4

BALANCES = {
    "linear_momentum_balance": ("alpha", "tension"),
    "angular_momentum_balance": ("alpha", "angular momentum", "moment"),
    "energy_balance": ("alpha", "kinetic energy", "potential energy"),
    "power_balance": ("alpha", "power"),
    "virtual_work": ("alpha", "generalized force"),
}  # function: the quantities of its result


def right(theta, omega, *, mass, length, gravity):
    """Every quantity of the balances, from r, v and F as vectors of the plane."""
    along, across = (np.array([math.sin(theta), -math.cos(theta)]), np.array([math.cos(theta), math.sin(theta)]))
    r, v, force = length * along, length * omega * across, np.array([0.0, -mass * gravity])
    return {
        "alpha": across @ force / (mass * length),
        "tension": along @ force + mass * v @ v / length,
        "angular momentum": mass * (r[0] * v[1] - r[1] * v[0]),
        "moment": r[0] * force[1] - r[1] * force[0],
        "kinetic energy": mass * v @ v / 2,
        "potential energy": mass * gravity * (r[1] + length),
        "power": force @ v,
        "generalized force": length * across @ force,
    }


def scales(theta, omega, *, mass, length, gravity):
    """The scale of each quantity and what to call it."""
    rate, inertia = abs(omega) + math.sqrt(gravity / length), mass * length**2
    energy = inertia * rate**2, "of m l (l omega^2 + g)"
    return {
        "alpha": (rate**2, "of omega^2 + g/l"),
        "tension": (mass * length * rate**2, "of m (l omega^2 + g)"),
        "angular momentum": (inertia * rate, "of m l^2 (omega + sqrt(g/l))"),
        "power": (inertia * rate**3, "of m l^2 (omega + sqrt(g/l))^3"),
        **dict.fromkeys(("moment", "kinetic energy", "potential energy", "generalized force"), energy),
    }


def pendulum_of(point):
    """The arguments of a balance for which the symbols stand."""
    return point["theta"], point.get("omega", 0.0), point.get("m", 1.0), point["l"], point["g"]


def balances_suspect(says, wrong):
    """All balances with what `wrong(theta, omega, mass, length, gravity)` gives in place of the right quantities."""

    def mistaken(theta, omega, mass, length, gravity):
        known = right(theta, omega, mass=mass, length=length, gravity=gravity)
        return {**known, **wrong(theta, omega, mass, length, gravity)}

    def balance(quantities):
        return lambda *state, **pendulum: tuple(mistaken(*state, **pendulum)[name] for name in quantities)

    def equation(points):
        return [mistaken(*pendulum_of(point))["alpha"] for point in points]

    def lagrangian(points):
        found = [mistaken(*pendulum_of(point)) for point in points]
        return [each["kinetic energy"] - each["potential energy"] for each in found]

    functions = {name: balance(quantities) for name, quantities in BALANCES.items()}
    return suspect(says, lagrangian=lagrangian, lagrange_equation=equation, **functions)


def restoring(sine):
    """The quantities that depend on the sine of theta, with another function in its place."""

    def wrong(theta, omega, mass, length, gravity):
        moment = -mass * gravity * length * sine(theta)
        alpha = moment / (mass * length**2)
        return {"alpha": alpha, "moment": moment, "power": moment * omega, "generalized force": moment}

    return wrong


def tension(pull):
    """A wrong tension; pull(sin theta, cos theta, m l omega^2, m g)."""

    def wrong(theta, omega, mass, length, gravity):
        return {"tension": pull(math.sin(theta), math.cos(theta), mass * length * omega**2, mass * gravity)}

    return wrong


def potential(height):
    """A wrong potential energy; height(theta) in lengths."""

    def wrong(theta, omega, mass, length, gravity):
        return {"potential energy": mass * gravity * length * height(theta)}

    return wrong


def in_degrees(theta, omega, mass, length, gravity):
    return right(math.radians(theta), omega, mass=mass, length=length, gravity=gravity)


def size_of_sine(theta):
    return abs(math.sin(theta))


def root_for_sine(theta):
    return math.sqrt(1 - math.cos(theta) ** 2)  # as size_of_sine, but exactly zero at the top


def for_unit_length(theta, omega, mass, length, gravity):
    return {"alpha": -gravity * math.sin(theta)}


DEGREES = "the angle taken for degrees"
BALANCE_SUSPECTS = [
    balances_suspect("cos theta where sin theta belongs", restoring(math.cos)),
    balances_suspect("the sign of gravity's term missing", restoring(lambda th: -math.sin(th))),
    balances_suspect("the linearised equation, theta for sin theta", restoring(lambda th: th)),
    balances_suspect(DEGREES, in_degrees),
    *(
        balances_suspect(
            "the size of the sine of theta, where its sign matters: theta may be on either side", restoring(sine)
        )
        for sine in (size_of_sine, root_for_sine)
    ),
    balances_suspect("l alpha for alpha: a length too few in what it is divided by", for_unit_length),
]
MOMENTUM_SUSPECTS = [
    balances_suspect(
        "the momentum m l omega for its moment about the hinge, which is right for a length of 1 m",
        lambda th, om, m, L, g: {"angular momentum": m * L * om},
    ),
    balances_suspect(
        "the angular velocity's sign missing from the angular momentum",
        lambda th, om, m, L, g: {"angular momentum": m * L**2 * abs(om)},
    ),
    balances_suspect(
        "the weight's part across the rod for its moment about the hinge, which is right for a length of 1 m",
        lambda th, om, m, L, g: {"moment": -m * g * math.sin(th)},
    ),
]
POWER_SUSPECTS = [
    balances_suspect(
        "the speed, which has no sign, for the velocity in the power",
        lambda th, om, m, L, g: {"power": -m * g * L * math.sin(th) * abs(om)},
    ),
    balances_suspect(
        "the angular velocity for the velocity in the power, which is right for a length of 1 m",
        lambda th, om, m, L, g: {"power": -m * g * math.sin(th) * om},
    ),
    balances_suspect(
        "the sign of the power reversed", lambda th, om, m, L, g: {"power": m * g * L * math.sin(th) * om}
    ),
]
TENSION_SUSPECTS = [
    balances_suspect("a tension without m l omega^2", tension(lambda s, c, spin, weight: weight * c)),
    balances_suspect("a tension with -m l omega^2", tension(lambda s, c, spin, weight: weight * c - spin)),
    balances_suspect("gravity pushing the rod in", tension(lambda s, c, spin, weight: spin - weight * c)),
    balances_suspect("sin theta in the tension", tension(lambda s, c, spin, weight: spin + weight * s)),
    balances_suspect("a tension without the weight", tension(lambda s, c, spin, weight: spin)),
    balances_suspect(
        "the weight's part of the tension without its sign: above the hinge it pushes the rod in",
        tension(lambda s, c, spin, weight: spin + weight * abs(c)),
    ),
    balances_suspect(
        "the whole weight in the tension, where its part along the rod belongs",
        tension(lambda s, c, spin, weight: spin + weight),
    ),
    balances_suspect(
        "the tension of a string, zero where it would be negative: a rod can push",
        tension(lambda s, c, spin, weight: max(spin + weight * c, 0.0)),
    ),
    balances_suspect(
        "the tension without its sign: where the rod pushes it is negative",
        tension(lambda s, c, spin, weight: abs(spin + weight * c)),
    ),
]
ENERGY_SUSPECTS = [
    balances_suspect("a potential energy that is zero at the hinge", potential(lambda th: -math.cos(th))),
    balances_suspect("the sign of the potential energy reversed", potential(lambda th: math.cos(th) - 1)),
    balances_suspect("sin theta in the potential energy", potential(math.sin)),
    balances_suspect("the potential energy of small angles", potential(lambda th: th**2 / 2)),
    balances_suspect(DEGREES, potential(lambda th: 1 - math.cos(math.radians(th)))),
    balances_suspect(
        "the kinetic energy without its half", lambda th, om, m, L, g: {"kinetic energy": m * (L * om) ** 2}
    ),
    balances_suspect(
        "the angular velocity for the velocity in the kinetic energy, which is right for a length of 1 m",
        lambda th, om, m, L, g: {"kinetic energy": m * om**2 / 2},
    ),
]


def parameters(draw, gravity=None):
    """A random mass, length and gravity."""
    gravity = draw.uniform(1.0, 25.0) if gravity is None else gravity
    return {"mass": 10 ** draw.uniform(-1, 1), "length": 10 ** draw.uniform(-0.6, 0.8), "gravity": gravity}


def states(draw):
    """Calls at random states, the last of them without gravity."""
    angles, rates = draw.uniform(-9, 9, 18), draw.uniform(1, 6, 18) * draw.choice([-1, 1], 18)
    pendulums = [parameters(draw, gravity) for gravity in [None] * 15 + [0.0] * 3]
    calls = [given(th, om, **pendulum) for th, om, pendulum in zip(angles, rates, pendulums, strict=True)]
    return calls + plain_states(calls[0])


PLAIN = {
    0.0: "at the bottom",
    math.pi / 2: "level with the hinge",
    -math.pi / 2: "level with the hinge",
    math.pi: "at the top",
    -math.pi: "at the top",
}  # angle: what to call it


def plain_states(call):
    """Calls at the angles that have a name, with this speed either way, with gravity and without; whole numbers."""
    speed, gravity = abs(call.args[1]), call.kwargs["gravity"]
    named = [
        given(angle, turn * speed, **{**call.kwargs, "gravity": pull})
        for angle in PLAIN
        for turn, pull in ((1, gravity), (-1, gravity), (1, 0.0))
    ]
    whole = {"mass": 1.0, "length": 1.0, "gravity": 1.0}
    return [*named, *(given(*state, **whole) for state in ((1.0, 1.0), (-1.0, 2.0), (0.01, -1.0)))]


def at_rest(draw):
    """Calls at rest: anywhere, and at the angles that have a name; with gravity and without."""
    angles = [*draw.uniform(0.3, 2.8, 5), *draw.uniform(-2.8, -0.3, 2), *PLAIN, 1.0]
    return [given(th, 0.0, **parameters(draw, pull)) for th in angles for pull in (None, 0.0)]


def kind_of(call, kind):
    """What to call the pendulum of a call."""
    named = PLAIN.get(call.args[0], "")
    rest = "" if call.args[1] else "at rest"
    where = f"a pendulum {' '.join(filter(None, (rest, named)))}" if named or rest else kind
    if call.kwargs["gravity"]:
        return where
    return f"{where}, without gravity" if where != kind else "a pendulum without gravity"


def judge(student, name, quantities, calls, hint, kind="a random state, mass and length"):
    """Compare some of the quantities that a balance gives with the right ones."""
    calls = [call.on(kind_of(call, kind)) for call in calls]
    for found, call in zip(getattr(student, name).many(calls), calls, strict=True):
        known, sizes = right(*call.args, **call.kwargs), scales(*call.args, **call.kwargs)
        for quantity in quantities:
            value, (scale, unit) = found[BALANCES[name].index(quantity)], sizes[quantity]
            look = partial(quantity_hint, quantity, value, known[quantity], scale or 1.0, hint)
            expect(
                value,
                known[quantity],
                within=POINTWISE,
                scale=scale or 1.0,
                of=quantity,
                unit=unit,
                hint=look,
                at=call,
                kind=call.kind,
            )


def quantity_hint(quantity, value, known, scale, hint):
    """What to say of a quantity that is nearly right, or of a rod that does not push."""
    if abs(value - known) <= NEARLY * scale:
        return "it is nearly right: is it a difference quotient to one side, or a series cut short?"
    if quantity == "tension" and known < 0 and abs(value) <= POINTWISE * scale:
        return "it is zero where it must be negative: a rod can push"
    return hint


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS)
def newton_gives_the_acceleration(student, draw):
    """linear_momentum_balance: alpha, by F = m a along the circle."""
    judge(
        student,
        "linear_momentum_balance",
        ["alpha"],
        states(draw) + at_rest(draw),
        "draw the forces, and the component of each along the circle",
    )


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS + TENSION_SUSPECTS)
def newton_gives_the_tension(student, draw):
    """linear_momentum_balance: the tension, by F = m a along the rod."""
    judge(
        student,
        "linear_momentum_balance",
        ["tension"],
        states(draw) + at_rest(draw),
        "which way along the rod does the acceleration point when omega is not zero?",
    )


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS)
def moments_give_the_acceleration(student, draw):
    """angular_momentum_balance: alpha, by M = dH/dt about the hinge."""
    judge(
        student,
        "angular_momentum_balance",
        ["alpha"],
        states(draw) + at_rest(draw),
        "which way does the weight turn a pendulum that is out to the right?",
    )


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS + MOMENTUM_SUSPECTS)
def momentum_and_moment_are_about_the_hinge(student, draw):
    """angular_momentum_balance: r x m v and the moment of the weight, about the hinge."""
    judge(
        student,
        "angular_momentum_balance",
        ["angular momentum", "moment"],
        states(draw) + at_rest(draw),
        "how far from the hinge do momentum and weight act?",
    )


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS + ENERGY_SUSPECTS)
def energies_are_right(student, draw):
    """energy_balance: kinetic energy, and potential energy that is zero at the lowest point."""
    judge(
        student,
        "energy_balance",
        ["kinetic energy", "potential energy"],
        states(draw),
        "how high is the mass above its lowest point?",
    )


@check(points=0.25, part="a", suspects=BALANCE_SUSPECTS)
def energy_gives_the_acceleration(student, draw):
    """energy_balance: alpha, from the constancy of the energy."""
    judge(student, "energy_balance", ["alpha"], states(draw), "the terms of dE/dt have a factor in common")


def judge_at_rest(student, draw, name):
    """Compare alpha, and the kinetic energy or the power, at rest."""
    judge(student, name, BALANCES[name][:2], at_rest(draw), "the factor omega is cancelled, not divided by")


@check(points=0.25, part="a", after=energy_gives_the_acceleration)
def energy_gives_the_acceleration_at_rest(student, draw):
    """energy_balance: alpha where omega is zero, too."""
    judge_at_rest(student, draw, "energy_balance")


@check(points=0.25, part="a", suspects=BALANCE_SUSPECTS + POWER_SUSPECTS)
def power_gives_the_acceleration(student, draw):
    """power_balance: the power of gravity, and alpha from it."""
    judge(
        student,
        "power_balance",
        ["power", "alpha"],
        states(draw),
        "power is F . v: when does gravity speed the mass up?",
    )


@check(points=0.25, part="a", after=power_gives_the_acceleration)
def power_gives_the_acceleration_at_rest(student, draw):
    """power_balance: alpha where omega is zero, too."""
    judge_at_rest(student, draw, "power_balance")


FORCE_SUSPECTS = [
    balances_suspect(
        "the sign of the generalized force reversed",
        lambda th, om, m, L, g: {"generalized force": m * g * L * math.sin(th)},
    )
]


@check(points=0.5, part="a", suspects=BALANCE_SUSPECTS + FORCE_SUSPECTS)
def virtual_work_gives_the_acceleration(student, draw):
    """virtual_work: the generalized force of gravity, and alpha from it."""
    judge(
        student,
        "virtual_work",
        ["generalized force", "alpha"],
        states(draw) + at_rest(draw),
        "dr is l dtheta, across the rod",
    )


def points_of(calls, symbols):
    """The symbols' values for the arguments of calls."""
    values = [(*call.args, *call.kwargs.values()) for call in calls]
    named = [dict(zip(("theta", "omega", "m", "l", "g"), row, strict=True)) for row in values]
    return [{symbol: point[symbol] for symbol in symbols} for point in named]


@check(points=0.75, part="a", suspects=ENERGY_SUSPECTS)
def lagrangian_is_kinetic_less_potential(student, draw):
    """lagrangian: T - V in theta, omega, m, l, g, with V zero at the lowest point."""
    calls = states(draw) + at_rest(draw)
    points = points_of(calls, RESULTS["lagrangian"].symbols)
    for value, call in zip(student.lagrangian.at(points), calls, strict=True):
        known, (scale, unit) = right(*call.args, **call.kwargs), scales(*call.args, **call.kwargs)["moment"]
        expect(
            value,
            known["kinetic energy"] - known["potential energy"],
            within=POINTWISE,
            scale=scale or 1.0,
            of="the Lagrangian",
            unit=unit,
            at=call,
            kind=kind_of(call, "random numbers for the symbols"),
            hint="put numbers in: at rest at the lowest point it is zero, at rest elsewhere negative",
        )


UPSIDE_DOWN = "the sign of gravity's term missing, as with the sign of the potential energy reversed"
LAGRANGE_SUSPECTS = [
    balances_suspect(UPSIDE_DOWN, restoring(lambda th: -math.sin(th))),
    *(one for one in BALANCE_SUSPECTS if "gravity's term" not in one.says),
]


@check(points=0.75, part="a", suspects=LAGRANGE_SUSPECTS)
def lagrange_gives_the_acceleration(student, draw):
    """lagrange_equation: alpha in theta, l, g alone."""
    calls = states(draw) + at_rest(draw)
    points = points_of(calls, RESULTS["lagrange_equation"].symbols)
    for value, call in zip(student.lagrange_equation.at(points), calls, strict=True):
        scale, unit = scales(*call.args, **call.kwargs)["alpha"]
        expect(
            value,
            right(*call.args, **call.kwargs)["alpha"],
            within=POINTWISE,
            scale=scale or 1.0,
            of="alpha",
            unit=unit,
            at=call,
            kind=kind_of(call, "random numbers for the symbols"),
            hint="it is the alpha of the other balances",
        )


def exact(t, theta0, omega0, *, length, gravity):
    """The motion in Jacobi's elliptic functions; with t = 0 at the start. A turning pendulum has modulus above one."""
    if gravity == 0:
        return np.column_stack([theta0 + omega0 * t, np.full(len(t), omega0)])
    k, around = math.sqrt(gravity / length), 2 * math.pi * round(theta0 / (2 * math.pi))
    half = (theta0 - around) / 2
    m = math.sin(half) ** 2 + (omega0 / (2 * k)) ** 2
    if m < 1:
        start = ellipkinc(math.atan2(math.sin(half), omega0 / (2 * k)), m)
        sn, cn, _, _ = ellipj(start + k * t, m)
        return np.column_stack([around + 2 * np.arcsin(math.sqrt(m) * sn), 2 * k * math.sqrt(m) * cn])
    spin = math.copysign(k * math.sqrt(m), omega0)
    _, _, dn, phase = ellipj(ellipkinc(half, 1 / m) + spin * t, 1 / m)
    return np.column_stack([around + 2 * phase, 2 * spin * dn])


def swing(draw):
    """A start that swings back and forth far from small angles, and its pendulum."""
    pendulum = parameters(draw)
    k = math.sqrt(pendulum["gravity"] / pendulum["length"])
    start = draw.uniform(1.2, 2.2) * draw.choice([-1, 1]), draw.uniform(0.2, 0.6) * k * draw.choice([-1, 1])
    return start, pendulum, k


def turning(draw):
    """A start that goes over the top, from an angle of more than a turn, and its pendulum."""
    pendulum = parameters(draw)
    k = math.sqrt(pendulum["gravity"] / pendulum["length"])
    sign = draw.choice([-1, 1])
    return (-sign * draw.uniform(6, 9), sign * draw.uniform(2.3, 3) * k), pendulum, k


def quick(draw):
    """As `swing`, at 20 to 30 rad/s: steps of a millisecond follow it, those of ten do not."""
    (angle, rate), pendulum, k = swing(draw)
    faster = draw.uniform(20, 30)
    short = {**pendulum, "length": draw.uniform(0.01, 0.03)}
    return (angle, rate * faster / k), {**short, "gravity": faster**2 * short["length"]}, faster


def variations(s):
    """Smooth functions of 0 <= s <= 1 that vanish at both ends."""
    return [np.sin(np.pi * s), np.sin(2 * np.pi * s) * np.exp(-s), s * (1 - s) * (2 + np.cos(5 * s))]


def wave(s, start, end, height):
    """A path that is no motion of a pendulum, over 0 <= s <= 1, with its first and second derivatives."""
    turn = 2 * np.pi
    return (
        start + (end - start) * s + height * np.sin(turn * s),
        end - start + turn * height * np.cos(turn * s),
        -(turn**2) * height * np.sin(turn * s),
    )


def lagrangian_along(theta, omega, *, mass, length, gravity, kinetic=1, potential=-1, height=lambda th: 1 - np.cos(th)):
    return mass * length * (kinetic * length * omega**2 / 2 + potential * gravity * height(theta))


def by_midpoints(**wrong):
    """The action of a wrong Lagrangian."""

    def action(theta, step, **pendulum):
        middle = (theta[:-1] + theta[1:]) / 2
        return step * np.sum(lagrangian_along(middle, np.diff(theta) / step, **pendulum, **wrong))

    return action


def by_ends(ends):
    """The action as a sum over these of the ends of the steps."""

    def action(theta, step, **pendulum):
        return step * np.sum(lagrangian_along(theta[ends], np.diff(theta) / step, **pendulum))

    return action


def by_all_samples(theta, step, **pendulum):
    """The action as the sum over all samples, both ends counted whole."""
    return step * np.sum(lagrangian_along(theta, np.gradient(theta, step), **pendulum))


# Compared loosely: another quadrature than this is as good.
STATIONARY_SUSPECTS = [
    suspect(says, within=1e-3, action=by_midpoints(**wrong))
    for says, wrong in {
        "the integral of T + V": {"potential": 1},
        "the integral of V - T": {"kinetic": -1, "potential": 1},
        "the integral of T alone": {"potential": 0},
        "the potential energy of small angles": {"height": lambda th: th**2 / 2},
        "sin theta in the potential energy": {"height": np.sin},
        "the kinetic energy without its half": {"kinetic": 2},
        DEGREES: {"height": lambda th: 1 - np.cos(np.radians(th))},
    }.items()
]
STATIONARY_SUSPECTS.append(
    suspect(
        "a sum over all samples, its first and last counted whole, where a trapezoid counts half of each",
        action=by_all_samples,
    )
)
STATIONARY_SUSPECTS += [
    suspect(
        f"a sum that leaves the {which} step out",
        within=5e-5,  # a step is 5e-4 of these paths, and one quadrature is off another by 1e-6
        action=lambda theta, step, rest=rest, **pendulum: by_midpoints()(theta[rest], step, **pendulum),
    )
    for which, rest in {"last": slice(None, -1), "first": slice(1, None)}.items()
]
INTEGRAL_SUSPECTS = [
    suspect(
        "a sum over the first ends of the steps, with an error of the order of the step",
        action=by_ends(slice(None, -1)),
    ),
    suspect(
        "a sum over the last ends of the steps, with an error of the order of the step", action=by_ends(slice(1, None))
    ),
    suspect(
        "a potential energy that is zero at the hinge", within=1e-4, action=by_midpoints(height=lambda th: -np.cos(th))
    ),
]


SMALL = 1e-3  # of a variation; its square is below VARIATION


@once
def varied_paths(draw):
    """Calls with a path varied to both sides, the right first variation in parts of its scale, and the kind of path."""
    cases = []
    for kind in ("a true motion, swinging", "a true motion, turning", "a path that is no motion"):
        (theta0, omega0), pendulum, k = (turning if "turning" in kind else swing)(draw)
        t = np.linspace(0, 2 * np.pi * draw.uniform(1.2, 1.5) / k, 2001)
        length, gravity = pendulum["length"], pendulum["gravity"]
        path, surplus = exact(t, theta0, omega0, length=length, gravity=gravity)[:, 0], np.zeros(len(t))
        if "no motion" in kind:
            path, _, bend = wave(t / t[-1], theta0, theta0 + draw.uniform(1, 2), draw.uniform(0.3, 0.6))
            surplus = bend / t[-1] ** 2 + gravity / length * np.sin(path)
        scale = pendulum["mass"] * length * gravity * t[-1]
        for change in variations(t / t[-1]):
            both = [given(path + sign * SMALL * change, t[1], **pendulum).on(kind) for sign in (1, -1)]
            variation = -pendulum["mass"] * length**2 * np.sum(surplus * change) * t[1]
            cases.append((both, variation / scale, scale, kind))
    return cases


@check(points=0.5, part="a", suspects=STATIONARY_SUSPECTS)
def action_is_stationary_on_motions(student, draw):
    """action: its first variation vanishes on true motions, and on other paths it does not."""
    cases = varied_paths(draw)
    values = iter(student.action.many([call for both, *_ in cases for call in both]))
    for both, variation, scale, kind in cases:
        found = (next(values) - next(values)) / (2 * SMALL * scale)
        expect(
            found,
            variation,
            within=VARIATION,
            of="the first variation",
            unit="of m g l times the duration",
            kind=kind,
            at=both[0],
            hint=partial(variation_hint, found, variation),
        )


def variation_hint(found, variation):
    """What to say of a first variation: whether it is nearly right, as that of a quadrature of first order."""
    if abs(found - variation) <= NEARLY:
        return "it is nearly right: is the quadrature of second order, are both ends counted as it asks?"
    return "is it the integral of T - V, with omega = dtheta/dt from the samples?"


@once
def paths(draw):
    """Calls with paths between different heights, the action by Gauss's quadrature, and its scale."""
    nodes, weights = np.polynomial.legendre.leggauss(80)
    fine, cases = np.linspace(0, 1, 4001), []
    for share, kind in ((1, "a smooth path"), (1, "a smooth path"), (0, "a smooth path without gravity")):
        pendulum = parameters(draw)
        span = draw.uniform(3, 4) * math.sqrt(pendulum["length"] / pendulum["gravity"])
        pendulum["gravity"] *= share
        shape = draw.uniform(-0.3, 0.3), draw.uniform(2.6, 3.4) * draw.choice([-1, 1]), draw.uniform(0.3, 0.6)
        theta, slope, _ = wave((nodes + 1) / 2, *shape)
        kinetic = pendulum["mass"] * (pendulum["length"] * slope / span) ** 2 / 2
        potential = pendulum["mass"] * pendulum["gravity"] * pendulum["length"] * (1 - np.cos(theta))
        call = given(wave(fine, *shape)[0], span * fine[1], **pendulum)
        action, scale = (weights @ (kinetic + sign * potential) * span / 2 for sign in (-1, 1))
        cases.append((call, action, scale, kind))
    return cases + plain_paths(draw)


def plain_paths(draw):
    """As `paths`: at rest anywhere and at the named angles; turning evenly without gravity; two samples and more."""
    cases = []
    for theta in (draw.uniform(0.3, 2.8), *PLAIN):
        pendulum, samples, step = (parameters(draw), 2 * int(draw.integers(200, 300)), 10 ** draw.uniform(-3, -1))
        depth = pendulum["mass"] * pendulum["gravity"] * pendulum["length"] * (1 - math.cos(theta))
        action = -depth * step * (samples - 1)
        call = given(np.full(samples, theta), step, **pendulum)
        cases.append((call, action, abs(action) or 1.0, kind_of(given(theta, 0.0, gravity=1.0), "")))
    # chords for arcs are second order too: off by (omega step)^2/12, a tenth of the limit
    pendulum, omega, step = parameters(draw, gravity=0.0), draw.uniform(-3, -1), 1e-3
    for samples, few in ((5000, ""), (2, ", two samples"), (3, ", three samples")):
        action = pendulum["mass"] * (pendulum["length"] * omega) ** 2 / 2 * step * (samples - 1)
        call = given(omega * step * np.arange(samples), step, **pendulum)
        cases.append((call, action, action, f"a pendulum that turns evenly, without gravity{few}"))
    return cases


@check(points=0.5, part="a", after=action_is_stationary_on_motions, suspects=INTEGRAL_SUSPECTS)
def action_is_the_integral(student, draw):
    """action: the integral of T - V itself, to second order in the step."""
    cases = paths(draw)
    values = student.action.many([call.on(kind) for call, *_, kind in cases])
    for value, (call, expected, scale, kind) in zip(values, cases, strict=True):
        expect(
            value,
            expected,
            scale=scale,
            within=ACTION,
            of="the action",
            unit="of the integral of T + V",
            kind=kind,
            at=call,
            hint="halve the step: the error must fall to a quarter",
        )


def harmonic(t, theta0, omega0, frequency):
    """The linear oscillation by a complex exponential."""
    z = (theta0 - 1j * omega0 / frequency) * np.exp(1j * frequency * t)
    return np.column_stack([z.real, -frequency * z.imag])


def small_angle_suspect(says, motion):
    """`motion(t, state, ratio)`, where the right one is harmonic with the square root of ratio = g/l."""

    def small_angle_solution(t, *state, length, gravity):
        return motion(t, state, gravity / length)

    return suspect(says, small_angle_solution=small_angle_solution)


SMALL_ANGLE_SUSPECTS = [
    small_angle_suspect("g/l for its square root", lambda t, state, ratio: harmonic(t, *state, ratio)),
    small_angle_suspect("l/g for g/l", lambda t, state, ratio: harmonic(t, *state, ratio**-0.5)),
    small_angle_suspect(
        "the state at t[0] for that at t = 0", lambda t, state, ratio: harmonic(t - t[0], *state, ratio**0.5)
    ),
    small_angle_suspect(
        "velocities that lack a factor, the frequency, in the part of the given angle",
        lambda t, state, ratio: np.column_stack(
            [
                harmonic(t, *state, ratio**0.5)[:, 0],
                state[1] * np.cos(ratio**0.5 * t) - state[0] * np.sin(ratio**0.5 * t),
            ]
        ),
    ),
    small_angle_suspect(
        "the full equation for the linear one", lambda t, state, ratio: exact(t, *state, length=1, gravity=ratio)
    ),
]


@check(points=0.5, part="a", suspects=SMALL_ANGLE_SUSPECTS)
def small_angle_solution_is_harmonic(student, draw):
    """small_angle_solution: theta and omega of theta'' + (g/l) theta = 0, the given state being that at t = 0."""
    (theta0, omega0), pendulum, k = swing(draw)
    pendulum.pop("mass")
    t = uneven(draw, 20 / k, 50)
    starts = {
        "times that do not start at zero": (t, theta0, omega0),
        "two times, the first of them zero": (t[:2] - t[0], theta0, omega0),
        "a pendulum let go at rest": (t, theta0, 0.0),
        "a pendulum that starts at the bottom": (t, 0.0, omega0),
        "a pendulum at rest at the bottom": (t, 0.0, 0.0),
        "a pendulum that starts level with the hinge": (t, math.copysign(math.pi / 2, theta0), omega0),
        **{kind: (t[some], theta0, omega0) for kind, some in SOME_TIMES.items()},
    }
    calls = [given(*start, **pendulum).on(kind) for kind, start in starts.items()]
    for name in pendulum:
        other = {**pendulum, name: 1.4 * pendulum[name]}
        calls.append(given(t, theta0, omega0, **other).on(f"a pendulum like one before but for its {name}"))
    for found, call in zip(student.small_angle_solution.many(calls), calls, strict=True):
        k = math.sqrt(call.kwargs["gravity"] / call.kwargs["length"])
        hint = (
            "is anything kept between calls?"
            if "one before" in call.kind
            else "put t = 0 in: is the state the given one? differentiate theta: is it omega?"
        )
        expect(
            found,
            harmonic(*call.args, k),
            scale=[1, k],
            within=TRAJECTORY,
            of="theta, or omega/sqrt(g/l),",
            unit="rad",
            t=call.args[0],
            kind=call.kind,
            at=call,
            hint=hint,
        )


@check(points=0.25, part="a", after=small_angle_solution_is_harmonic)
def small_angle_solution_without_gravity(student, draw):
    """small_angle_solution: without gravity the pendulum turns uniformly."""
    theta0, omega0, length = draw.uniform(0.5, 1), draw.uniform(-2, -1), draw.uniform(1, 3)
    t = uneven(draw, 5.0, 20)
    starts = {"": (theta0, omega0), ", let go at rest": (theta0, 0.0), ", from the bottom": (0.0, omega0)}
    calls = [given(t, *start, length=length, gravity=0.0).on(f"gravity 0{kind}") for kind, start in starts.items()]
    for found, call in zip(student.small_angle_solution.many(calls), calls, strict=True):
        angle, rate = call.args[1:]
        uniform = np.column_stack([angle + rate * t, np.full(len(t), rate)])
        expect(
            found,
            uniform,
            within=TRAJECTORY,
            of="theta or omega",
            unit="rad or rad/s",
            t=t,
            kind=call.kind,
            at=call,
            hint="what becomes of sin(k t)/k as k goes to zero?",
        )


def period_suspect(says, swings):
    """`swings`: the wrong period in units of sqrt(length/gravity)."""
    return suspect(says, period=lambda A, *, length, gravity: swings(A) * math.sqrt(length / gravity))


PERIOD_SUSPECTS = [
    period_suspect("the period of small angles", lambda A: 2 * math.pi),
    period_suspect("the first two terms of the series", lambda A: 2 * math.pi * (1 + A**2 / 16)),
    period_suspect("the modulus k for the parameter m = k^2", lambda A: 4 * ellipk(math.sin(A / 2))),
    period_suspect("the amplitude where half the amplitude belongs", lambda A: 4 * ellipk(math.sin(A) ** 2)),
    period_suspect("half the period", lambda A: 2 * ellipk(math.sin(A / 2) ** 2)),
    period_suspect("a quarter of the period", lambda A: ellipk(math.sin(A / 2) ** 2)),
    period_suspect("the amplitude taken for degrees", lambda A: 4 * ellipk(math.sin(math.radians(A) / 2) ** 2)),
    suspect(
        "g/l for l/g", period=lambda A, length, gravity: 4 * ellipk(math.sin(A / 2) ** 2) * math.sqrt(gravity / length)
    ),
]


def judge_periods(student, draw, amplitudes, within, kind, hint):
    """Compare with Legendre's complete integral of the first kind."""
    rods = [{"length": 10 ** draw.uniform(-1, 1), "gravity": draw.uniform(1, 25)} for _ in amplitudes]
    rods[-1] = {"length": 1.0, "gravity": 1.0}
    calls = [given(amplitude, **rod).on(kind) for amplitude, rod in zip(amplitudes, rods, strict=True)]
    for found, call in zip(student.period.many(calls), calls, strict=True):
        unit = math.sqrt(call.kwargs["length"] / call.kwargs["gravity"])
        expected = 4 * ellipkm1(math.cos(call.args[0] / 2) ** 2) * unit  # next to pi ellipk has lost digits
        expect(
            found,
            expected,
            scale=expected,
            within=within,
            of="the period",
            unit="of itself",
            kind=kind,
            hint=partial(period_hint, found / unit, expected / unit, hint),
            at=call,
        )


def period_hint(found, expected, hint):
    """What to say of a period, in units of sqrt(l/g), that is that of small angles, or nearly right."""
    if expected - 2 * math.pi < 1e-2 and abs(found - 2 * math.pi) <= POINTWISE:
        return "it is the period of small angles, for which no amplitude is small enough"
    if abs(found - expected) <= NEARLY * expected:
        return f"it is nearly right: is it a series cut short, or a quadrature of few points? {hint}"
    return hint


@check(points=0.75, part="a", suspects=PERIOD_SUSPECTS)
def period_is_exact(student, draw):
    """period: exact at large amplitudes."""
    amplitudes = [*draw.uniform(0.5, 2, 8), math.pi / 2, math.pi / 2, 1.0]
    judge_periods(
        student,
        draw,
        amplitudes,
        PERIOD,
        "an amplitude between 0.5 and 2 rad",
        "the energy gives omega at every theta, and dt = dtheta/omega",
    )


@check(points=0.25, part="a", after=period_is_exact)
def period_grows_towards_the_top(student, draw):
    """period: exact for small and tiny amplitudes, and on to pi, where it grows without bound."""
    # below .0099 the period of small angles, 1 - A^2/16 of the right one, is still off by 3e-6
    amplitudes = [draw.uniform(0.007, 0.0099), *10 ** draw.uniform(-2, -1, 2)]
    judge_periods(
        student,
        draw,
        amplitudes,
        PERIOD,
        "an amplitude between 0.007 and 0.1 rad",
        "is a difference of nearly equal cosines taken?",
    )
    judge_periods(
        student,
        draw,
        np.pi - 10 ** draw.uniform(-3, -1, 4),
        PERIOD_NEXT_TO_TOP,
        "an amplitude next to pi",
        "a series in the amplitude, or a quadrature of fixed order, does not reach this far",
    )
    judge_periods(
        student,
        draw,
        one_in_each(draw, SMALLER),
        PERIOD,
        "an amplitude between 0.1 and 0.5 rad",
        "a series of few terms does not reach this far",
    )
    judge_periods(
        student,
        draw,
        one_in_each(draw, LARGER),
        PERIOD,
        "an amplitude between 2 and 3 rad",
        "a series in the amplitude, or a quadrature of fixed order, does not reach this far",
    )
    judge_periods(
        student,
        draw,
        10 ** draw.uniform(-5, -4, 3),
        PERIOD_AT_THE_ENDS,
        "a tiny amplitude",
        "is a difference of nearly equal cosines taken? cos a - cos b is a product of sines",
    )
    judge_periods(
        student,
        draw,
        np.pi - 10 ** draw.uniform(-5, -4, 2),
        PERIOD_AT_THE_ENDS,
        "an amplitude very close to pi",
        "is a difference of nearly equal numbers taken?",
    )


# With the others they leave no gap: a formula for some range is tried in it. The series' second term is off by 6e-6
# from 0.2 rad on, its third by 1e-6 from 0.41.
SMALLER, LARGER = (0.1, 0.2, 0.3, 0.45, 0.5), (2.0, 2.2, 2.4, 2.6, 2.8, 3.04)


def one_in_each(draw, edges):
    """A random number between each of the edges and the next."""
    return draw.uniform(edges[:-1], edges[1:])


def motion_suspect(says, motion):
    """`motion(t, since, state, rod)`, where since = t - t[0] and the right one is exact(since, *state, **rod)."""
    return suspect(says, within=1e-4, simulate=lambda t, *state, **rod: motion(t, t - t[0], np.array(state), rod))


def tilted(angle):
    """The motion with the weight turned by an angle, which is the right one in an angle counted from there."""
    shift = np.array([angle, 0.0])
    return lambda t, since, state, rod: exact(since, *(state + shift), **rod) - shift


def loosely(t, theta0, omega0, *, length, gravity):
    """solve_ivp as it is when nothing is said of its tolerances."""
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return state[1], -gravity / length * math.sin(state[0])

    return solve_ivp(rates, (t[0], t[-1]), [theta0, omega0], t_eval=t).y.T


def with_angles_in_degrees(t, since, state, rod):
    slower = {**rod, "gravity": math.radians(rod["gravity"])}  # the rate of an angle in radians has this factor
    return np.degrees(exact(since, *np.radians(state), **slower))


SIMULATE_SUSPECTS = [
    motion_suspect("cos theta where sin theta belongs", tilted(math.pi / 2)),
    motion_suspect("the sign of gravity's term missing", tilted(math.pi)),
    motion_suspect(
        "the linearised equation, theta for sin theta",
        lambda t, since, state, rod: harmonic(since, *state, math.sqrt(rod["gravity"] / rod["length"])),
    ),
    *mistimed(lambda t, *state, **rod: exact(t - t[0], *state, **rod), from_zero=exact),
    motion_suspect(DEGREES, with_angles_in_degrees),
    # within little: its steps are the same, whoever takes them
    suspect("the tolerances that solve_ivp has when none are given", simulate=loosely),
]


RATES = "is omega the rate of theta, and alpha that of the balances? is the tolerance tight?"
SEEN = 1e-4  # as loosely as suspects
LOOSE = {1e-3: 0.5}  # the limit of a tolerance too loose, and its share of the points
COARSE = 1e-2  # of the motion; below it a right equation is solved coarsely, to choose the words


def near_miss(t, states, expected, from_zero, hint):
    """What to say of a motion that is right but for whole turns, rows a step early, a start at t = 0, or its steps."""
    turns = np.rint((states - expected) / [2 * math.pi, np.inf])
    if turns.any() and np.abs(states - expected - 2 * math.pi * turns).max() <= SEEN:
        return "it is off by whole turns alone, as if theta were wrapped; it is never wrapped"
    if len(states) > 2 and np.abs(states[:-1] - expected[1:]).max() <= SEEN * np.ptp(expected, axis=0).max():
        return "row i is the state at t[i + 1]: row 0 must be the start"
    late = t > max(t[0], 0.0)
    if late.any() and np.abs(states - from_zero)[late].max() <= SEEN * np.ptp(expected, axis=0).max():
        return "the given state is that at t[0], not at t = 0: integrate from t[0] on"
    if hint == RATES and np.abs(states - expected).max() <= COARSE * np.ptp(expected, axis=0).max():
        return "it is nearly right: are the steps short, and the tolerances of the integrator tight enough?"
    return hint


def judge_motion(student, t, start, pendulum, kind, hint, within=TRAJECTORY, loose=LOOSE):
    """Compare a simulation with elliptic functions; half the points for a tolerance too loose."""
    rod = {name: pendulum[name] for name in ("length", "gravity")}
    scale = [1.0, max(abs(start[1]), math.sqrt(rod["gravity"] / rod["length"]))]
    found, expected = student.on(kind).simulate(t, *start, **rod), exact(t - t[0], *start, **rod)
    expect(
        found,
        expected,
        scale=scale,
        within=within,
        of="theta, or omega in its scale,",
        unit="rad",
        t=t,
        kind=kind,
        at=(start, pendulum),
        hint=lambda: near_miss(t, found, expected, exact(t, *start, **rod), hint),
        partial=loose,
        keeps=lambda: kept(t, energy_along(found, rod), within=ENERGY, of="the energy", unit="of itself"),
    )


def energy_along(states, rod):
    """The energy along a motion, zero at the lowest point, over its first value."""
    theta, omega = states.T
    energies = omega**2 / 2 + 2 * rod["gravity"] / rod["length"] * np.sin(theta / 2) ** 2
    return energies / energies[0]


@check(points=0.75, part="a", suspects=SIMULATE_SUSPECTS)
def simulate_swings(student, draw):
    """simulate: large swings, row i at t[i], row 0 the given state."""
    start, pendulum, k = swing(draw)
    judge_motion(student, uneven(draw, 15 / k, 1000), start, pendulum, "a large swing, t[0] not 0", RATES)


@check(points=0.25, part="a", after=simulate_swings)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for, however far apart, whatever was asked before."""
    start, pendulum, k = swing(draw)
    judge_motion(
        student,
        uneven(draw, 15 / k, 4),
        start,
        pendulum,
        "few times, far apart",
        "the steps of the integration are not those of t",
    )
    for (angle, rate), kind in plain_starts(start):
        t = uneven(draw, 5 / k, 2)
        judge_motion(student, t, (angle, rate), pendulum, f"two times, {kind}", "row 0 is the start")
    judge_equilibria(student, uneven(draw, 5 / k, 2), [0.0], pendulum)
    start, pendulum, k = quick(draw)
    judge_motion(
        student,
        uneven(draw, 8 / k, 3),
        start,
        pendulum,
        "three times, a rod of few centimetres",
        "a step of fixed length does not do for every pendulum",
    )
    start, pendulum, k = swing(draw)
    judge_motion(
        student,
        uneven(draw, 100 / k, 2),
        start,
        pendulum,
        "two times, many periods apart",
        "a fixed number of steps from each time to the next does not do",
        FAR,
    )
    # after six periods the linear motion is 40 A^3/16 behind, 3e-4 and more
    start = draw.uniform(0.05, 0.09) * draw.choice([-1, 1]), draw.uniform(0.02, 0.09) * draw.choice([-1, 1])
    judge_motion(
        student,
        uneven(draw, 40 / k, 2),
        start,
        pendulum,
        "a small swing, two times many periods apart",
        "no swing is so small that sin theta is theta: the difference adds up",
        loose={},
    )
    judge_alike(student, draw)


def judge_alike(student, draw):
    """Motions that are like the first of them but for one argument; what is kept of that must not be taken for them."""
    (angle, rate), pendulum, k = swing(draw)
    rod, t = {name: pendulum[name] for name in ("length", "gravity")}, uneven(draw, 5 / k, 3)
    calls = {
        "a large swing": given(t, angle, rate, **rod),
        "its times": given(uneven(draw, 5 / k, 3), angle, rate, **rod),
        "its angle": given(t, 0.8 * angle, rate, **rod),
        "its speed": given(t, angle, -rate, **rod),
        "its length": given(t, angle, rate, **{**rod, "length": 1.5 * rod["length"]}),
        "its gravity": given(t, angle, rate, **{**rod, "gravity": 0.6 * rod["gravity"]}),
    }
    calls = [
        call.on(f"a swing like the one before but for {what}" if what.startswith("its") else what)
        for what, call in calls.items()
    ]
    for states, call in zip(student.simulate.many(calls), calls, strict=True):
        (t, *start), rod = call.args, call.kwargs
        expect(
            states,
            exact(t - t[0], *start, **rod),
            scale=[1.0, k],
            within=TRAJECTORY,
            t=t,
            kind=call.kind,
            at=call,
            of="theta, or omega/sqrt(g/l),",
            unit="rad",
            hint="is anything kept between calls?",
        )


def plain_starts(start):
    """Starts with an angle that has a name, or none of the speed, and what to call each."""
    angle, rate = start
    return (
        ((angle, 0.0), "let go at rest"),
        ((-angle, 0.0), "let go at rest"),
        ((0.0, rate), "from the bottom"),
        ((0.0, -rate), "from the bottom"),
        ((math.pi / 2, 0.0), "let go level with the hinge"),
    )


def judge_equilibria(student, t, angles, pendulum):
    """At rest at these angles the pendulum stays."""
    rod = {name: pendulum[name] for name in ("length", "gravity")}
    calls = [given(t, angle, 0.0, **rod) for angle in angles]
    calls = [call.on(kind_of(given(*call.args[1:], **call.kwargs), "")) for call in calls]
    for found, call in zip(student.simulate.many(calls), calls, strict=True):
        expect(
            found,
            [[call.args[1], 0.0]] * len(t),
            within=TRAJECTORY,
            of="theta or omega",
            unit="rad or rad/s",
            t=t,
            kind=call.kind,
            at=call,
            hint="what is alpha there?",
        )


@check(points=0.25, part="a", after=simulate_swings)
def simulate_turns_over_the_top(student, draw):
    """simulate: a pendulum that turns round and round; theta goes on growing."""
    start, pendulum, k = turning(draw)
    judge_motion(
        student,
        uneven(draw, 15 / k, 100),
        start,
        pendulum,
        "a pendulum that goes over the top",
        "is alpha right at every angle, and the tolerance tight?",
    )
    judge_equilibria(student, uneven(draw, 5 / k, 2), [math.pi, -math.pi], pendulum)


@check(points=0.25, part="a", after=simulate_swings)
def simulate_without_gravity(student, draw):
    """simulate: without gravity it turns uniformly."""
    start, pendulum = (draw.uniform(0.5, 1), draw.uniform(-0.4, -0.3)), parameters(draw, gravity=0.0)
    t = uneven(draw, 8.0, 30)
    judge_motion(student, t, start, pendulum, "gravity 0", "is anything divided by gravity?")
    judge_equilibria(student, t[:2], [0.0, 1.0, -1.0], pendulum)


@check(points=0.25, part="a", after=simulate_swings)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many periods."""
    start, pendulum, k = swing(draw)
    t = uneven(draw, 180 / k, 300)
    rod = {name: pendulum[name] for name in ("length", "gravity")}
    states = student.on("many periods").simulate(t, *start, **rod)
    # from 1.2 rad and more on one side it swings as far to the other
    expect_that(np.ptp(states[:, 0]) > 1.2, "the pendulum does not move", kind="many periods")
    energy = energy_along(states, rod)
    expect(
        energy,
        np.ones(len(t)),
        within=ENERGY,
        of="the energy",
        unit="of itself",
        t=t,
        kind="many periods",
        at=(start, pendulum),
        hint="a step of fixed length, or a fixed number of them, does not do for every duration",
        partial={1e-4: 0.6, 1e-2: 0.3},
    )
