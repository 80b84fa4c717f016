"""Hidden inputs of hw06: cars, their states and motions."""

import itertools
import math

import numpy as np

from tam570_grader import given, in_turn, uneven

from .right import stopped, wheelbase

ALL = ("mass", "yaw_inertia", "front", "rear", "friction", "gravity")
TAKES = {
    "axle_load": ("mass", "front", "rear", "gravity"),
    "friction_force": ("mass", "front", "rear", "friction", "gravity"),
    "kinetic_energy": ("mass", "yaw_inertia", "front", "rear"),
    "critical_speed": ("front", "rear", "friction", "gravity"),
}  # function: its parameters, if it takes not all of them
AXLES = ("front", "rear")
ODD_CARS = {
    "G half way between the axles": {"front": 1.2, "rear": 1.2},
    "all parameters 1": dict.fromkeys(ALL, 1.0),
    "friction 0": {"friction": 0.0},
    "gravity 0": {"gravity": 0.0},
    "friction and gravity 0": {"friction": 0.0, "gravity": 0.0},
    "friction above 1": {"friction": 1.6},
}
OTHERS = ("both", "", "Front", "r", "front rear", None)
# ways to move: (speed, yaw rate) in the car's usual ones
FORWARDS, REVERSE, QUICK, TURNING, LITTLE, NONE = (0.3, 2), (-2, -0.3), (1, 2), (0.3, 2), (0.2, 0.5), (0, 0)
WAYS = {
    "a car that goes forwards and turns": (FORWARDS, TURNING),
    "a car in reverse": (REVERSE, TURNING),
    "a car that turns about its free axle on the spot": (NONE, TURNING),
    "straight motion": (FORWARDS, NONE),
    "straight motion in reverse": (REVERSE, NONE),
    "a car at rest": (NONE, NONE),
}
ONWARDS = [kind for kind in WAYS if "reverse" not in kind]


def car(draw, **fixed):
    mass, (front, rear) = 10 ** draw.uniform(0.5, 3.3), draw.uniform(0.3, 2, 2)
    front, rear = fixed.get("front", front), fixed.get("rear", rear)
    drawn = {
        "mass": mass,
        "yaw_inertia": mass * front * rear * draw.uniform(0.4, 2),
        "front": front,
        "rear": rear,
        "friction": draw.uniform(0.2, 1),
        "gravity": draw.uniform(2, 20),
    }
    return {**drawn, **fixed}


def usual(car):
    """Size of speeds, m/s: friction stops it within about a wheelbase."""
    return math.sqrt(max(car["friction"] * car["gravity"], 0.2) * wheelbase(car))


def speed_of(state, car):
    """Of its speed and its turning, m/s."""
    return abs(state[3]) + abs(state[4]) * wheelbase(car)


def state(draw, car, speed, yaw):
    """Anywhere, a heading not within a turn of zero; speed and yaw, either way, in the car's usual ones."""
    heading = draw.choice([draw.uniform(-10, -3.3), draw.uniform(6.5, 10)])  # wrapped, it is another
    rates = draw.uniform(*speed) * usual(car), draw.choice([-1, 1]) * draw.uniform(*yaw) * usual(car) / wheelbase(car)
    return np.array([*draw.uniform(-5, 5, 2), heading, *rates])


def call(name, known, locked, *first, kind=""):
    """A call of the function of this name; `locked` is its last argument in order."""
    taken = {one: known[one] for one in TAKES.get(name, ALL)}
    return given(*first, locked, **taken).on(f"{kind}, a locked {locked} axle")


def ways(draw, name, kinds=WAYS, count=3, **fixed):
    """States that move in these ways, of cars with either axle locked."""
    cases = []
    for kind, locked in itertools.product(kinds, AXLES * count):
        known = car(draw, **fixed)
        cases.append(call(name, known, locked, state(draw, known, *WAYS[kind]), kind=kind))
    return cases


def turning(draw, name, count):
    return ways(draw, name, ("a car that goes forwards and turns",), count)


def timed(calls):
    return [given(float(t), *case.args, **case.kwargs).on(case.kind) for t, case in enumerate(calls)]


def odd(draw, name):
    """Odd cars, and headings along the axes and beyond a turn, with G at the origin."""
    cases = []
    for kind, fixed in ODD_CARS.items():
        cases += [case.on(f"{kind}, {case.kind}") for case in ways(draw, name, ONWARDS, 1, **fixed)]
    for heading in (0.0, math.pi / 2, math.pi, -math.pi / 2, 9.0, -20.0):
        for case in ways(draw, name, ("a car that goes forwards and turns", "straight motion in reverse"), 1):
            case.args[0][:3] = 0.0, 0.0, heading
            cases.append(case.on(f"G at the origin, heading {heading:.3g}, {case.kind}"))
    return cases


def odd_cars(draw):
    """(locked, car, kind): random cars, and odd ones."""
    random = [(locked, car(draw), "a random car") for locked in AXLES * 6]
    return random + [(locked, car(draw, **fixed), kind) for kind, fixed in ODD_CARS.items() for locked in AXLES]


def creeping(draw, name):
    """The locked axle moves at a micrometre to a millimetre a second, any way."""
    cases = []
    for locked, size in itertools.product(AXLES, (1e-6, 3e-5, 1e-3)):
        known = car(draw)
        s, v, way = state(draw, known, NONE, NONE), size * draw.uniform(0.6, 1), draw.uniform(-3, 3)
        s[3:] = v * math.cos(way), v * math.sin(way) / wheelbase(known)
        cases.append(call(name, known, locked, s, kind="a locked axle at 1 mm/s or less"))
    return cases


def hardly_moving(draw, name):
    """Speed and yaw rate below 1e-8, which np.allclose takes for zero."""
    cases = []
    for locked in AXLES:
        known = car(draw)
        s = state(draw, known, NONE, NONE)
        s[3:] = 8e-9 * draw.choice([-1, 1], 2)
        cases.append(call(name, known, locked, s, kind="speed and yaw rate 8e-9, which are not zero"))
    return cases


def loads(draw):
    return [call("axle_load", known, locked, kind=kind) for locked, known, kind in odd_cars(draw)]


def at_speeds(draw):
    """For yaw_growth_rate: low and high speeds."""
    name, ones = "yaw_growth_rate", ODD_CARS["all parameters 1"]
    speeds = ((draw.uniform(0.3, 3) * usual(known), known, locked, kind) for locked, known, kind in odd_cars(draw))
    cases = [call(name, known, locked, speed, kind=kind) for speed, known, locked, kind in speeds]
    return cases + [call(name, ones, locked, 1.0, kind="all 1") for locked in AXLES]


def criticals(draw, locked):
    return [call("critical_speed", known, locked, kind=kind) for one, known, kind in odd_cars(draw) if one == locked]


def slowing(draw):
    """For small_yaw_rate: any speeds, and speeds that have not fallen yet, no yaw rate."""
    name, cases = "small_yaw_rate", []
    for locked in AXLES * 4:
        known = car(draw)
        speed0, yaw = draw.uniform(0.7, 1.8) * usual(known), draw.choice([-1, 1]) * draw.uniform(0.01, 2)
        cases.append(call(name, known, locked, draw.uniform(0.1, 0.7) * speed0, speed0, yaw, kind="a random car"))
    plain = [(locked, one, kind) for locked, one, kind in odd_cars(draw)[12:] if one["friction"] * one["gravity"]]
    for locked, known, kind in plain:
        v = usual(known)
        for fast, slow, yaw in ((1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.5, 1.0)):
            fallen = f"{kind}, speed/speed0 = {slow / fast:.2g}"
            cases.append(call(name, known, locked, slow * v, fast * v, yaw, kind=fallen))
        cases.append(call(name, known, locked, 1.0, 2.0, -1.0, kind=f"{kind}, a negative yaw rate"))
    return cases


# For refusals: call(name, locked) of each function


def of_mechanics(draw, moving):
    known, t = car(draw), np.array([0.0, 1e-3])
    s = state(draw, known, (1, 1), (0.5, 0.5)) if moving else state(draw, known, NONE, NONE)
    first = {"axle_load": (), "state_derivative": (0.0, s), "simulate": (t, s)}
    return lambda name, locked: call(name, known, locked, *first.get(name, (s,)))


def of_stability(draw):
    known, first = car(draw), {"yaw_growth_rate": (2.0,), "critical_speed": (), "small_yaw_rate": (1.0, 2.0, 0.1)}
    return lambda name, locked: call(name, known, locked, *first[name])


# Motions


def runs(draw, count):
    """Braking, each until before the speed passes zero; a rear axle that is locked swings round, and so backwards."""
    cases = []
    for locked, speed, share, kind in (
        ("front", QUICK, 0.75, ""),
        ("rear", QUICK, 0.2, ""),
        ("rear", (-2, -1), 0.75, " in reverse"),
    ):
        known = car(draw)
        start = state(draw, known, speed, LITTLE)
        t = uneven(draw, share * stopped(start, locked, known)[0], count)
        cases.append(given(t, start, locked, **known).on(f"a locked {locked} axle{kind}"))
    return cases


def few_times(draw):
    """Few times, plain runs at two times, a small yaw rate above the critical speed, what is kept between calls."""
    cases = [*runs(draw, 4), *_plain(draw, BRAKED), _nearly_straight(draw)]
    known = car(draw, friction=draw.uniform(1.2, 2))
    start, other = (state(draw, known, QUICK, LITTLE) for _ in range(2))
    # friction slows it by less than friction * gravity, so it does not stop before
    t = uneven(draw, 0.2 * usual(known) / (known["friction"] * known["gravity"]) * draw.uniform(0.8, 1), 4)
    first = given(t, start, "rear", **known)
    more = in_turn(draw, first, start=(other, "front"), mass=None, front=None, rear=None)
    return [*cases, first.on("friction above 1, a locked rear axle"), *more]


BRAKED = {
    "straight motion": (FORWARDS, NONE, {}),
    "straight motion in reverse": (REVERSE, NONE, {}),
    "a turn on the spot": (NONE, TURNING, {}),
    "all parameters 1": (QUICK, LITTLE, ODD_CARS["all parameters 1"]),
}
GLIDING = {
    "straight motion, friction 0": (FORWARDS, NONE, {"friction": 0.0}),
    "straight motion in reverse, gravity 0": (REVERSE, NONE, {"gravity": 0.0}),
    "a turn on the spot, friction 0": (NONE, TURNING, {"friction": 0.0}),
}


def _plain(draw, kinds):
    """Two times: straight on, or turning on the spot, slowed by friction or without it."""
    cases = []
    for (kind, (speed, yaw, fixed)), locked in itertools.product(kinds.items(), AXLES):
        known = car(draw, **fixed)
        start = state(draw, known, speed, yaw)
        start[:3] *= draw.integers(0, 2)  # from the origin along x, or from anywhere
        v = speed_of(start, known)
        brakes = known["friction"] * known["gravity"]
        t = uneven(draw, 0.3 * stopped(start, locked, known)[0] if brakes else wheelbase(known) / v, 2)
        cases.append(call("simulate", known, locked, t, start, kind=kind))
    return cases


def _nearly_straight(draw):
    """Above its critical speed a small yaw rate grows, and turns it by 1e-4 and more."""
    known = car(draw)
    start = state(draw, known, (1.5, 1.8), NONE)
    start[4] = draw.choice([-1, 1]) * draw.uniform(2e-4, 3e-4)
    t = uneven(draw, 0.7 * start[3] / (known["friction"] * known["gravity"]), 2)
    return given(t, start, "rear", **known).on("a small yaw rate, a locked rear axle")


def gliding(draw):
    """Without friction or gravity, with the free axle behind at first; fast, plain, and at a few mm/s."""
    cases = []
    for locked, speed, fixed in (("front", REVERSE, {"friction": 0.0}), ("rear", FORWARDS, {"gravity": 0.0})):
        known = car(draw, **fixed)
        start = state(draw, known, speed, (0.1, 0.3))
        t = uneven(draw, 8 * wheelbase(known) / abs(start[3]), 60)
        cases.append(given(t, start, locked, **known).on(f"{min(fixed)} 0, a locked {locked} axle"))
    return cases + _plain(draw, GLIDING)


def gliding_slowly(draw):
    cases = []
    for locked, sign, fixed in (("front", 1, {"friction": 0.0}), ("rear", -1, {"gravity": 0.0})):
        known = car(draw, **fixed)
        start = state(draw, known, NONE, NONE)
        start[3] = sign * draw.uniform(3e-3, 6e-3)  # m/s, above what may be called rest where there is friction
        start[4] = 0.5 * start[3] / wheelbase(known)
        t = uneven(draw, draw.uniform(10, 20), 4)
        cases.append(given(t, start, locked, **known).on(f"a slow car, {min(fixed)} 0, a locked {locked} axle"))
    return cases


def braking_slowly(draw):
    """A fortieth of the usual speed, well above what may be called rest."""
    cases = []
    for locked, share in (("front", 0.6), ("rear", 0.2)):
        known, slow = car(draw), draw.uniform(0.02, 0.03)
        start = state(draw, known, (slow, slow), tuple(slow * size for size in LITTLE))
        start[:2] = 0.0  # at 5 m a relative tolerance of 1e-9 would be 1e-5 of the way to the stop
        t = uneven(draw, share * stopped(start, locked, known)[0], 4)
        cases.append(given(t, start, locked, **known).on(f"a slow car, a locked {locked} axle"))
    return cases


def stops(draw):
    """Motions that go on beyond the stop."""
    cases = []
    for locked, speed, yaw, count, slippery, kind in (
        ("front", (0.7, 1.5), (0.2, 0.6), 40, 1.0, ""),
        ("rear", (-1.5, -0.7), (0.2, 0.6), 40, 1.0, ", in reverse"),
        ("rear", (0.7, 1.5), (0.2, 0.6), 2, 1.0, ", only two times"),
        ("rear", (0.05, 0.2), (0.8, 1.2), 30, 0.03, ", spinning on ice"),
        ("front", (0.05, 0.2), (0.8, 1.2), 2, 1.0, ", spinning, only two times"),
        ("rear", (0.7, 1.5), NONE, 20, 1.0, ", straight ahead"),
    ):
        known = car(draw)
        start = state(draw, known, speed, yaw)
        known["friction"] *= slippery
        latest, _ = stopped(start, locked, known)
        t = uneven(draw, latest * (draw.uniform(1.8, 2.5) if count > 2 else 1.12), count)
        cases.append(given(t, start, locked, **known).on(f"a car that stops, a locked {locked} axle{kind}"))
    return cases


def at_rest(draw):
    known, t = car(draw), uneven(draw, 3.0, 10)
    start = state(draw, known, NONE, NONE)
    kind = "a car at rest from the start"
    return [call("simulate", known, locked, t, start, kind=kind) for locked in AXLES]
