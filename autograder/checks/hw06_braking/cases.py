"""Hidden inputs of hw06: cars, their states and motions."""

import math
from itertools import chain

import numpy as np

from tam570_grader import given, in_turn, uneven

from .right import stopped, wheelbase

AXLES = ("front", "rear")
OTHERS = ("both", "", "Front", "r", "front rear", None)
ONES = dict.fromkeys(("mass", "yaw_inertia", "front", "rear", "friction", "gravity"), 1.0)
ODD_CARS = {
    "G half way between the axles": {"front": 1.2, "rear": 1.2},
    "all parameters 1": ONES,
    "friction 0": {"friction": 0.0},
    "gravity 0": {"gravity": 0.0},
    "friction and gravity 0": {"friction": 0.0, "gravity": 0.0},
    "friction above 1": {"friction": 1.6},
}
# ways to move: (speed, yaw rate) in the car's usual ones
FORWARDS, REVERSE, QUICK, TURNING, LITTLE, NONE = (0.3, 2), (-2, -0.3), (1, 2), (0.3, 2), (0.2, 0.5), (0, 0)
TURN, REST = "a car that goes forwards and turns", "a car at rest"
WAYS = {
    TURN: (FORWARDS, TURNING),
    "a car in reverse": (REVERSE, TURNING),
    "a car that turns about its free axle on the spot": (NONE, TURNING),
    "straight motion": (FORWARDS, NONE),
    "straight motion in reverse": (REVERSE, NONE),
    REST: (NONE, NONE),
}
MOVING = [kind for kind in WAYS if kind != REST]


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


def drag(car):
    """The deceleration by friction, m/s^2, and some where there is none."""
    return max(car["friction"] * car["gravity"], 0.2)


def usual(car):
    """Size of speeds, m/s: friction stops it within about a wheelbase."""
    return math.sqrt(drag(car) * wheelbase(car))


def speed_of(state, car):
    """Of its speed and its turning, m/s."""
    return abs(state[3]) + abs(state[4]) * wheelbase(car)


def state(draw, car, speed, yaw):
    """Anywhere, a heading not within a turn of zero; speed and yaw, either way, in the car's usual ones."""
    heading = draw.choice([draw.uniform(-10, -3.3), draw.uniform(6.5, 10)])  # wrapped, it is another
    rates = draw.uniform(*speed) * usual(car), draw.choice([-1, 1]) * draw.uniform(*yaw) * usual(car) / wheelbase(car)
    return np.array([*draw.uniform(-5, 5, 2), heading, *rates])


def call(kind, known, locked, *first):
    return given(*first, locked, **known).on(f"{kind}, a locked {locked} axle")


# Cases of functions of a state, for all of them: (state, locked, **car)


def moving(draw, kind, locked, **fixed):
    known = car(draw, **fixed)
    return call(kind, known, locked, state(draw, known, *WAYS[kind]))


def ways(*kinds, count=3, **fixed):
    """States that move in these ways, of cars with either axle locked."""
    return lambda draw: [moving(draw, kind, locked, **fixed) for kind in kinds for locked in AXLES * count]


def odd_cars(draw):
    kinds = [kind for kind in WAYS if "reverse" not in kind]
    return [
        case.on(f"{odd}, {case.kind}")
        for odd, fixed in ODD_CARS.items()
        for case in ways(*kinds, count=1, **fixed)(draw)
    ]


def headings(draw):
    """Along the axes and beyond a turn, with G at the origin."""
    cases = []
    for heading in (0.0, math.pi / 2, math.pi, -math.pi / 2, 9.0, -20.0):
        for case in ways(TURN, "straight motion in reverse", count=1)(draw):
            case.args[0][:3] = 0.0, 0.0, heading
            cases.append(case.on(f"G at the origin, heading {heading:.3g}, {case.kind}"))
    return cases


def creeping(kind, *speeds):
    """The locked axle moves at these speeds, m/s, any way."""

    def one(draw, locked, speed):
        known, way = car(draw), draw.uniform(-3, 3)
        rates = speed * math.cos(way), speed * math.sin(way) / wheelbase(known)
        return call(kind, known, locked, state(draw, known, NONE, NONE) + [0, 0, 0, *rates])

    return lambda draw: [one(draw, locked, speed) for locked in AXLES for speed in speeds]


slow = creeping("a locked axle at 1 mm/s or less", 1e-6, 3e-5, 1e-3)
hardly_moving = creeping("speed and yaw rate below 1e-8, which are not zero", 5e-9)  # np.allclose takes them for zero


def timed(*drawn):
    """The same with a time before the state."""
    return lambda draw: [
        given(float(t), *case.args, **case.kwargs).on(case.kind)
        for t, case in enumerate(chain.from_iterable(one(draw) for one in drawn))
    ]


# Functions without a state


def parked(draw):
    """(locked, **car): random cars, and odd ones."""
    random = [(car(draw), "a random car") for _ in range(6)]
    cars = random + [(car(draw, **fixed), kind) for kind, fixed in ODD_CARS.items()]
    return [call(kind, one, locked) for one, kind in cars for locked in AXLES]


def at_speeds(draw):
    """(speed, locked, **car): low and high speeds."""
    return [
        given(draw.uniform(0.3, 3) * usual(one.kwargs), *one.args, **one.kwargs).on(one.kind) for one in parked(draw)
    ]


def slowing(draw):
    """(speed, speed0, yaw_rate0, locked, **car): any speeds, and speeds that have not fallen yet, no yaw rate."""
    cases = []
    for one in parked(draw):
        v, fall = usual(one.kwargs), draw.uniform(0.1, 0.7)
        falls = [(draw.uniform(0.7, 1.8), fall, draw.uniform(0.01, 2)), (1.0, draw.uniform(0.1, 0.7), -1.0)]
        if "random" not in one.kind:
            falls += [(1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.625, 1.0)]
        for fast, share, yaw in falls if one.kwargs["friction"] * one.kwargs["gravity"] else ():
            says = f"speed/speed0 = {share:.2g}{', a negative yaw rate' if yaw < 0 else ''}"
            cases.append(given(share * fast * v, fast * v, yaw, *one.args, **one.kwargs).on(f"{one.kind}, {says}"))
    return cases


def of_mechanics(draw):
    """(function, call), moving and at rest, for another `locked` in the place of the last argument."""
    for kind in (TURN, REST):
        one, t = moving(draw, kind, "front"), np.array([0.0, 1e-3])
        before = {"axle_load": (), "friction_force": one.args[:1], "kinetic_energy": one.args[:1]}
        before |= {"state_derivative": (0.0, one.args[0]), "simulate": (t, one.args[0])}
        yield from ((name, given(*first, "front", **one.kwargs).on(kind)) for name, first in before.items())


def of_stability(draw):
    before = {"yaw_growth_rate": (2.0,), "critical_speed": (), "small_yaw_rate": (1.0, 2.0, 0.1)}
    return [(name, given(*first, "front", **car(draw)).on("a random car")) for name, first in before.items()]


# Motions


def run(draw, kind, locked, ways, share, count, **fixed):
    """For this share of the time to the stop; without friction until it has gone so many wheelbases."""
    known = car(draw, **fixed)
    start = state(draw, known, *ways)
    brakes = known["friction"] * known["gravity"]
    latest = stopped(start, locked, known)[0] if brakes else wheelbase(known) / speed_of(start, known)
    t = uneven(draw, share * latest, count)
    return call(kind, known, locked, t, start)


def braking(count):
    """Until before the speed passes zero; a rear axle that is locked swings round, and so backwards."""
    return lambda draw: [
        run(draw, "braking", "front", (QUICK, LITTLE), 0.75, count),
        run(draw, "braking", "rear", (QUICK, LITTLE), 0.2, count),
        run(draw, "braking in reverse", "rear", ((-2, -1), LITTLE), 0.75, count),
    ]


def plain(draw, share, **fixed):
    """Two times: straight on, or turning on the spot, from the origin along x or from anywhere."""
    kinds = [kind for kind, (speed, yaw) in WAYS.items() if (speed == NONE) != (yaw == NONE)]
    cases = [run(draw, kind, locked, WAYS[kind], share, 2, **fixed) for kind in kinds for locked in AXLES]
    for case in cases:
        case.args[1][:3] *= draw.integers(0, 2)
    return cases


def few_times(draw):
    """Few times, plain runs at two times, a small yaw rate above the critical speed, what is kept between calls."""
    growing = (1.5, 1.8), (1e-4, 1.5e-4)  # it turns the car by 1e-4 and more
    ones = [run(draw, "all parameters 1", locked, (QUICK, LITTLE), 0.3, 2, **ONES) for locked in AXLES]
    cases = [*braking(4)(draw), *plain(draw, 0.3), *ones, run(draw, "a small yaw rate", "rear", growing, 0.7, 2)]
    first = run(draw, "friction above 1", "rear", (QUICK, LITTLE), 0.2, 4, friction=draw.uniform(1.2, 2))
    other = state(draw, first.kwargs, QUICK, LITTLE)
    return [*cases, first, *in_turn(draw, first, start=(other, "front"), mass=None, front=None, rear=None)]


def gliding(draw):
    """Without friction or gravity, with the free axle behind at first, and plain ones."""
    little = (0.1, 0.3)
    return [
        run(draw, "friction 0", "front", (REVERSE, little), 10, 60, friction=0.0),
        run(draw, "gravity 0", "rear", (FORWARDS, little), 10, 60, gravity=0.0),
        *plain(draw, 1.0, friction=0.0),
        *plain(draw, 1.0, gravity=0.0),
    ]


def gliding_slowly(draw):
    """At some mm/s, above what may be called rest where there is friction."""
    yaw = (0.005, 0.006)
    return [
        run(draw, "a slow car, friction 0", "front", ((0.01, 0.012), yaw), 0.05, 4, friction=0.0),
        run(draw, "a slow car, gravity 0", "rear", ((-0.012, -0.01), yaw), 0.05, 4, gravity=0.0),
    ]


def braking_slowly(draw):
    """A fortieth of the usual speed, well above what may be called rest."""
    slow = (0.02, 0.03), (0.005, 0.013)
    return [run(draw, "a slow car", "front", slow, 0.6, 4), run(draw, "a slow car", "rear", slow, 0.2, 4)]


def stops(draw):
    """Motions that go on beyond the stop."""
    forwards, some, kind = (0.7, 1.5), (0.2, 0.6), "a car that stops"
    ice = {"friction": 0.02, "gravity": 10.0}
    return [
        run(draw, kind, "front", (forwards, some), 2.1, 40),
        run(draw, f"{kind} in reverse", "rear", ((-1.5, -0.7), some), 2.1, 40),
        run(draw, f"{kind}, only two times", "rear", (forwards, some), 1.12, 2),
        run(draw, f"{kind}, spinning on ice", "rear", ((0.3, 1), (5, 6.5)), 2.1, 50, **ice),
        run(draw, f"{kind}, spinning, only two times", "front", ((0.05, 0.2), (0.8, 1.2)), 1.12, 2),
        run(draw, f"{kind}, straight ahead", "rear", (forwards, NONE), 2.1, 20),
    ]


def at_rest(draw):
    cases = [moving(draw, REST, locked) for locked in AXLES]
    return [given(uneven(draw, 3.0, 10), *case.args, **case.kwargs).on(case.kind) for case in cases]
