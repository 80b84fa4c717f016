"""Hidden checks of hw12. What is right comes from curvature and arc length of the wire, and from elliptic integrals."""

import math

import numpy as np
from scipy.special import ellipe, ellipeinc, ellipk

from tam570_grader import (
    Failed,
    array,
    check,
    expect,
    expect_that,
    formula,
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
    "lagrangian": formula("x", "v", "m", "c", "g"),
    "lagrange_equation": formula("x", "v", "c", "g"),
    "acceleration_newton": number,
    "constraint_force": array(2),
    "energy": number,
    "simulate": rows(2),
    "period": number,
}
NEEDS = ("numpy", "sympy")
OFF_LIMITS = {"*": ("tam570.lagrange",)}

POINTWISE = 1e-8  # a few roundings make 1e-15, a derivative by central differences 1e-10
NEXT_TO_BOTTOM = 1e-5  # times 1/c; a term of x'' is left out there by who takes it for nothing
# of x'' next to the bottom; differences of energies are good to 5e-6 of what is nearly zero
FEW_DIGITS = 1e-4
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 is off by 1e-6 after three periods, RK45 and DOP853 by less
SHARP_TURN = 2e-4  # ... by 1e-5 behind the sharp turns of a steep wire
ENERGY = 7e-5  # BDF at the same tolerances loses 7e-6 of it in thirty periods, the others 1e-6
NEARLY = 3e-2  # of the largest rate; the rows of a coarse integration obey the equation so far, to choose the words
# no more are straight lines between the steps of a tight integration off by, to choose the words
JOINABLE = 3e-2
BETTER = 0.1  # of the error is left where the steps are what is wrong, to choose the words
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, is good to 1e-8
TINY = 5e-4  # at micrometres an event of a simulation with an absolute tolerance of 1e-9 m is good to 5e-5


def acceleration(x, v, *, curvature, gravity):
    """x'' from the acceleration along the wire, which is that of gravity, and the turning of the tangent."""
    angle = math.atan(2 * curvature * x)  # of the wire
    speed = v / math.cos(angle)
    turning = 2 * curvature * math.cos(angle) ** 3 * speed  # rate of the angle: bend of the wire times speed
    return -gravity * math.sin(angle) * math.cos(angle) - speed * math.sin(angle) * turning


def normal_force(x, v, *, mass, curvature, gravity):
    """Size of the force of the wire: mass times speed^2 over the radius of curvature, and the weight's share."""
    angle = math.atan(2 * curvature * x)
    bend = 2 * curvature * math.cos(angle) ** 3
    return mass * (bend * (v / math.cos(angle)) ** 2 + gravity * math.cos(angle))


def energies(x, v, *, mass, curvature, gravity):
    """Kinetic and potential energy, from the velocity as a vector."""
    velocity = np.array([v, 2 * curvature * x * v])
    return mass * velocity @ velocity / 2, mass * gravity * curvature * x**2


def bead_of(point):
    """The state and the wire for which the symbols stand."""
    return (point["x"], point["v"]), {"curvature": point["c"], "gravity": point["g"]}


def integrated(newton, method, **tolerances):
    """A simulation with this acceleration."""

    def simulate(t, x, v, **wire):
        from scipy.integrate import solve_ivp

        found = solve_ivp(lambda _, y: (y[1], newton(*y, **wire)), (t[0], t[-1]), (x, v), method, t, **tolerances)
        return found.y.T if found.success else np.full((len(t), 2), np.nan)

    return simulate


def equation_suspect(says, wrong):
    """An acceleration wrong(slope, c, v, g) in place of the right one."""

    def newton(x, v, *, curvature, gravity):
        return wrong(2 * curvature * x, curvature, v, gravity)

    def lagrange(points):
        return [newton(*state, **wire) for state, wire in map(bead_of, points)]

    simulate = integrated(newton, "DOP853", rtol=1e-9, atol=1e-9)
    return suspect(says, within=1e-5, acceleration_newton=newton, lagrange_equation=lagrange, simulate=simulate)


EQUATION_SUSPECTS = [
    equation_suspect("the kinetic energy of a flat wire, v for the speed", lambda s, c, v, g: -g * s),
    equation_suspect("the term 4 c^2 x v^2 missing", lambda s, c, v, g: -g * s / (1 + s**2)),
    equation_suspect(
        "the sign of the term 4 c^2 x v^2 reversed", lambda s, c, v, g: -s * (g - 2 * c * v**2) / (1 + s**2)
    ),
    equation_suspect(
        "the term 4 c^2 x v^2 with v along the wire, where it is the rate of x",
        lambda s, c, v, g: -s * (g + 2 * c * v**2 / (1 + s**2)) / (1 + s**2),
    ),
    equation_suspect(
        "gravity's share along the wire, the rate of the speed there, taken for x''",
        lambda s, c, v, g: -g * s / math.hypot(1, s),
    ),
    equation_suspect("twice the term 4 c^2 x v^2, no dT/dx", lambda s, c, v, g: -s * (g + 4 * c * v**2) / (1 + s**2)),
    equation_suspect("the slope 2 c x not squared", lambda s, c, v, g: -(g * s + c * v**2) / (1 + s)),
    equation_suspect("c x for the slope 2 c x", lambda s, c, v, g: -s * (g + c * v**2 / 2) / (1 + s**2 / 4)),
    equation_suspect("the sign of gravity's term reversed", lambda s, c, v, g: -s * (2 * c * v**2 - g) / (1 + s**2)),
    equation_suspect("the curvature missing beside v^2", lambda s, c, v, g: -s * (g + 2 * v**2) / (1 + s**2)),
    equation_suspect("the slope without its sign", lambda s, c, v, g: -abs(s) * (g + 2 * c * v**2) / (1 + s**2)),
]


def energy_suspect(says, kinetic, potential):
    """Energies kinetic(slope) m v^2/2 and potential(slope) m g c x^2 in place of the right ones."""

    def both(x, v, *, mass, curvature, gravity):
        s = 2 * curvature * x
        return kinetic(s) * mass * v**2 / 2, potential(s) * mass * gravity * curvature * x**2

    def lagrangian(points):
        found = [both(*state, mass=point["m"], **wire) for point in points for state, wire in [bead_of(point)]]
        return [kinetic - potential for kinetic, potential in found]

    return suspect(says, energy=lambda x, v, **bead: sum(both(x, v, **bead)), lagrangian=lagrangian)


ENERGY_SUSPECTS = [
    energy_suspect("the kinetic energy of a flat wire, v for the speed", lambda s: 1, lambda s: 1),
    energy_suspect("the slope 2 c x not squared", lambda s: 1 + s, lambda s: 1),
    energy_suspect("c x for the slope 2 c x", lambda s: 1 + s**2 / 4, lambda s: 1),
    energy_suspect("2 c^2 x^2 for the square of the slope, 4 c^2 x^2", lambda s: 1 + s**2 / 2, lambda s: 1),
    energy_suspect("the sign of the potential energy reversed", lambda s: 1 + s**2, lambda s: -1),
]


def beads(draw):
    """Calls at random states on flat and on steep places, some without gravity."""
    calls = []
    for weight in [1] * 15 + [0] * 3:
        curvature, gravity = 10 ** draw.uniform(-1, 1), draw.uniform(1, 25)
        x = 10 ** draw.uniform(-2, 0.6) / curvature * draw.choice([-1, 1])
        v = draw.uniform(0.4, 2) * math.sqrt(gravity / curvature) * draw.choice([-1, 1])
        calls.append(given(x, v, mass=10 ** draw.uniform(-1, 1), curvature=curvature, gravity=gravity * weight))
    return calls + plain_beads(calls[0])


def plain_beads(call):
    """Calls with this x or v, the other zero or x small, or both zero, and with whole numbers; without gravity too."""
    x, v = call.args
    small = NEXT_TO_BOTTOM / call.kwargs["curvature"]
    states = [(0.0, abs(v)), (0.0, -abs(v)), (abs(x), 0.0), (-abs(x), 0.0), (0.0, 0.0), (small, v), (-small, v)]
    whole = {"mass": 1.0, "curvature": 1.0, "gravity": 1.0}
    return [
        *(given(*state, **{**call.kwargs, "gravity": g}) for state in states for g in (call.kwargs["gravity"], 0.0)),
        *(given(*state, **whole) for state in ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0))),
    ]


def massless(calls):
    """The same calls without the mass."""
    return [given(*call.args, curvature=call.kwargs["curvature"], gravity=call.kwargs["gravity"]) for call in calls]


def points_of(calls):
    """The symbols' values for the arguments of calls."""
    names = {"mass": "m", "curvature": "c", "gravity": "g"}
    states = [dict(zip("xv", call.args, strict=True)) for call in calls]
    wires = [{names[key]: value for key, value in call.kwargs.items()} for call in calls]
    return [{**state, **wire} for state, wire in zip(states, wires, strict=True)]


def kind_of(call, kind):
    x, v = call.args
    where = ("a bead" if v else "a bead at rest") + ("" if x else " at the bottom") if not x or not v else kind
    if next_to_bottom(call):
        where = "a bead next to the bottom"
    return where if call.kwargs["gravity"] else f"{where}, without gravity"


def next_to_bottom(call):
    return 0 < abs(call.args[0]) * call.kwargs["curvature"] < 2 * NEXT_TO_BOTTOM


ANY = "a random state and wire"


def asked(calls):
    """The same calls, with their kinds."""
    return [call.on(kind_of(call, ANY)) for call in calls]


def digits(call):
    """The limit for x'', relative to itself."""
    return FEW_DIGITS if next_to_bottom(call) else POINTWISE


def largest_term(call):
    """Size of x'' or of what cancels in it, m/s^2."""
    x, v = call.args
    wire = call.kwargs
    return abs(acceleration(x, v, **wire)) or wire["gravity"] + wire["curvature"] * v**2 or 1.0


@check(points=1, part="a", suspects=ENERGY_SUSPECTS)
def lagrangian_is_kinetic_less_potential(student, draw):
    """lagrangian: T - V in x, v, m, c, g, V up to a constant."""
    calls = beads(draw)
    points = points_of(calls)
    level = student.lagrangian.at([{**point, "x": 0.0, "v": 0.0} for point in points])
    for value, call in zip(student.lagrangian.at(points) - level, calls, strict=True):
        kinetic, potential = energies(*call.args, **call.kwargs)
        expect(
            value,
            kinetic - potential,
            within=POINTWISE,
            scale=kinetic + potential or 1.0,
            of="the Lagrangian",
            unit="of T + V",
            kind=kind_of(call, "random numbers for the symbols"),
            at=call,
            hint="how fast is the bead along the wire when x changes at the rate v?",
        )


@check(points=1.5, part="a", suspects=EQUATION_SUSPECTS)
def lagrange_gives_the_acceleration(student, draw):
    """lagrange_equation: x'' in x, v, c, g alone."""
    calls = massless(beads(draw))
    for value, call in zip(student.lagrange_equation.at(points_of(calls)), calls, strict=True):
        expected = acceleration(*call.args, **call.kwargs)
        expect(
            value,
            expected,
            within=digits(call),
            scale=largest_term(call),
            of="x''",
            unit="of itself",
            at=call,
            kind=kind_of(call, "random numbers for the symbols"),
            hint="dT/dv depends on x, so its rate has a term with v; and dT/dx is not zero",
        )


@check(points=1.5, part="b", suspects=EQUATION_SUSPECTS)
def newton_gives_the_acceleration(student, draw):
    """acceleration_newton: x'' by F = m a along the tangent, as Lagrange has it."""
    calls = massless(beads(draw))
    # what tells a lost sign from the truth first
    calls.sort(key=lambda call: call.args[0] >= 0 or call.args[1] == 0)
    for value, call in zip(student.acceleration_newton.many(asked(calls)), calls, strict=True):
        expected = acceleration(*call.args, **call.kwargs)
        expect(
            value,
            expected,
            within=digits(call),
            scale=largest_term(call),
            of="x''",
            unit="of itself",
            at=call,
            kind=kind_of(call, ANY),
            hint="differentiate y = c x^2 twice: y'' has two terms",
        )


def wrong_force(says, size, side=1, rate=lambda v, slope: v):
    """A force along the normal of size(m, c v^2, g) over the length of (-side slope, 1), v being that rate."""

    def force(x, v, *, mass, curvature, gravity):
        slope = 2 * curvature * x
        upward = size(mass, curvature * rate(v, slope) ** 2, gravity) / (1 + slope**2)
        return [-side * slope * upward, upward]

    return suspect(says, constraint_force=force)


def bent_as_at_the_bottom(slope, x_rate, c, v, mass, gravity):
    size = mass * (2 * c * (1 + slope**2) * v**2 + gravity / math.hypot(1, slope))
    return np.array([-slope, 1.0]) * size / math.hypot(1, slope)


def without_bend(slope, x_rate, c, v, mass, gravity):
    return mass * np.array([x_rate, slope * x_rate + gravity])


def unlike(x, v, *, rate, mass, curvature, gravity):
    """A wrong force by rate(slope, x'', c, v, m, g)."""
    x_rate = acceleration(x, v, curvature=curvature, gravity=gravity)
    return rate(2 * curvature * x, x_rate, curvature, v, mass, gravity)


FORCE_SUSPECTS = [
    wrong_force("the force on a bead at rest, the term with v^2 missing", lambda m, bend, g: m * g),
    wrong_force("half the term with v^2", lambda m, bend, g: m * (g + bend)),
    wrong_force("the sign of the term with v^2 reversed", lambda m, bend, g: m * (g - 2 * bend)),
    wrong_force("the sign of gravity reversed", lambda m, bend, g: m * (2 * bend - g)),
    wrong_force("a mass of 1 for the one given", lambda m, bend, g: g + 2 * bend),
    wrong_force(
        "v for the speed along the wire, where it is that along x",
        lambda m, bend, g: m * (g + 2 * bend),
        rate=lambda v, slope: v / math.hypot(1, slope),
    ),
    suspect(
        "the radius of curvature at the bottom, 1/(2 c), taken everywhere",
        constraint_force=lambda x, v, **bead: unlike(x, v, rate=bent_as_at_the_bottom, **bead),
    ),
    suspect(
        "y'' without the term 2 c v^2: y = c x^2 differentiated twice has two terms",
        constraint_force=lambda x, v, **bead: unlike(x, v, rate=without_bend, **bead),
    ),
]
DIRECTION_SUSPECTS = [
    wrong_force("the force reversed, that of the bead on the wire", lambda m, bend, g: -m * (g + 2 * bend)),
    wrong_force("the normal tilted to the wrong side", lambda m, bend, g: m * (g + 2 * bend), side=-1),
    suspect(
        "a force that always points to the left, where it points to the middle",
        constraint_force=lambda x, v, **bead: to_the_left(x, v, **bead),
    ),
    suspect(
        "a force straight up, not along the normal",
        constraint_force=lambda x, v, **bead: [0.0, normal_force(x, v, **bead)],
    ),
]


def to_the_left(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = normal_force(x, v, mass=mass, curvature=curvature, gravity=gravity) / math.hypot(1, slope)
    return [-abs(slope) * upward, upward]


def forces(student, draw):
    """The student's forces, the right sizes, and the calls."""
    calls = beads(draw)
    sizes = [normal_force(*call.args, **call.kwargs) for call in calls]
    return zip(student.constraint_force.many(asked(calls)), sizes, calls, strict=True)


@check(points=0.75, part="b", suspects=FORCE_SUSPECTS)
def force_has_the_right_size(student, draw):
    """constraint_force: as large as carrying and turning the bead takes."""
    for force, size, call in forces(student, draw):
        expect(
            math.hypot(*force),
            size,
            within=POINTWISE,
            scale=size or 1.0,
            of="the size of the force",
            unit="of itself",
            kind=kind_of(call, ANY),
            at=call,
            hint="what force does a bead need at the bottom, at rest and passing by?",
        )


@check(points=0.5, part="b", after=force_has_the_right_size, suspects=DIRECTION_SUSPECTS)
def force_and_weight_make_the_acceleration(student, draw):
    """constraint_force: normal to the wire, and with the weight it is m a."""
    for force, size, call in forces(student, draw):
        x, v = call.args
        mass, curvature, gravity = call.kwargs.values()
        along_x = acceleration(x, v, curvature=curvature, gravity=gravity)
        along_y = 2 * curvature * (x * along_x + v**2)
        expect(
            force,
            [mass * along_x, mass * (along_y + gravity)],
            within=POINTWISE,
            scale=size or 1.0,
            of="the force",
            unit="of its size",
            kind=kind_of(call, ANY),
            at=call,
            hint="dot it with the tangent (1, 2 c x); and does it act on the bead?",
        )


@check(points=1, part="b", suspects=ENERGY_SUSPECTS)
def energy_is_kinetic_and_potential(student, draw):
    """energy: of the speed along the wire and of the height above the bottom."""
    calls = beads(draw)
    (_, v), bead = calls[0].args, calls[0].kwargs
    calls.append(given(NEXT_TO_BOTTOM / bead["curvature"], NEXT_TO_BOTTOM * v, **bead))
    for value, call in zip(student.energy.many(asked(calls)), calls, strict=True):
        expected = sum(energies(*call.args, **call.kwargs))
        expect(
            value,
            expected,
            within=POINTWISE,
            scale=expected or 1.0,
            of="the energy",
            unit="of itself",
            at=call,
            kind=kind_of(call, ANY),
            hint="v is not the speed along the wire",
        )


def inverse(function, values, low, high):
    """Where an increasing function takes these values between low and high, by bisection."""
    for _ in range(60):
        middle = (low + high) / 2
        above = function(middle) > values
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return (low + high) / 2


def arc(u):
    """Length of the parabola y = x^2/2 up to x = u."""
    return (u * np.sqrt(1 + u**2) + np.arcsinh(u)) / 2


def amplitude(x, v, *, curvature, gravity):
    return math.sqrt(x**2 + (1 + (2 * curvature * x) ** 2) * v**2 / (2 * gravity * curvature))


def exact(t, x, v, *, curvature, gravity):
    """The motion, t = 0 at the start: x = A sin phi, where Legendre's E(phi, -(2 c A)^2) grows evenly."""
    c, speed = curvature, v * math.hypot(1, 2 * curvature * x)
    if gravity == 0:
        u = 2 * c * (x + np.outer([-1, 1], abs(speed) * t))
        u = inverse(arc, arc(2 * c * x) + 2 * c * speed * t, *u)
        return np.column_stack([u / (2 * c), speed / np.sqrt(1 + u**2)])
    size, rate = amplitude(x, v, curvature=c, gravity=gravity), math.sqrt(2 * gravity * c)
    m = -((2 * c * size) ** 2)
    grown = ellipeinc(math.atan2(x, speed / rate), m) + rate * t
    quarter = np.floor(grown / ellipe(m)) * math.pi / 2
    phi = inverse(lambda phi: ellipeinc(phi, m), grown, quarter, quarter + math.pi / 2)
    return size * np.column_stack([np.sin(phi), rate * np.cos(phi) / np.sqrt(1 - m * np.sin(phi) ** 2)])


def ride(draw, steepness):
    """A start and a wire, with curvature times amplitude in a range, and the rate sqrt(2 g c) of small motions."""
    curvature, gravity = 10 ** draw.uniform(-0.7, 0.7), draw.uniform(1, 25)
    size, rate = draw.uniform(*steepness) / curvature, math.sqrt(2 * gravity * curvature)
    angle = draw.uniform(0.5, 1.2) * draw.choice([-1, 1])
    speed = size * rate * math.cos(angle) * draw.choice([-1, 1])
    x = size * math.sin(angle)
    return (x, speed / math.hypot(1, 2 * curvature * x)), {"curvature": curvature, "gravity": gravity}, rate


@once
def motion(draw, steepness, turns, rows):
    """Times, start, wire, the exact motion, and the scales of x and v."""
    start, wire, rate = ride(draw, steepness)
    return ridden(uneven(draw, turns / rate, rows), start, wire, rate)


@once
def sharp_turns(draw):
    """As `motion`, for three times: between the first two, most of the run, the bead passes the bottom, sharply."""
    start, wire, rate = ride(draw, (4.3, 5.0))
    first, last = uneven(draw, 21.0 / rate, 2)
    return ridden(np.array([first, last - 1.5 / rate, last]), start, wire, rate)


def ridden(t, start, wire, rate):
    size = amplitude(*start, **wire)
    return t, start, wire, exact(t - t[0], *start, **wire), [size, size * rate]


def judge_motion(student, case, kind, hint, within=TRAJECTORY):
    """Compare a simulation with the exact motion; half the points for a tolerance too loose.

    hint : where to look, or what tells it of the student, the case, its rows and their errors
    """
    t, start, wire, expected, scale = case
    found = student.on(kind).simulate(t, *start, **wire)
    errors = np.max(np.abs(found - expected) / scale, axis=1)
    expect(
        found,
        expected,
        within=within,
        scale=scale,
        of="x, or v,",
        unit="of its largest value",
        t=t,
        kind=kind,
        hint=(lambda: hint(student, case, found, errors)) if callable(hint) else hint,
        at=(start, wire),
        partial={1e-3: 0.5},
        keeps=lambda: kept(t, energy_along(found, wire), within=ENERGY, of="the energy", unit="of itself"),
    )


def hint_of_large_motions(student, case, found, errors):
    """Rows that nearly obey the equation from the right start can but drift."""
    if joined(student, case, errors):
        return JOINED
    t, _, wire, *_ = case
    rates = np.gradient(found, t, axis=0, edge_order=2)
    right = np.column_stack([found[:, 1], [acceleration(*state, **wire) for state in found]])
    disobeyed = np.max(np.abs(rates - right) / np.max(np.abs(right), axis=0), axis=1)
    if errors[0] <= TRAJECTORY and np.quantile(disobeyed, 0.9) <= NEARLY:  # steps may meet with a kink
        return "the rows nearly obey the equation: are the steps short, and the tolerance tight?"
    return "is v the rate of x, and x'' that of part (a)?"


def joined(student, case, errors):
    """Whether the worst row is right where its time is the last, at which every integrator ends a step."""
    t, start, wire, expected, scale = case
    row = int(np.argmax(errors))
    # a loose tolerance is off by less, or by more
    if row == 0 or not 10 * TRAJECTORY < errors[row] < JOINABLE:
        return False
    again = another(student, t[[0, row]], start, wire)
    return again is not None and max(abs(again[-1] - expected[row]) / scale) <= TRAJECTORY


def hint_of_steps(otherwise, found_out, rows=None):
    """`found_out` where times in between bring a row right, which cannot be the equation's fault.

    rows : from the case and its errors, the two rows between which to put the times; else the first that is off
    """

    def hint(student, case, found, errors):
        t, start, wire, expected, scale = case
        first, last = (rows or first_off)(case, errors)
        if errors[last] <= TRAJECTORY or first == last:
            return otherwise
        again = another(student, np.concatenate([t[:first], np.linspace(t[first], t[last], 300)]), start, wire)
        better = again is not None and max(abs(again[-1] - expected[last]) / scale) <= BETTER * errors[last]
        return found_out if better else otherwise

    return hint


def hint_of_two_times(student, case, found, errors):
    """Whether the times, the start or the equation is what is mistaken."""
    stays = "the bead stays where it was let go" if np.all(found == found[0]) else ""
    even = "it is the oscillation of small amplitudes: however small, the other terms are there" * harmonic(case, found)
    otherwise = stays or even or "row 0 is the start, row 1 the other time"
    return hint_of_steps(otherwise, SAMPLED)(student, case, found, errors)


def harmonic(case, found):
    """Whether this is the motion by x'' = -2 g c x."""
    t, (x, v), wire, _, scale = case
    rate = math.sqrt(2 * wire["gravity"] * wire["curvature"])
    z = (x - 1j * v / rate) * np.exp(1j * rate * (t - t[0]))
    return bool(np.max(np.abs(found - np.column_stack([z.real, -rate * z.imag])) / scale) <= TRAJECTORY)


def first_off(case, errors):
    """The first row that is off, and the one before it."""
    row = int(np.argmax(errors > BETTER * errors.max()))
    return max(row - 1, 0), row


def first_turn(case, errors):
    """Rows before and behind the first pass of the bottom."""
    x = case[3][:, 0]
    row = int(np.argmax(x * x[0] < 0))
    return max(row - 2, 0), min(row + 1, len(x) - 1)


def another(student, t, start, wire):
    """A further simulation, to choose the words; None if there is none."""
    try:
        return student.simulate(t, *start, **wire)
    except Failed:
        return None


def energy_along(states, wire):
    """2 E/m along a motion, over its first value."""
    x, v = states.T
    curvature = wire["curvature"]
    energies = (1 + (2 * curvature * x) ** 2) * v**2 + 2 * wire["gravity"] * curvature * x**2
    return energies / energies[0]


def with_speeds(t, x, v, *, curvature, gravity):
    """Its second column is the speed along the wire, with the sign of v."""
    states = exact(t - t[0], x, v, curvature=curvature, gravity=gravity)
    return states * np.column_stack([np.ones(len(t)), np.hypot(1, 2 * curvature * states[:, 0])])


SIMULATE_SUSPECTS = [
    *EQUATION_SUSPECTS,
    *mistimed(lambda t, *start, **wire: exact(t - t[0], *start, **wire), from_zero=exact),
    suspect("the speed along the wire in place of v", within=1e-4, simulate=with_speeds),
    suspect("solve_ivp at its default tolerance", simulate=integrated(acceleration, "RK45")),
]


@check(points=1, part="b", suspects=SIMULATE_SUSPECTS)
def simulate_slides(student, draw):
    """simulate: large motions, row i at t[i], row 0 the given state."""
    judge_motion(student, motion(draw, (0.4, 1.0), 15.0, 1000), "an amplitude near 1/c", hint_of_large_motions)


SAMPLED = "with more times in between, the same motion comes out far better: how t is sampled must not change it"
TOO_LONG = "with more times in between it comes out far better: the steps are too long for the turn at the bottom"
JOINED = (
    "asked for alone, its worst time comes out far better: are the rows the integrator's own at t (t_eval, or "
    "dense_output), or joined by straight lines?"
)
OWN_STEPS = "the steps of the integration are not those of t; is the tolerance tight?"
LONGER = "over a shorter time the same rows come out far better: the steps must not grow with the duration"


@check(points=0.5, part="b", after=simulate_slides)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for."""
    judge_motion(student, sharp_turns(draw), "few times, far apart", hint_of_steps(OWN_STEPS, SAMPLED))
    for case, kind in plain_motions(draw):
        judge_motion(student, case, f"two times, the bead let go {kind}", hint_of_two_times)
    t, wire = uneven(draw, 5.0, 2), {"curvature": draw.uniform(0.5, 2), "gravity": draw.uniform(1, 25)}
    kind = "a bead at rest at the bottom, where it stays"
    expect(
        student.on(kind).simulate(t, 0.0, 0.0, **wire),
        np.zeros((2, 2)),
        within=TRAJECTORY,
        of="x or v",
        unit="m or m/s",
        kind=kind,
        at=wire,
    )


CLOSE = "at rest, close to the bottom"
STARTS = (
    ("at rest", 0.4, 1.0),
    ("at the bottom", 0.4, 1.0),
    (CLOSE, 0.02, 0.025),  # times 1/c: the oscillation of small amplitudes is off by 2e-3
)


@once
def plain_motions(draw):
    """As `motion`, each with its kind: let go at rest on either side, close to the bottom, and at it either way."""
    cases = []
    for kind, low, high in STARTS:
        for sign in (1, -1)[: 1 if kind == CLOSE else 2]:
            _, wire, _ = ride(draw, (0.4, 1.0))
            if kind == CLOSE:
                # on which an absolute tolerance of 1e-9 m is good to 1e-6
                wire["curvature"] = draw.uniform(0.5, 2)
            rate = math.sqrt(2 * wire["gravity"] * wire["curvature"])
            size, t = sign * draw.uniform(low, high) / wire["curvature"], uneven(draw, 5.0 / rate, 2)
            start = (0.0, size * rate) if kind == "at the bottom" else (size, 0.0)
            scale = [abs(size), abs(size) * rate]
            cases.append(((t, start, wire, exact(t - t[0], *start, **wire), scale), kind))
    return cases


@check(points=0.25, part="b", after=simulate_slides)
def simulate_without_gravity(student, draw):
    """simulate: without gravity the bead goes along the wire at its speed."""
    start, wire, rate = ride(draw, (0.4, 1.0))
    t = uneven(draw, 6 / rate, 30)
    student.simulate(t, *start, **wire)  # who keeps it by times and start alone gives it again
    wire = {**wire, "gravity": 0.0}
    expected = exact(t - t[0], *start, **wire)
    judge_motion(
        student,
        (t, start, wire, expected, np.max(np.abs(expected), axis=0)),
        "gravity 0",
        "is anything divided by gravity?",
    )


@check(points=0.25, part="b", after=simulate_slides)
def simulate_slides_down_steep_wires(student, draw):
    """simulate: an amplitude of many 1/c, where the bead turns sharply at the bottom."""
    judge_motion(
        student,
        motion(draw, (5.0, 8.0), 60.0, 60),
        "an amplitude of several 1/c",
        hint_of_steps("is the tolerance tight enough for the sharp turn at the bottom?", TOO_LONG, first_turn),
        SHARP_TURN,
    )


@check(points=0.25, part="b", after=simulate_slides)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many periods."""
    start, wire, rate = ride(draw, (0.4, 1.0))
    t = uneven(draw, 180 / rate, 300)
    kind = "many periods"
    states = student.on(kind).simulate(t, *start, **wire)
    energy = energy_along(states, wire)
    # the last third is five periods or more, and the bead goes to and fro by twice its amplitude in each
    expect_that(np.ptp(states[-100:, 0]) > amplitude(*start, **wire), "the bead does not move", kind=kind)
    expect(
        energy,
        np.ones(len(t)),
        within=ENERGY,
        of="the energy",
        unit="of itself",
        t=t,
        kind=kind,
        at=(start, wire),
        partial={1e-3: 0.6, 1e-2: 0.3},
        hint=lambda: hint_of_durations(student, t, start, wire, energy),
    )


def hint_of_durations(student, t, start, wire, energy):
    """What is changed by a shorter run, and by a denser one."""
    few = len(t) // 12
    lost = drift(energy[:few])
    denser = np.interp(np.arange(0, few - 0.95, 0.1), np.arange(few), t[:few])
    for asked_for, every, says in ((t[:few], 1, LONGER), (denser, 10, SAMPLED)):
        again = another(student, asked_for, start, wire)
        better = again is not None and drift(energy_along(again, wire)[::every]) <= BETTER * lost
        if better and lost > BETTER * ENERGY:
            return says
    return "is the step short, and the tolerance tight enough for many periods?"


def drift(energy):
    """The largest error of an energy that should stay 1."""
    return np.max(np.abs(energy - 1.0))


def period_suspect(says, swings):
    """`swings`: the wrong period, in units of 1/sqrt(2 g c), for 2 c A."""

    def period(size, *, curvature, gravity):
        return swings(2 * curvature * size) / math.sqrt(2 * gravity * curvature)

    return suspect(says, period=period)


PERIOD_SUSPECTS = [
    period_suspect("the period of small amplitudes", lambda a: 2 * math.pi),
    period_suspect("the integral of the first kind for that of the second", lambda a: 4 * ellipk(-(a**2))),
    period_suspect("c x for the slope 2 c x", lambda a: 4 * ellipe(-(a**2) / 4)),
    period_suspect("the first two terms of the series in the amplitude", lambda a: 2 * math.pi * (1 + a**2 / 4)),
    period_suspect("half the period", lambda a: 2 * ellipe(-(a**2))),
    period_suspect(
        "the modulus for the parameter: SciPy's ellipe takes k^2",
        lambda a: 4 * math.hypot(1, a) * ellipe(a / math.hypot(1, a)),
    ),
    period_suspect("the modulus for the parameter: SciPy's ellipe takes k^2", lambda a: 4 * ellipe(-a)),
    period_suspect(
        "the factor before the integral, sqrt(1 + (2 c A)^2), missing", lambda a: 4 * ellipe(a**2 / (1 + a**2))
    ),
]


def judge_periods(student, draw, steepness, kind, hint, within=PERIOD, decades=(-1, 1)):
    """Compare with Legendre's complete integral of the second kind.

    hint    : where to look, or what tells it of the amplitudes, in units of 1/c, and the errors
    decades : of the curvature
    """
    curvatures, gravities = 10 ** draw.uniform(*decades, len(steepness)), draw.uniform(1, 25, len(steepness))
    rates = np.sqrt(2 * gravities * curvatures)
    calls = [
        given(ca / curvature, curvature=curvature, gravity=gravity)
        for ca, curvature, gravity in zip(steepness, curvatures, gravities, strict=True)
    ]
    periods, right = student.on(kind).period.many(calls), 4 * ellipe(-4 * steepness**2) / rates
    errors = np.abs(periods / right - 1)
    for found, expected, call in zip(periods, right, calls, strict=True):
        expect(
            found,
            expected,
            within=within,
            scale=expected,
            of="the period",
            unit="of itself",
            kind=kind,
            at=call,
            hint=(lambda: hint(steepness, errors)) if callable(hint) else hint,
        )


def hint_of_huge_amplitudes(steepness, errors):
    """What reaches only so far is worst where the amplitude is largest."""
    least, most = np.argmin(steepness), np.argmax(steepness)
    if errors[most] == errors.max() > errors[least] / BETTER:
        return "the error grows with the amplitude, as that of a series in it or of a quadrature of fixed order does"
    return "is the tolerance of the quadrature tight enough?"


@check(points=1, part="b", suspects=PERIOD_SUSPECTS)
def period_is_exact(student, draw):
    """period: exact for amplitudes near 1/c."""
    judge_periods(
        student,
        draw,
        draw.uniform(0.2, 0.6, 8),
        "an amplitude near 1/c",
        "the energy gives v at every x, and dt = dx/v",
    )


@check(points=0.5, part="b", after=period_is_exact)
def period_of_small_and_of_huge_amplitudes(student, draw):
    """period: exact where the wire is almost flat and where it is almost upright."""
    judge_periods(
        student,
        draw,
        np.full(2, 1e-5),
        "an amplitude of a hundred-thousandth of 1/c",
        "is a small number added under a root, or a tolerance absolute? 1e-15 m^2 is not small there",
        TINY,
        (0.5, 1),
    )
    judge_periods(
        student,
        draw,
        10 ** draw.uniform(-3, -2, 3),
        "an amplitude of some thousandths of 1/c",
        "is a difference of nearly equal heights taken?",
    )
    judge_periods(
        student,
        draw,
        np.append(10 ** draw.uniform(1, 2, 3), 100.0),
        "an amplitude of many 1/c",
        hint_of_huge_amplitudes,
    )
