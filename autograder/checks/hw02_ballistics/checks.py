"""Hidden checks of hw02. What is right is summed here by superposition: each bit of speed that launch and gravity give
decays on its own, and the sum over them is done by Gauss's quadrature, which drag zero does not trouble.
"""

import math
from functools import partial
from operator import attrgetter

import numpy as np
from scipy.optimize import brentq

from tam570_grader import (
    SOME_TIMES,
    Failed,
    array,
    check,
    distances,
    drawing,
    expect,
    expect_that,
    given,
    judge_axes_of_lengths,
    mistimed,
    number,
    once,
    rows,
    suspect,
    uneven,
)
from tam570_grader.writing.curves import along

RESULTS = {
    "state_derivative": array(4),
    "simulate": rows(4),
    "trajectory": rows(4),
    "flight_time": number,
    "horizontal_range": number,
    "best_angle": number,
    "limit_shape": array(3, 2),
    "plot_comparison": drawing,
}
NEEDS = ("numpy", "matplotlib.figure")
OFF_LIMITS = {"trajectory": ("scipy.integrate", "tam570.integrate")}  # a closed form is asked for
MANUAL = {"b": (2, "the guess before the work; why the limit has the shape it has")}

POINTWISE = 1e-12  # a few roundings of the accelerations make 1e-15
SIMULATED = 1e-6  # RK45, DOP853, LSODA at rtol 1e-9, atol 1e-9 are off by 1.3e-9 of the size, RK4 by 1e-8
CLOSED = 1e-10  # 1e-15 with expm1; a Taylor series that takes over where five digits are lost, 1e-11
ROOT = 1e-6  # of the time; roots found by brentq or Newton are good to 1e-9, an event of a simulation to 1e-7
ANGLE = 1e-6  # rad, as the contract asks; minimising the range itself is good to 1e-8
SWIFT = 1e-2  # of the angle, as the contract asks
CORNER = 1e-9  # the path below, at a speed of 1e12 terminal speeds, is 5e-11 from its limit
NEAR = 2e-3  # rad; a search among a thousand angles gets there, to choose the words
NEARLY = 1e-2  # below it a right equation is solved coarsely, to choose the words
# Of the path's size. The chords between FINE points of the motion leave its path by g (T/1000)^2/8: 2e-5 of its size at
# a hundred times the terminal speed, where T = 1.2 v/g is longest for it; the points of a simulation leave it by 1e-7.
DRAWN, FINE = 1e-4, 1001
SAMPLES = 401  # every 2nd, 4th, 5th, 8th, 10th or 20th is a series that ends with the last
PASSED = 2e-2  # of the path's size; chords of a line of ten points leave a parabola by (2.4/9)^2/4 = 1.8e-2

NODES, WEIGHTS = (np.polynomial.legendre.leggauss(40)[0] + 1) / 2, np.polynomial.legendre.leggauss(40)[1] / 2


def means(s):
    """The means of e^(-s u) and of (1 - u) e^(-s u) over 0 < u < 1."""
    s = np.asarray(s, float)
    wide = np.maximum(s, 30.0)  # beyond, e^-s is below rounding beside 1
    decays = np.exp(-np.minimum(s, 30.0)[..., None] * NODES)
    first, second = decays @ WEIGHTS, decays @ (WEIGHTS * (1 - NODES))
    late = -np.expm1(-wide) / wide
    return np.where(s < 30, first, late), np.where(s < 30, second, (1 - late) / wide)


def motion(since, vx, vy, fade_x, fade_y, gravity):
    """(n, 4) states at times since the launch; the components of the velocity fade at rates of their own."""
    (mean_x, _), (mean_y, late_y) = means(fade_x * since), means(fade_y * since)
    return np.column_stack(
        [
            vx * since * mean_x,
            vy * since * mean_y - gravity * since**2 * late_y,
            vx * np.exp(-fade_x * since),
            vy * np.exp(-fade_y * since) - gravity * since * mean_y,
        ]
    )


def right(since, speed, angle, *, mass, drag, gravity):
    return motion(since, speed * math.cos(angle), speed * math.sin(angle), drag / mass, drag / mass, gravity)


def quadratic(since, speed, angle, *, mass, drag, gravity):
    """The motion with the force -c abs(v) v."""
    from scipy.integrate import solve_ivp

    def rates(t, state):
        vx, vy = state[2:]
        fade = drag / mass * math.hypot(vx, vy)
        return vx, vy, -fade * vx, -fade * vy - gravity

    start = [0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle)]
    return solve_ivp(rates, (0, since[-1] or 1), start, method="DOP853", t_eval=since, rtol=1e-8).y.T


def faded(x, y, gravity_sign=1):
    """The motion with x c/m and y c/m for the rates at which the velocity's components fade."""

    def wrong(since, speed, angle, *, mass, drag, gravity):
        fade, (vx, vy) = drag / mass, (speed * math.cos(angle), speed * math.sin(angle))
        return motion(since, vx, vy, x * fade, y * fade, gravity_sign * gravity)

    return wrong


WRONG_MOTIONS = {
    "quadratic drag, -c v^2; here it is linear": quadratic,
    "drag on the horizontal component alone": faded(1, 0),
    "drag on the vertical component alone": faded(0, 1),
    "no drag at all, a parabola": faded(0, 0),
    "gravity pointing up": faded(1, 1, -1),
    "the vertical drag not divided by the mass": lambda since, speed, angle, *, mass, drag, gravity: motion(
        since, speed * math.cos(angle), speed * math.sin(angle), drag / mass, drag, gravity
    ),
    "the drag force not divided by the mass": lambda since, *launch, mass, drag, gravity: right(
        since, *launch, mass=1.0, drag=drag, gravity=gravity
    ),
    "the angle measured from the vertical": lambda since, speed, angle, **parameters: right(
        since, speed, math.pi / 2 - angle, **parameters
    ),
    "the angle taken for degrees": lambda since, speed, angle, **parameters: right(
        since, speed, math.radians(angle), **parameters
    ),
}


def rates_of(wrong):
    """state_derivative of a wrong motion: what it does in the first instant after the state."""

    def derivative(t, state, **parameters):
        vx, vy = state[2:]
        h = 1e-6
        late = wrong(np.array([0.0, h]), math.hypot(vx, vy), math.atan2(vy, vx), **parameters)[1]
        return np.array([vx, vy, *(late[2:] - state[2:]) / h])

    return derivative


SIMULATE_SUSPECTS = [
    suspect(says, within=1e-4, simulate=lambda t, *launch, wrong=wrong, **known: wrong(t - t[0], *launch, **known))
    for says, wrong in WRONG_MOTIONS.items()
] + mistimed(lambda t, *launch, **known: right(t - t[0], *launch, **known), from_zero=right)
TRAJECTORY_SUSPECTS = [suspect(says, within=1e-4, trajectory=wrong) for says, wrong in WRONG_MOTIONS.items()]
RATES_SUSPECTS = [
    suspect(says, within=1e-3, state_derivative=rates_of(wrong))
    for says, wrong in WRONG_MOTIONS.items()
    if "angle" not in says
] + [
    suspect(
        "a drag that points down in the fall, too",
        state_derivative=lambda t, state, *, mass, drag, gravity: np.array(
            [*state[2:], -drag / mass * state[2], -drag / mass * abs(state[3]) - gravity]
        ),
    )
]


def parameters(draw, **fixed):
    """A random mass, drag and gravity, some of them fixed; the rate c/m is from .05 to 1.5."""
    mass = 10 ** draw.uniform(-0.7, 1)
    free = {"mass": mass, "drag": mass * 10 ** draw.uniform(-1.3, 0.2), "gravity": draw.uniform(1.5, 25)}
    return {**free, **fixed}


def light(draw):
    """Mass and drag of a particle of some milligrams: the drag is tiny, but not beside the weight."""
    mass = 10 ** draw.uniform(-6, -5)
    return {"mass": mass, "drag": mass * draw.uniform(0.3, 1.5)}


def light_particle(draw):
    return parameters(draw, **light(draw))


LIGHT = "a light particle, whose drag is small in kg/s alone"
SMALL_BESIDE = "whether drag counts is told by c t/m or c v/(m g), not by c alone"


def launch(draw):
    return 10 ** draw.uniform(0.5, 2), draw.uniform(0.15, 1.4)


@check(points=0.75, part="a", suspects=RATES_SUSPECTS)
def rates_are_newtons(student, draw):
    """state_derivative is the velocity and (weight + drag)/mass, for velocities in any direction."""
    calls = [
        given(draw.uniform(-5, 5), draw.normal(size=4) * 10 ** draw.uniform(0, 2), **parameters(draw))
        for _ in range(20)
    ]
    hint = "draw the two forces on the particle; which way does each point when it falls?"
    judge_rates(student, calls, "a random state, mass, drag and gravity", hint)
    for kind, velocity in PLAIN_VELOCITIES.items():
        places = [draw.normal(size=2) * 10, np.zeros(2), -np.ones(2)]
        states = [np.append(place, velocity * draw.uniform(1, 9)) for place in places]
        judge_rates(student, [given(0.0, state, **parameters(draw)) for state in states], kind, hint)
    whole = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
    judge_rates(student, [given(0.0, np.array([1.0, 1.0, -1.0, 1.0]), **whole)], "whole numbers", hint)
    judge_rates(student, [given(0.0, draw.normal(size=4) * 10, **light_particle(draw))], LIGHT, SMALL_BESIDE)


PLAIN_VELOCITIES = {
    "a particle at rest": np.zeros(2),
    "a particle at the top of its path": np.array([1.0, 0.0]),
    "a particle at the top of its path, thrown to the left": np.array([-1.0, 0.0]),
    "a particle on its way straight up": np.array([0.0, 1.0]),
    "a particle that falls straight down": np.array([0.0, -1.0]),
}


ZEROS = (("drag",), ("gravity",), ("drag", "gravity"))


@check(points=0.25, part="a", after=rates_are_newtons)
def rates_without_drag_or_gravity(student, draw):
    """state_derivative holds where drag or gravity, or both, are zero."""
    for zero in ZEROS:
        calls = [
            given(0.0, draw.normal(size=4) * moving * 10, **parameters(draw, **dict.fromkeys(zero, 0.0)))
            for moving in (1, 1, 1, [1, 1, 0, 0], [1, 1, 0, 1], [1, 1, 1, 0])
        ]
        judge_rates(student, calls, f"zero {' and '.join(zero)}", "nothing may be divided by drag or gravity")


def judge_rates(student, calls, kind, hint):
    for found, call in zip(student.on(kind).state_derivative.many(calls), calls, strict=True):
        (_, state), (mass, drag, gravity) = call.args, call.kwargs.values()
        v = state[2:]
        expected = np.concatenate([v, -drag / mass * v - (0, gravity)])
        scale = np.linalg.norm(v) * (1 + drag / mass) + gravity
        expect(
            found,
            expected,
            within=POINTWISE,
            scale=scale or 1.0,
            of="the state's derivative",
            unit="of v, c v/m and g",
            kind=kind,
            hint=hint,
            at=call,
        )


def size(call, expected):
    """The scale of each column: the largest distance and the largest speed.

    They are those on the way, too: at two times alone a particle may be next to where it was launched.
    """
    way = right(np.linspace(0.0, np.ptp(call.args[0]), 9), *call.args[1:], **call.kwargs)
    states = np.abs(np.vstack([expected, way]))
    return np.repeat([states[:, :2].max(), states[:, 2:].max()], 2)


@once
def flights(draw, starts, zero=()):
    """Calls that launch at t[0], and the right states; `zero` names the parameters that are."""
    return [flight(draw, start, 0.0, dict.fromkeys(zero, 0.0)) for start in starts]


@once
def late_flights(draw, starts):
    """Calls that launch at t = 0 and ask from a later (or earlier) time on, and the right states."""
    return [flight(draw, start, start, {}) for start in starts]


def flight(draw, start, since, fixed):
    """A call with times from `start` on, of which the first is `since` the launch, and the right states."""
    (speed, angle), known = launch(draw), parameters(draw, **fixed)
    fade = known["drag"] / known["mass"] or 0.3
    t = uneven(draw, draw.uniform(1, 3) / fade, 30, start)
    return given(t, speed, angle, **known), right(t - t[0] + since, speed, angle, **known)


DIRECTIONS = {
    "a launch along x": 0.0,
    "a launch straight up": math.pi / 2,
    "a launch straight down": -math.pi / 2,
    "a launch to the left": math.pi,
    "a launch to the left, upwards": 2.0,
    "a launch downwards": -0.7,
    "a launch at 45 degrees": math.pi / 4,
}


@once
def plain_flights(draw, shifted):
    """As `flights`, two times each, with what to call it: directions that have a name, a drop, whole numbers.

    The launch is at t[0], which is zero unless the times are shifted.
    """
    known = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
    starts = [(kind, launch(draw)[0], angle, parameters(draw)) for kind, angle in DIRECTIONS.items()]
    starts += [("a particle dropped", 0.0, 1.0, parameters(draw)), ("whole numbers", 1.0, 1.0, known)]
    cases = []
    for kind, speed, angle, known in starts:
        first = shifted * draw.uniform(0.2, 2) * draw.integers(2)
        t = np.array([first, first + draw.uniform(1, 3) * known["mass"] / known["drag"]])
        call = given(t, speed, angle, **known)
        cases.append((kind, (call, right(t - first, speed, angle, **known))))
    return cases


def judge_plain_flights(function, draw, shifted, within, hint=""):
    named = plain_flights(draw, shifted)
    found = function.many([call.on(f"two times, {kind}") for kind, (call, _) in named])
    for states, (kind, case) in zip(found, named, strict=True):
        look = partial(simulation_hint, states, *case) if shifted else hint
        judge_states([states], [case], within, f"two times, {kind}", look)


def simulation_hint(states, call, expected):
    """What to look at in a simulation: what is right of it, the whole nearly, or the start?"""
    t, late = call.args[0], call.args[0] > max(call.args[0][0], 0.0)
    from_zero = right(np.maximum(t, 0.0), *call.args[1:], **call.kwargs)
    errors, deepest = np.abs(states - expected) / size(call, expected), expected[:, 1].min()
    if errors.max() <= NEARLY:
        return "are the steps short, and the tolerances of the integrator tight enough?"
    if deepest < 0 and states[:, 1].min() > NEARLY * deepest:
        return "there is no ground: the path goes on below y = 0"
    if errors[0].max() <= SIMULATED:
        return "row 0 is right: is your state_derivative, and is row i the state at t[i]?"
    if t[0] and late.any() and np.all(np.abs(states - from_zero)[late] <= NEARLY * size(call, from_zero)):
        return "the launch is at t[0], not at t = 0: integrate from t[0] on"
    return "is the first row the launch, at the origin?"


def column_hint(states, call, expected, hint):
    """What to look at in a closed form: the columns that are off, if others are right."""
    right = np.all(np.abs(states - expected) <= CLOSED * size(call, expected), axis=0)
    off = [name for name, one in zip(("x", "y", "vx", "vy"), right, strict=True) if not one]
    return f"of x, y, vx and vy only {' and '.join(off)} {'is' if len(off) == 1 else 'are'} off" if any(right) else hint


def judge_states(found, cases, within, kind, hint, points=None):
    for states, (call, expected) in zip(found, cases, strict=True):
        expect(
            states,
            expected,
            within=within,
            scale=size(call, expected),
            of="the state",
            t=call.args[0],
            unit="of the path's size or its speed",
            kind=kind,
            hint=hint,
            at=call,
            partial=points,
        )


@check(points=1, part="d", suspects=SIMULATE_SUSPECTS)
def simulation_follows_the_motion(student, draw):
    """simulate gives the states at uneven times, launched at t[0], whatever t[0] is."""
    cases = flights(draw, (0.0, 3.7, -2.0, 0.0))
    kinds = [f"a random launch{', t[0] not 0' if call.args[0][0] else ''}" for call, _ in cases]
    found = student.simulate.many([call.on(kind) for (call, _), kind in zip(cases, kinds, strict=True)])
    for states, case, kind in zip(found, cases, kinds, strict=True):
        hint = partial(simulation_hint, states, *case)
        judge_states([states], [case], SIMULATED, kind, hint, points={1e-4: 0.5})
    judge_plain_flights(student.simulate, draw, True, SIMULATED)


@check(points=0.5, part="d", after=simulation_follows_the_motion)
def simulation_without_drag_or_gravity(student, draw):
    """simulate goes straight on without gravity, on a parabola without drag, whatever was asked before."""
    for zero in ZEROS:
        cases, kind = flights(draw, (0.0,), zero), f"zero {' and '.join(zero)}"
        judge_states(
            student.on(kind).simulate.many([call for call, _ in cases]),
            cases,
            SIMULATED,
            kind,
            "nothing may be divided by drag or gravity",
        )
    judge_light_flight(student.simulate, draw, SIMULATED)
    judge_alike_flights(student.simulate, draw, SIMULATED)


@once
def light_flight(draw):
    """As one of `flights`, of a light particle."""
    return flight(draw, 0.0, 0.0, light(draw))


def judge_light_flight(function, draw, within):
    call, expected = light_flight(draw)
    judge_states(function.many([call.on(LIGHT)]), [(call, expected)], within, LIGHT, SMALL_BESIDE)


@once
def alike_flights(draw):
    """As `flights`, two times each, all like the first of them but for one argument; each call has its kind."""
    (speed, angle), known = launch(draw), parameters(draw)
    end = draw.uniform(1, 3) * known["mass"] / known["drag"]
    others = {"times": {"end": 0.6 * end}, "speed": {"speed": 1.3 * speed}, "angle": {"angle": 0.7 * angle}}
    others |= {name: {name: 1.4 * value} for name, value in known.items()}
    cases = []
    for name, change in {"": {}, **others}.items():
        arguments = {"end": end, "speed": speed, "angle": angle, **known, **change}
        t, *start = np.array([0.0, arguments.pop("end")]), arguments.pop("speed"), arguments.pop("angle")
        kind = f"a launch like the one before but for its {name}" if name else "two times"
        cases.append((given(t, *start, **arguments).on(kind), right(t, *start, **arguments)))
    return cases


def judge_alike_flights(function, draw, within):
    cases = alike_flights(draw)
    for found, case in zip(function.many([call for call, _ in cases]), cases, strict=True):
        judge_states([found], [case], within, case[0].kind, KEPT)


KEPT = "is anything kept between calls?"


@check(points=1, part="c", suspects=TRAJECTORY_SUSPECTS)
def trajectory_is_the_motion(student, draw):
    """trajectory gives the states in closed form."""
    cases = flights(draw, (0.0,) * 6) + flights(draw, (0.0,), ("gravity",))
    found = student.on("a random launch").trajectory.many([call for call, _ in cases])
    hint = "the equations of vx and vy are linear, of first order and apart; then x and y"
    for states, case in zip(found, cases, strict=True):
        judge_states([states], [case], CLOSED, "a random launch", partial(column_hint, states, *case, hint))
    judge_plain_flights(
        student.trajectory, draw, False, CLOSED, "which way does it fly, and is it launched at the origin?"
    )


@check(points=0.25, part="c", after=trajectory_is_the_motion)
def trajectory_counts_time_from_the_launch(student, draw):
    """trajectory takes the launch to be at t = 0, whatever times are asked for: later ones, a single one, backwards."""
    cases = late_flights(draw, (2.5, -0.5, 0.7))
    judge_states(
        student.trajectory.many([call for call, _ in cases]),
        cases,
        CLOSED,
        "times that do not begin at 0",
        "the first time asked for need not be that of the launch",
    )
    (call, states), *_ = cases
    for kind, some in SOME_TIMES.items():
        case = given(call.args[0][some], *call.args[1:], **call.kwargs).on(kind), states[some]
        judge_states(student.trajectory.many([case[0]]), [case], CLOSED, kind, "row i is the state at t[i]")


@check(points=0.75, part="c", after=trajectory_is_the_motion)
def trajectory_with_any_drag(student, draw):
    """trajectory keeps its digits at drag 1e-12, at no drag at all, and long after e^(-c t/m) is nothing."""
    for drag in (0.0, *10.0 ** draw.uniform(-14, -11, 3), *10.0 ** draw.uniform(-10, -2, 8)):
        (speed, angle), known = launch(draw), parameters(draw, drag=drag)
        call = given(uneven(draw, draw.uniform(1, 9), 20, 0.0), speed, angle, **known)
        kind = "very little drag" if drag else "no drag"
        case, (states,) = (call, right(*call.args, **call.kwargs)), student.on(kind).trajectory.many([call])
        judge_states([states], [case], CLOSED, kind, partial(drag_hint, states, call))
    judge_great_drag(student, draw)
    judge_light_flight(student.trajectory, draw, CLOSED)
    judge_alike_flights(student.trajectory, draw, CLOSED)


TAKEN_FOR_NONE = "very little drag is taken for none: where your formula without drag takes over, its digits do not do"


def drag_hint(states, call):
    """What to say of a path with very little drag that has lost digits."""
    parabola = right(*call.args, **{**call.kwargs, "drag": 0.0})
    if call.kwargs["drag"] and np.all(np.abs(states - parabola) <= CLOSED * size(call, parabola)):
        return TAKEN_FOR_NONE
    return "1 - e^-s is a difference of nearly equal numbers (see numpy.expm1); so is y"


def judge_great_drag(student, draw):
    """Times c t/m up to a thousand or two: beyond 709, e^s is more than any number."""
    (speed, angle), known = launch(draw), parameters(draw)
    t = uneven(draw, draw.uniform(1000, 2000) * known["mass"] / known["drag"], 20, 0.0)
    call = given(t, speed, angle, **known)
    judge_states(
        student.on("great drag").trajectory.many([call]),
        [(call, right(*call.args, **known))],
        CLOSED,
        "great drag",
        "e^-s goes to nothing, e^s beyond all numbers",
    )


def landing(speed, angle, *, mass, drag, gravity):
    """Time back at launch height, and the state then."""
    vy = speed * math.sin(angle)
    lift = drag * vy / (mass * gravity)

    def height(q):
        mean, late = means(q * lift)
        return mean - q * late

    time = brentq(height, 0.9, 2.1, xtol=1e-15, rtol=1e-15) * vy / gravity
    return time, right(np.array([time]), speed, angle, mass=mass, drag=drag, gravity=gravity)[0]


@once
def landings(draw, drags, angles=None):
    """Calls with random launches, the time of the landing, and its x."""
    cases = []
    for i, drag in enumerate(drags):
        (speed, angle), known = launch(draw), parameters(draw, **({} if drag is None else {"drag": drag}))
        cases.append(landed(given(speed, angle if angles is None else angles[i], **known)))
    return cases


@once
def light_landings(draw):
    """As `landings`, of light particles."""
    return [landed(given(*launch(draw), **light_particle(draw))) for _ in range(2)]


@once
def landings_with_little_drag(draw):
    """As `landings`: no drag, and b = c vy/(m g) below 1e-2, most often where Lambert's W is off by 1e-16/b^2."""
    lifts = [0.0, *10.0 ** draw.uniform(-16, -8, 4), *10.0 ** draw.uniform(-5, -2, 6)]
    lifts += [*10.0 ** ((np.arange(12) + draw.uniform(0, 1, 12)) / 4 - 8)]
    return [landing_of_lift(draw, lift) for lift in lifts]


@once
def landings_with_great_drag(draw):
    """As `landings`: c vy/(m g) from ten to a million; from 709 on, e^s is more than any number."""
    return [landing_of_lift(draw, lift) for lift in 10.0 ** draw.uniform((1, 3, 3, 4), (3, 4, 4, 6))]


def landing_of_lift(draw, lift):
    """One of `landings` with this lift, b = c vy/(m g)."""
    (speed, angle), known = launch(draw), parameters(draw)
    known["drag"] = lift * known["mass"] * known["gravity"] / (speed * math.sin(angle))
    return landed(given(speed, angle, **known))


def landed(call):
    """A call, the time of its landing, and its x then."""
    time, state = landing(*call.args, **call.kwargs)
    return call, time, state[0]


@once
def alike_landings(draw):
    """As `landings`, all like the first of them but for one parameter; each call has its kind."""
    start, known = launch(draw), parameters(draw)
    cases = [landed(given(*start, **known).on("a random launch"))]
    for name, value in known.items():
        call = given(*start, **{**known, name: 1.4 * value})
        cases.append(landed(call.on(f"a launch like the one before but for its {name}")))
    return cases


TIME, RANGE = (1, "the flight time"), (2, "the range")


def judge_landings(function, what, cases, kind, hint):
    """Compare TIME or RANGE with those of `landings`; `kind` is the kind of all, or tells it of a call."""
    (column, of), kind_of = what, kind if callable(kind) else lambda call: kind
    found = function.many([case[0].on(kind_of(case[0])) for case in cases])
    for value, case in zip(found, cases, strict=True):
        upright = case[0].args[1] == math.pi / 2 and what == RANGE  # and zero, but for rounding
        scale = case[0].args[0] * case[1] if upright else case[column]
        expect(
            value,
            case[column],
            within=ROOT,
            scale=scale,
            of=of,
            kind=kind_of(case[0]),
            at=case[0],
            hint=partial(landing_hint, value, what, case[0], hint),
            unit="of the speed times the flight time" if upright else "of itself",
        )


def landing_hint(value, what, call, hint):
    """What to say of a flight time or range that is that without drag, where there is little, or of no range."""
    speed, angle, known = *call.args, call.kwargs
    time = drag_free(speed, angle, **known)
    flown = right(np.array([time]), speed, angle, **known)[0, 0]
    without = (time,) if what == TIME else (range_without_drag(speed, angle, **known), flown)
    little = 0 < known["drag"] * speed < NEARLY * known["mass"] * known["gravity"]
    if little and any(math.isclose(value, one, rel_tol=CLOSED) for one in without):
        return TAKEN_FOR_NONE
    if what == RANGE and angle != math.pi / 2 and abs(value) <= CLOSED * speed * time:
        return "it is zero: does your trajectory count its times from the first that it is asked for?"
    return hint


def direction_of(call):
    """What to call a launch by its angle and drag."""
    names = {math.pi / 2: "a launch straight up", math.pi / 4: "a launch at 45 degrees", 1.0: "whole numbers"}
    return names.get(call.args[1], "a nearly flat launch") + (", no drag" if call.kwargs["drag"] == 0 else "")


def drag_of(call):
    """What to call a launch by its drag."""
    return "very little drag" if call.kwargs["drag"] else "no drag"


def plain_landings(draw):
    """As `landings`: straight up, at 45 degrees, nearly flat, each with drag and without; and whole numbers."""
    angles = (math.pi / 2, math.pi / 4, 0.01)
    cases = landings(draw, (None,) * 3, angles) + landings(draw, (0.0,) * 3, angles)
    for speed, angle, drag in ((1.0, 1.0, 1.0), (2.0, 1.0, 0.0), (1.0, math.pi / 2, 1.0)):
        cases.append(landed(given(speed, angle, mass=1.0, drag=drag, gravity=1.0)))
    return cases


def drag_free(speed, angle, *, gravity, **_):
    return 2 * speed * math.sin(angle) / gravity


def range_without_drag(speed, angle, **known):
    return speed * math.cos(angle) * drag_free(speed, angle, **known)


def range_of_wrong_decay(decay):
    """The range with decay(c T/m, c T), of a flight time T that is right, for (1 - e^(-c T/m))/(c T/m)."""

    def wrong(speed, angle, *, mass, drag, gravity):
        time, _ = landing(speed, angle, mass=mass, drag=drag, gravity=gravity)
        return speed * math.cos(angle) * time * float(decay(drag / mass * time, drag * time))

    return wrong


TIME_SUSPECTS = [
    suspect("the flight time without drag, or with drag on the horizontal component alone", flight_time=drag_free),
    suspect(
        "twice the time to the top; the way down takes longer than the way up",
        flight_time=lambda speed, angle, *, mass, drag, gravity: (
            2 * mass / drag * math.log1p(drag * speed * math.sin(angle) / (mass * gravity))
        ),
    ),
    suspect(
        "the drag force not divided by the mass",
        flight_time=lambda *launch, mass, **known: landing(*launch, mass=1.0, **known)[0],
    ),
]
RANGE_SUSPECTS = [
    suspect("the range without drag", horizontal_range=range_without_drag),
    suspect(
        "drag on the vertical component alone",
        horizontal_range=lambda speed, angle, **known: speed * math.cos(angle) * landing(speed, angle, **known)[0],
    ),
    suspect(
        "the flight time without drag, or drag on the horizontal component alone",
        horizontal_range=lambda speed, angle, **known: faded(1, 0)(
            np.array([drag_free(speed, angle, **known)]), speed, angle, **known
        )[0, 0],
    ),
    suspect(
        "the drag force not divided by the mass",
        horizontal_range=lambda *launch, mass, **known: landing(*launch, mass=1.0, **known)[1][0],
    ),
    suspect(
        "the drag force not divided by the mass in x, where it is in the flight time",
        horizontal_range=range_of_wrong_decay(lambda s, of_unit_mass: means(of_unit_mass)[0]),
    ),
    suspect(
        "the exponent not divided by the mass",
        horizontal_range=range_of_wrong_decay(lambda s, of_unit_mass: -math.expm1(-of_unit_mass) / s if s else 1.0),
    ),
]


@check(points=0.75, part="c", suspects=TIME_SUSPECTS)
def flight_ends_at_launch_height(student, draw):
    """flight_time is when y is zero again."""
    cases = landings(draw, (None,) * 12)
    judge_landings(
        student.flight_time, TIME, cases, "a random launch", "put the time into the y of your closed form; is it zero?"
    )
    judge_landings(
        student.flight_time, TIME, plain_landings(draw), direction_of, "does it hold without drag, and straight up?"
    )


@check(points=0.5, part="c", after=flight_ends_at_launch_height)
def flight_time_with_hardly_any_drag(student, draw):
    """flight_time goes over into 2 v sin(angle)/g without losing its digits."""
    judge_landings(
        student.flight_time,
        TIME,
        landings_with_little_drag(draw),
        drag_of,
        "near its branch point Lambert's W has half of its digits only; "
        "a step of Newton's method, on an equation that is good without drag, brings them back",
    )


@check(points=0.25, part="c", after=flight_ends_at_launch_height)
def flight_time_with_great_drag_and_straight_up(student, draw):
    """flight_time holds straight up and nearly flat, with drag a thousand times the weight, for light particles."""
    # the last takes 3e-6 s, of which a root good to 2e-12 s, as brentq's are, is off by less than ROOT; b is 1
    flattest = landed(given(2.0, 1e-6, mass=1.0, drag=5e5, gravity=1.0))
    judge_landings(
        student.flight_time,
        TIME,
        [*landings(draw, (None,) * 2, (math.pi / 2, 1e-3)), flattest],
        direction_of,
        "does a search for the root step over a flight that is short, or end at t = 0?",
    )
    judge_landings(
        student.flight_time,
        TIME,
        landings_with_great_drag(draw),
        "great drag",
        "what is left of the equation when e^-s is nothing?",
    )
    judge_landings(student.flight_time, TIME, light_landings(draw), LIGHT, SMALL_BESIDE)
    judge_landings(student.flight_time, TIME, alike_landings(draw), attrgetter("kind"), KEPT)


@check(points=0.5, part="c", suspects=RANGE_SUSPECTS)
def range_is_where_it_lands(student, draw):
    """horizontal_range is x at the flight time."""
    cases = landings(draw, (None,) * 12)
    judge_landings(
        student.horizontal_range, RANGE, cases, "a random launch", "put the flight time into the x of your closed form"
    )
    judge_landings(
        student.horizontal_range,
        RANGE,
        plain_landings(draw),
        direction_of,
        "does it hold without drag, and straight up?",
    )


def by_a_difference(speed, angle, *, mass, drag, gravity):
    """The range by 1 - e^-s, which little drag leaves few digits, and the same few whoever computes it."""
    time, (x, *_) = landing(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * mass / drag * (1 - math.exp(-drag * time / mass)) if drag else x


DIGITS_SUSPECTS = [suspect("1 - e^-s as a difference, which loses digits", horizontal_range=by_a_difference)]


@check(points=0.5, part="c", after=range_is_where_it_lands, suspects=DIGITS_SUSPECTS)
def range_with_hardly_any_drag(student, draw):
    """horizontal_range goes over into v^2 sin(2 angle)/g without losing its digits; it holds with great drag, too."""
    judge_landings(
        student.horizontal_range,
        RANGE,
        landings_with_little_drag(draw),
        drag_of,
        "is it the time or x that has lost its digits?",
    )
    judge_landings(student.horizontal_range, RANGE, light_landings(draw), LIGHT, SMALL_BESIDE)
    judge_landings(
        student.horizontal_range,
        RANGE,
        landings_with_great_drag(draw),
        "great drag",
        "e^-s goes to nothing, e^s beyond all numbers",
    )
    judge_landings(student.horizontal_range, RANGE, alike_landings(draw), attrgetter("kind"), KEPT)


def best(swiftness):
    """The angle of the largest range, for swiftness = c v/(m g): it lands at right angles to the launch.

    The derivative of the range by the angle is x_a - x_t y_a/y_t with (x_a, y_a) along (-vy, vx) of the launch and
    (x_t, y_t) the velocity at the landing.
    """

    def cosine(log_angle):
        angle = math.exp(log_angle)
        _, (_, _, vx, vy) = landing(swiftness, angle, mass=1.0, drag=1.0, gravity=1.0)
        return (math.cos(angle) * vx + math.sin(angle) * vy) / swiftness

    return math.exp(brentq(cosine, math.log(1e-10), math.log(1.0), xtol=1e-14))


@once
def best_angles(draw, swiftnesses, special=parameters):
    """Calls for the best angle, and that angle, with parameters as `special` draws them."""
    cases = []
    for swiftness in swiftnesses:
        known = special(draw)
        speed = swiftness * known["mass"] * known["gravity"] / known["drag"]
        cases.append((given(speed, **known), best(swiftness)))
    return cases


def best_angle_of_whole_numbers():
    """As `best_angles`: at the terminal speed, and at twice that."""
    known = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
    return [(given(speed, **known), best(speed)) for speed in (1.0, 2.0)]


BEST_SUSPECTS = [
    suspect("45 degrees always, which holds without drag alone", best_angle=lambda *_, **__: math.pi / 4),
    suspect(
        "an angle in degrees",
        best_angle=lambda speed, *, mass, drag, gravity: math.degrees(best(drag * speed / (mass * gravity))),
    ),
    suspect(
        "the drag force not divided by the mass",
        best_angle=lambda speed, *, mass, drag, gravity: best(drag * speed / gravity),
    ),
]


@check(points=0.75, part="a", suspects=BEST_SUSPECTS)
def best_angle_has_the_largest_range(student, draw):
    """best_angle maximises the range, for speeds below and above the terminal speed."""
    cases = best_angles(draw, tuple(10.0 ** draw.uniform(-1, 2, 6))) + best_angle_of_whole_numbers()
    kind = "a speed from a tenth to a hundred times the terminal speed"
    found = student.best_angle.many([call.on(kind) for call, _ in cases])
    near = np.abs(np.subtract(found, [expected for _, expected in cases])).max() <= NEAR
    hint = (
        "near its largest the range is flat, and a search stops early: solve for where its derivative vanishes"
        if near
        else "is your horizontal_range right? compute it a little above and below your angle: both must be smaller"
    )
    for angle, (call, expected) in zip(found, cases, strict=True):
        expect(angle, expected, within=ANGLE, of="the best angle", unit="rad", at=call, hint=hint, kind=kind)


@check(points=0.25, part="a", after=best_angle_has_the_largest_range)
def best_angle_is_45_degrees_without_drag(student, draw):
    """best_angle is 45 degrees at no drag, and leaves them as the drag grows beside the weight."""
    calls = [given(launch(draw)[0], **parameters(draw, drag=drag)) for drag in (0.0, 1e-12, 1e-10)]
    for angle, call in zip(student.best_angle.many([call.on(drag_of(call)) for call in calls]), calls, strict=True):
        expect(
            angle,
            math.pi / 4,
            within=ANGLE,
            of="the best angle",
            unit="rad",
            at=call,
            kind=drag_of(call),
            hint="does your equation for the angle still hold when drag is zero?",
        )
    # the third is always from .007 to .01, where a series of first order in the drag is off by 5e-6 and more
    cases = best_angles(draw, tuple(10.0 ** (draw.uniform(0, 1, 4) * [2, 1, 0.15, 1] - [6, 4, 2.16, 2])))
    kind = "a speed below a tenth of the terminal speed"
    found = student.best_angle.many([call.on(kind) for call, _ in cases])
    for angle, (call, expected) in zip(found, cases, strict=True):
        expect(
            angle,
            expected,
            within=ANGLE,
            of="the best angle",
            unit="rad",
            at=call,
            kind=kind,
            hint=partial(slow_hint, angle, call),
        )
    for special, kind in SPECIAL:
        cases = best_angles(draw, tuple(10.0 ** draw.uniform(-0.3, 0.3, 2)), special)
        found = student.best_angle.many([call.on(kind) for call, _ in cases])
        for angle, (call, expected) in zip(found, cases, strict=True):
            expect(
                angle, expected, within=ANGLE, of="the best angle", unit="rad", at=call, kind=kind, hint=SMALL_BESIDE
            )
    calls = [given(call.args[0], **call.kwargs).on(call.kind) for call, *_ in alike_landings(draw)]
    for angle, call in zip(student.best_angle.many(calls), calls, strict=True):
        swiftness = call.kwargs["drag"] * call.args[0] / (call.kwargs["mass"] * call.kwargs["gravity"])
        expect(
            angle, best(swiftness), within=ANGLE, of="the best angle", unit="rad", at=call, kind=call.kind, hint=KEPT
        )


def where_little_pulls(draw):
    """Parameters for which speeds about the terminal one are small in m/s."""
    return parameters(draw, gravity=10 ** draw.uniform(-3, -2))


SPECIAL = (light_particle, LIGHT), (where_little_pulls, "a slow launch where gravity is weak")


def slow_hint(angle, call):
    """What to say of a best angle that is wrong at a speed far below the terminal speed."""
    swiftness = call.kwargs["drag"] * call.args[0] / (call.kwargs["mass"] * call.kwargs["gravity"])
    if abs(angle - math.pi / 4) <= ANGLE:
        return "45 degrees are for no drag: the angle falls in proportion to the drag, however little"
    if abs(angle - math.pi / 4 + math.sqrt(2) / 6 * swiftness) <= CLOSED:
        return "it is a series of first order in the drag, used where its next term counts"
    return "does the range, or your equation for the angle, keep its digits?"


@check(points=0.5, part="a", after=best_angle_has_the_largest_range)
def best_angle_at_a_huge_speed(student, draw):
    """best_angle goes to zero as the speed grows, and stays good to 1 % of itself."""
    # minimising the range on a logarithmic scale is good to 1e-4 of the angle up to 1e6 terminal speeds, not at 1e7
    cases = best_angles(draw, tuple(10.0 ** draw.uniform(4, 6, 5)))
    found = student.best_angle.many([call.on("a huge speed") for call, _ in cases])
    for angle, (call, expected) in zip(found, cases, strict=True):
        expect(
            angle / expected,
            1.0,
            within=SWIFT,
            of="the best angle",
            unit="of itself",
            at=call,
            kind="a huge speed",
            hint="the largest range is very flat there: solve for where its derivative vanishes, and for a small "
            "angle look on a logarithmic scale",
        )


def fast_corners(angle):
    """Corners of the path at a speed of 1e12 times the terminal speed: launch, end of the drag's work, landing."""
    speed, known = 1e12, {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
    times = np.array([0.0, 40.0, speed * math.sin(angle)])  # e^-40 is nothing, and 40/1e12 too
    return right(times, speed, angle, **known)[:, :2] / speed


def corners(*points):
    """A wrong limit_shape with these corners; each takes cosine and sine of the angle."""
    return lambda angle: np.array([point(math.cos(angle), math.sin(angle)) for point in points], float)


def start(c, s):
    return 0, 0


SHAPE_SUSPECTS = [
    suspect(
        "a parabola, as if the drag did not matter at high speed",
        limit_shape=corners(start, lambda c, s: (c * s, s * s / 2), lambda c, s: (2 * c * s, 0)),
    ),
    suspect(
        "a path as long on its way down as up", limit_shape=corners(start, lambda c, s: (c, s), lambda c, s: (2 * c, 0))
    ),
    suspect(
        "a landing as far from the launch as the top corner is: it falls straight down from there",
        limit_shape=corners(start, lambda c, s: (c, s), lambda c, s: (1, 0)),
    ),
    suspect(
        "a top corner at the height cos(angle) sin(angle): it is as far along the launch as the speed carries it",
        limit_shape=corners(start, lambda c, s: (c, c * s), lambda c, s: (c, 0)),
    ),
    suspect(
        "the corners from the landing to the launch",
        limit_shape=corners(lambda c, s: (c, 0), lambda c, s: (c, s), start),
    ),
    suspect(
        "the angle measured from the vertical", limit_shape=corners(start, lambda c, s: (s, c), lambda c, s: (s, 0))
    ),
]


@check(points=1, part="b", suspects=SHAPE_SUSPECTS)
def path_at_a_huge_speed_has_the_limit_shape(student, draw):
    """limit_shape has the corners that a path has at a speed of 1e12 terminal speeds."""
    angles = [*draw.uniform(0.1, 1.5, 6), math.pi / 2, math.pi / 4, math.pi / 3, 1.0, 0.01]
    for found, angle in zip(student.limit_shape.many([given(angle) for angle in angles]), angles, strict=True):
        expect(
            found,
            fast_corners(angle),
            within=CORNER,
            of="a corner",
            unit="m v/c",
            at=angle,
            kind="a random angle",
            hint="plot your closed form at 10, 100 and 1000 times the terminal speed, in units of m v/c; launch and "
            "return to launch height are corners too",
        )


@check(points=0.5, part="e")
def both_paths_are_drawn(student, draw):
    """plot_comparison draws both paths from t[0] to t[-1] on the same axes, at the same scale."""
    known, angle = parameters(draw), draw.uniform(0.5, 1.2)
    # visibly no straight line, and no parabola: some terminal speeds
    speed = draw.uniform(1.5, 5) * known["mass"] * known["gravity"] / known["drag"]
    duration = max(2.5 * known["mass"] / known["drag"], 1.2 * landing(speed, angle, **known)[0])
    t = np.linspace(0.0, duration, SAMPLES)
    picture = student.plot_comparison.draw(t, speed, angle, **known)
    expect_that(
        len(picture.lines) == 2,
        f"there are {len(picture.lines)} curves on the axes, not two",
        hint="fewer than ten points are no curve",
    )
    fine = right(np.linspace(0.0, t[-1], FINE), speed, angle, **known)[:, :2]
    for line in picture.lines:
        path = along(line, fine)
        judge_path(path, fine, partial(end_hint, path, fine, t))
    judge_axes_of_lengths(picture)
    one, other = (line.points for line in picture.lines)
    if np.array_equal(one, other):
        judge_twins(student, given(t, speed, angle, **known))


def judge_twins(student, call):
    """Two curves of the same numbers, to the last bit, are one drawn twice, unless simulate and trajectory agree so."""
    try:
        (simulated,), (closed,) = student.simulate.many([call]), student.trajectory.many([call])
    except Failed:  # of which their own checks tell
        return
    expect_that(
        np.array_equal(simulated, closed),
        "both curves are the same numbers, to the last bit",
        hint="is one that of simulate, and the other that of trajectory?",
    )


def end_hint(path, fine, t):
    """What to say of a curve with a wrong end."""
    near = DRAWN * np.abs(fine).max()

    def at(points, others):
        return np.abs(points - others).max() <= near

    if at(path[-1], [t[-1], fine[-1, 1]]):
        return "a path is y over x, not over the time"
    if at(path[[0, -1], ::-1], fine[[0, -1]]):
        return "x and y are swapped: x to the right, y up"
    if at(path[0], fine[0]):
        return "it begins right: do simulate and trajectory pass their checks, does the curve end at t[-1]?"
    return "draw from t[0] to t[-1]"


def judge_path(path, fine, ends):
    """A line must begin and end where the motion does, and each have all of its points next to the other."""
    scale = np.abs(fine).max()
    expect(
        path[[0, -1]],
        fine[[0, -1]],
        within=DRAWN,
        scale=scale,
        of="an end of a curve",
        unit="of the path's size",
        hint=ends,
    )
    for points, polygon, of, within in (
        (path, fine, "a curve", DRAWN),
        (fine[::5], path, "a point of the motion", PASSED),
    ):
        expect(
            distances(points, polygon),
            0.0,
            within=within,
            scale=scale,
            of=of,
            unit="of the path's size",
            hint="x to the right, y up",
        )
