"""Hidden inputs of hw06: cars, their states and motions."""

import math

import numpy as np

from tam570_grader import given, in_turn, uneven

from .right import stopped, wheelbase

LOAD = ("mass", "front", "rear", "gravity")
FORCE = ("mass", "front", "rear", "friction", "gravity")
BODY = ("mass", "yaw_inertia", "front", "rear")
ALL = (*BODY, "friction", "gravity")
CRITICAL = ("front", "rear", "friction", "gravity")
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


def state(draw, car, speed, yaw):
    """Anywhere, a heading not within a turn of zero; speed and yaw, either way, in the car's usual ones."""
    heading = draw.choice([draw.uniform(-10, -3.3), draw.uniform(6.5, 10)])  # wrapped, it is another
    rates = draw.uniform(*speed) * usual(car), draw.choice([-1, 1]) * draw.uniform(*yaw) * usual(car) / wheelbase(car)
    return np.array([*draw.uniform(-5, 5, 2), heading, *rates])


def _cased(kind, s, locked, known, names):
    return given(s, locked, **{name: known[name] for name in names}).on(f"{kind}, a locked {locked} axle")


def ways(draw, names, kinds=WAYS, count=3, **fixed):
    """States that move in these ways, of cars with either axle locked."""
    cases = []
    for kind in kinds:
        for locked in AXLES * count:
            known = car(draw, **fixed)
            cases.append(_cased(kind, state(draw, known, *WAYS[kind]), locked, known, names))
    return cases


def odd(draw, names):
    """Odd cars, and headings along the axes and beyond a turn, with G at the origin."""
    cases = []
    for kind, fixed in ODD_CARS.items():
        cases += [case.on(f"{kind}, {case.kind}") for case in ways(draw, names, ONWARDS, 1, **fixed)]
    for heading in (0.0, math.pi / 2, math.pi, -math.pi / 2, 9.0, -20.0):
        for case in ways(draw, names, ("a car that goes forwards and turns", "straight motion in reverse"), 1):
            case.args[0][:3] = 0.0, 0.0, heading
            cases.append(case.on(f"G at the origin, heading {heading:.3g}, {case.kind}"))
    return cases


def odd_cars(draw):
    """(locked, car, kind): random cars, and odd ones."""
    random = [(locked, car(draw), "a random car") for locked in AXLES * 6]
    return random + [(locked, car(draw, **fixed), kind) for kind, fixed in ODD_CARS.items() for locked in AXLES]


def creeping(draw, names):
    """The locked axle moves at a micrometre to a millimetre a second, any way."""
    cases = []
    for locked in AXLES:
        for size in (1e-6, 3e-5, 1e-3):
            known = car(draw)
            s, v, way = state(draw, known, *WAYS["a car at rest"]), size * draw.uniform(0.6, 1), draw.uniform(-3, 3)
            s[3:] = v * math.cos(way), v * math.sin(way) / wheelbase(known)
            cases.append(_cased("a locked axle at 1 mm/s or less", s, locked, known, names))
    return cases


def hardly_moving(draw, names):
    """Speed and yaw rate below 1e-8, which np.allclose takes for zero."""
    cases = []
    for locked in AXLES:
        known = car(draw)
        s = state(draw, known, *WAYS["a car at rest"])
        s[3:] = 8e-9 * draw.choice([-1, 1], 2)
        cases.append(_cased("speed and yaw rate 8e-9, which are not zero", s, locked, known, names))
    return cases


def loads(draw):
    return [
        given(locked, **{name: known[name] for name in LOAD}).on(f"{kind}, a locked {locked} axle")
        for locked, known, kind in odd_cars(draw)
    ]


def at_speeds(draw):
    """For yaw_growth_rate: low and high speeds."""
    cases = [
        given(draw.uniform(0.3, 3) * usual(known), locked, **known).on(f"{kind}, a locked {locked} axle")
        for locked, known, kind in odd_cars(draw)
    ]
    ones = ODD_CARS["all parameters 1"]
    return cases + [given(1.0, locked, **ones).on(f"all 1, a locked {locked} axle") for locked in AXLES]


def criticals(draw, locked):
    known = [(one, kind) for axle, one, kind in odd_cars(draw) if axle == locked]
    kind_of = "{}, a locked " + locked + " axle"
    return [given(locked, **{name: one[name] for name in CRITICAL}).on(kind_of.format(kind)) for one, kind in known]


def slowing(draw):
    """For small_yaw_rate: any speeds, and speeds that have not fallen yet, no yaw rate."""
    cases = []
    for locked in AXLES * 4:
        known = car(draw)
        speed0 = draw.uniform(0.7, 1.8) * usual(known)
        yaw = draw.choice([-1, 1]) * draw.uniform(0.01, 2)
        cases.append(given(draw.uniform(0.1, 0.7) * speed0, speed0, yaw, locked, **known).on("a random car"))
    plain = [(locked, one, kind) for locked, one, kind in odd_cars(draw)[12:] if one["friction"] * one["gravity"]]
    for locked, known, kind in plain:
        v = usual(known)
        for fast, slow, yaw in ((1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.5, 1.0)):
            cases.append(
                given(slow * v, fast * v, yaw, locked, **known).on(f"{kind}, speed/speed0 = {slow / fast:.2g}")
            )
        cases.append(given(1.0, 2.0, -1.0, locked, **known).on(f"{kind}, a negative yaw rate"))
    return [case.on(f"{case.kind}, a locked {case.args[3]} axle") for case in cases]


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
    for kind, (speed, yaw, fixed) in kinds.items():
        for locked in AXLES:
            known = car(draw, **fixed)
            start = state(draw, known, speed, yaw)
            start[:3] *= draw.integers(0, 2)  # from the origin along x, or from anywhere
            v = abs(start[3]) + abs(start[4]) * wheelbase(known)
            brakes = known["friction"] * known["gravity"]
            t = uneven(draw, 0.3 * stopped(start, locked, known)[0] if brakes else wheelbase(known) / v, 2)
            cases.append(given(t, start, locked, **known).on(f"{kind}, a locked {locked} axle"))
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
    return [
        given(t, start, locked, **known).on(f"a car at rest from the start, a locked {locked} axle") for locked in AXLES
    ]
