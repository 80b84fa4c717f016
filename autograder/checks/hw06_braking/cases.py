"""Hidden inputs of hw06: cars, their states and motions."""

import itertools
import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from .reference import stopped, wheelbase

AXLES = ("front", "rear")
OTHERS = ("both", "Front", "r")
LIMITS = {"front": (0.3, 2), "rear": (0.3, 2), "yaw_inertia": (0.4, 2), "friction": (0.2, 1), "gravity": (2, 20)}
ONES, NO_FRICTION, NO_GRAVITY = dict.fromkeys(("mass", *LIMITS), 1.0), {"friction": 0.0}, {"gravity": 0.0}
ODD_CARS = {
    "G half way between the axles": {"front": 1.2, "rear": 1.2},
    "all parameters 1": ONES,
    "friction 0": NO_FRICTION,
    "gravity 0": NO_GRAVITY,
    "friction above 1": {"friction": 1.6},
}
# ways to move: (speed, yaw rate) in the car's usual ones
FORWARDS, REVERSE, TURNING, LITTLE, NONE = (0.3, 2), (-2, -0.3), (0.3, 2), (0.2, 0.5), (0, 0)
BRAKING = (1, 2), LITTLE
TURN, REST = "a car that goes forwards and turns", "a car at rest"
WAYS = {
    TURN: (FORWARDS, TURNING),
    "a car in reverse": (REVERSE, TURNING),
    "a car that turns about its free axle on the spot": (NONE, TURNING),
    "straight motion": (FORWARDS, NONE),
    "straight motion in reverse": (REVERSE, NONE),
    REST: (NONE, NONE),
}
MOVING = [label for label in WAYS if label != REST]


def car(rng, **fixed):
    """yaw_inertia is drawn as a share of mass front rear."""
    mass = 10 ** rng.uniform(0.5, 3.3)
    car = {name: rng.uniform(*limits) for name, limits in LIMITS.items()} | fixed
    car["yaw_inertia"] *= mass * car["front"] * car["rear"]
    return {"mass": mass, **car, **fixed}


def drag(car):
    """The deceleration by friction, m/s^2, and some where there is none."""
    return max(car["friction"] * car["gravity"], 0.2)


def usual(car):
    """Size of speeds, m/s: friction stops it within about a wheelbase."""
    return math.sqrt(drag(car) * wheelbase(car))


def speed_of(case):
    """Of its speed and its turning, m/s."""
    *_, state, _ = case.args
    return abs(state[3]) + abs(state[4]) * wheelbase(case.kwargs)


def state(rng, car, speed, yaw):
    """Anywhere, a heading not within a turn of zero; speed and yaw, either way, in the car's usual ones."""
    heading = rng.choice([rng.uniform(-10, -3.3), rng.uniform(6.5, 10)])  # wrapped, it is another
    rates = rng.uniform(*speed) * usual(car), rng.choice([-1, 1]) * rng.uniform(*yaw) * usual(car) / wheelbase(car)
    return np.array([*rng.uniform(-5, 5, 2), heading, *rates])


# Cases of functions of a state, for all of them: (state, locked, **car)


def with_car(label, car, locked, *first):
    return Case(*first, locked, **car).labelled(f"{label}, a locked {locked} axle")


def moving(rng, label, locked, way, **fixed):
    random = car(rng, **fixed)
    return with_car(label, random, locked, state(rng, random, *way))


def ways(*labels, count=1, **fixed):
    """States that move in these ways, of cars with either axle locked."""
    return lambda rng: [
        moving(rng, label, locked, WAYS[label], **fixed) for label in labels for locked in AXLES * count
    ]


def odd_cars(rng):
    """Each odd car as it turns, with one axle locked, and moving otherwise or at rest, with the other."""
    others = itertools.cycle([label for label in WAYS if label != TURN and "reverse" not in label])
    for (odd, fixed), label, axles in zip(
        ODD_CARS.items(), others, itertools.cycle((AXLES, AXLES[::-1])), strict=False
    ):
        for way, locked in zip((TURN, label), axles, strict=True):
            case = moving(rng, way, locked, WAYS[way], **fixed)
            yield case.labelled(f"{odd}, {case.label}")


def headings(rng):
    """Along the axes and beyond a turn, with G at the origin."""
    cases = itertools.cycle(ways(TURN, "straight motion in reverse")(rng))
    for heading, case in zip((0.0, math.pi, -math.pi / 2, 9.0), cases, strict=False):
        state = np.array([0, 0, heading, *case.args[0][3:]])
        yield case.replace(state).labelled(f"G at the origin, heading {heading:.3g}, {case.label}")


def all_states(rng):
    """Every way to move, odd cars, every heading."""
    return [*ways(*WAYS)(rng), *odd_cars(rng), *headings(rng)]


def creeping(label, *speeds):
    """The locked axle moves at these speeds, m/s, any way."""

    def case(rng, locked, speed):
        random, way = car(rng), rng.uniform(-3, 3)
        rates = speed * math.cos(way), speed * math.sin(way) / wheelbase(random)
        return with_car(label, random, locked, state(rng, random, NONE, NONE) + [0, 0, 0, *rates])

    return lambda rng: [case(rng, locked, speed) for locked in AXLES for speed in speeds]


slow = creeping("a locked axle at 1 mm/s or less", 1e-6, 3e-5, 1e-3)
hardly_moving = creeping("speed and yaw rate below 1e-8, which are not zero", 5e-9)  # np.allclose takes them for zero


def timed(*draws):
    """The same with a time before the state."""
    return lambda rng: [
        case.with_leading(float(t)) for t, case in enumerate(itertools.chain(*(cases(rng) for cases in draws)))
    ]


# Functions without a state


def parked(rng):
    """(locked, **car): random cars, and odd ones."""
    cars = [("a random car", car(rng)) for _ in range(2)]
    cars += [(label, car(rng, **fixed)) for label, fixed in ODD_CARS.items()]
    return [with_car(label, random, locked) for label, random in cars for locked in AXLES]


def at_speeds(rng):
    """(speed, locked, **car): low and high speeds."""
    return [case.with_leading(rng.uniform(0.3, 3) * usual(case.kwargs)) for case in parked(rng)]


def slowing(rng):
    """(speed, speed0, yaw_rate0, locked, **car): any speeds, and speeds that have not fallen yet, no yaw rate."""
    special = itertools.cycle([(1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.625, 1.0)])
    for case in parked(rng):
        v, fall = usual(case.kwargs), rng.uniform(0.1, 0.7)
        falls = [(rng.uniform(0.7, 1.8), fall, rng.uniform(0.01, 2))]
        falls.append((1.0, fall, -1.0) if "random" in case.label else next(special))
        for fast, share, yaw in falls if case.kwargs["friction"] * case.kwargs["gravity"] else ():
            message = f"speed/speed0 = {share:.2g}{', a negative yaw rate' if yaw < 0 else ''}"
            yield case.with_leading(share * fast * v, fast * v, yaw).labelled(f"{case.label}, {message}")


def of_mechanics(rng):
    """(function, case) at rest, for another `locked` in the place of the last argument."""
    case = moving(rng, REST, "front", WAYS[REST]).labelled(REST)
    return [
        ("axle_load", Case("front", **case.kwargs).labelled(REST)),
        ("friction_force", case),
        ("kinetic_energy", case),
        ("state_derivative", case.with_leading(0.0)),
        ("simulate", case.with_leading(np.array([0.0, 1e-3]))),
    ]


def of_stability(rng):
    before = {"yaw_growth_rate": (2.0,), "critical_speed": (), "small_yaw_rate": (1.0, 2.0, 0.1)}
    return [(name, Case(*first, "front", **car(rng)).labelled("a random car")) for name, first in before.items()]


# Motions


def run(rng, label, locked, way, share, count, fixed=None):
    """For this share of the time to the stop; without friction until it has gone so many wheelbases."""
    case = moving(rng, label, locked, way, **fixed or {})
    start, car = case.args[0], case.kwargs
    brakes = car["friction"] * car["gravity"]
    latest = stopped(start, locked, car)[0] if brakes else wheelbase(car) / speed_of(case)
    return case.with_leading(uneven(rng, share * latest, count))


def runs(*settings):
    return lambda rng: [run(rng, *setting) for setting in settings]


# until before the speed passes zero; a rear axle that is locked swings round, and so backwards
braking = runs(("braking", "front", BRAKING, 0.6, 20), ("braking in reverse", "rear", ((-2, -1), LITTLE), 0.6, 4))


def few_times(rng):
    """Few times, turning on the spot, what is kept between calls."""
    first = run(rng, "friction above 1", "rear", BRAKING, 0.2, 4, {"friction": rng.uniform(1.2, 2)})
    spot = state(rng, first.kwargs, NONE, (1.5, 3))  # it does not stop before the last time
    return [first, *repeated_calls(rng, first, start=(spot, "front"), mass=None, front=None, rear=None)]


# at some mm/s
gliding_slowly = runs(("a slow car, friction 0", "front", ((0.008, 0.01), (0.003, 0.004)), 0.05, 4, NO_FRICTION))


def at_rest(rng):
    return [moving(rng, REST, "rear", WAYS[REST]).with_leading(uneven(rng, 3.0, 4))]


stops = runs(  # and go on beyond
    ("a car that stops", "front", ((0.7, 1.5), (0.2, 0.6)), 2.1, 20),
    (
        "a car that stops, spinning on ice",
        "rear",
        ((0.05, 0.2), (0.8, 1.2)),
        1.12,
        2,
        {"friction": 0.02, "gravity": 10.0},
    ),
)
