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
# ranges of speed and yaw rate, in units of the car's usual ones
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
    """Return a random car, with yaw_inertia as a share of mass front rear."""
    mass = 10 ** rng.uniform(0.5, 3.3)
    car = {name: rng.uniform(*limits) for name, limits in LIMITS.items()} | fixed
    car["yaw_inertia"] *= mass * car["front"] * car["rear"]
    return {"mass": mass, **car, **fixed}


def drag(car):
    """Return the deceleration by friction, m/s^2, at least 0.2."""
    return max(car["friction"] * car["gravity"], 0.2)


def usual(car):
    """Return the scale of speeds, m/s: friction stops the car within about a wheelbase."""
    return math.sqrt(drag(car) * wheelbase(car))


def speed_of(case):
    """Return the size of the speed and the turning of a case together, m/s."""
    *_, state, _ = case.args
    return abs(state[3]) + abs(state[4]) * wheelbase(case.kwargs)


def state(rng, car, speed, yaw):
    """Return a state anywhere, heading outside -pi to 2 pi; speed and yaw rate are in the car's usual ones."""
    heading = rng.choice([rng.uniform(-10, -3.3), rng.uniform(6.5, 10)])  # wrapping changes it
    rates = rng.uniform(*speed) * usual(car), rng.choice([-1, 1]) * rng.uniform(*yaw) * usual(car) / wheelbase(car)
    return np.array([*rng.uniform(-5, 5, 2), heading, *rates])


# Cases (state, locked, **car), for all functions of a state


def with_car(label, car, locked, *first):
    return Case(*first, locked, **car).labelled(f"{label}, a locked {locked} axle")


def moving(rng, label, locked, way, **fixed):
    random = car(rng, **fixed)
    return with_car(label, random, locked, state(rng, random, *way))


def ways(*labels, count=1, **fixed):
    """Return a function for states that move in these ways, of cars with either axle locked."""
    return lambda rng: [
        moving(rng, label, locked, WAYS[label], **fixed) for label in labels for locked in AXLES * count
    ]


turning, moving_on, resting, any_way = ways(TURN, count=2), ways(*MOVING), ways(REST), ways(*WAYS)


def odd_cars(rng):
    """Yield each odd car in a turn, with one axle locked, and moving otherwise or at rest, with the other."""
    others = itertools.cycle([label for label in WAYS if label != TURN and "reverse" not in label])
    for (odd, fixed), label, axles in zip(
        ODD_CARS.items(), others, itertools.cycle((AXLES, AXLES[::-1])), strict=False
    ):
        for way, locked in zip((TURN, label), axles, strict=True):
            case = moving(rng, way, locked, WAYS[way], **fixed)
            yield case.labelled(f"{odd}, {case.label}")


def headings(rng):
    """Yield headings along the axes and beyond a turn, with G at the origin."""
    cases = itertools.cycle(ways(TURN, "straight motion in reverse")(rng))
    for heading, case in zip((0.0, math.pi, -math.pi / 2, 9.0), cases, strict=False):
        state = np.array([0, 0, heading, *case.args[0][3:]])
        yield case.replace(state).labelled(f"G at the origin, heading {heading:.3g}, {case.label}")


def all_states(rng):
    """Return every way to move, odd cars, special headings."""
    return [*any_way(rng), *odd_cars(rng), *headings(rng)]


def creeping(label, *speeds):
    """Return a function for states in which the locked axle moves at these speeds, m/s, in any direction."""

    def case(rng, locked, speed):
        random, way = car(rng), rng.uniform(-3, 3)
        rates = speed * math.cos(way), speed * math.sin(way) / wheelbase(random)
        return with_car(label, random, locked, state(rng, random, NONE, NONE) + [0, 0, 0, *rates])

    return lambda rng: [case(rng, locked, speed) for locked in AXLES for speed in speeds]


slow = creeping("a locked axle at 1 mm/s or less", 1e-6, 3e-5, 1e-3)
hardly_moving = creeping("speed and yaw rate below 1e-8, which are not zero", 5e-9)  # np.allclose takes these for zero


def timed(rng, *cases_of):
    """Return these cases with a time before the state."""
    chained = itertools.chain(*(cases(rng) for cases in cases_of))
    return [case.with_leading(float(t)) for t, case in enumerate(chained)]


# Functions without a state


def parked(rng):
    """Return (locked, **car) of random cars and odd ones."""
    cars = [("a random car", car(rng)) for _ in range(2)]
    cars += [(label, car(rng, **fixed)) for label, fixed in ODD_CARS.items()]
    return [with_car(label, random, locked) for label, random in cars for locked in AXLES]


def at_speeds(rng):
    """Return (speed, locked, **car) with low and high speeds."""
    return [case.with_leading(rng.uniform(0.3, 3) * usual(case.kwargs)) for case in parked(rng)]


def slowing(rng):
    """Yield (speed, speed0, yaw_rate0, locked, **car): any speeds, also not reduced yet, and no yaw rate."""
    special = itertools.cycle([(1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.625, 1.0)])
    for case in parked(rng):
        v, fall = usual(case.kwargs), rng.uniform(0.1, 0.7)
        falls = [(rng.uniform(0.7, 1.8), fall, rng.uniform(0.01, 2))]
        falls.append((1.0, fall, -1.0) if "random" in case.label else next(special))
        for fast, share, yaw in falls if case.kwargs["friction"] * case.kwargs["gravity"] else ():
            message = f"speed/speed0 = {share:.2g}{', a negative yaw rate' if yaw < 0 else ''}"
            yield case.with_leading(share * fast * v, fast * v, yaw).labelled(f"{case.label}, {message}")


def of_mechanics(rng):
    """Return (function, case) at rest; the last argument of a case may be replaced by another `locked`."""
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
    """Return a motion for this share of the time to the stop; without friction, of the time for a wheelbase."""
    case = moving(rng, label, locked, way, **fixed or {})
    start, car = case.args[0], case.kwargs
    brakes = car["friction"] * car["gravity"]
    latest = stopped(start, locked, car)[0] if brakes else wheelbase(car) / speed_of(case)
    return case.with_leading(uneven(rng, share * latest, count))


def runs(*settings):
    return lambda rng: [run(rng, *setting) for setting in settings]


# until before the speed passes zero; with a locked rear axle the car swings round, and so goes backwards
braking = runs(("braking", "front", BRAKING, 0.6, 20), ("braking in reverse", "rear", ((-2, -1), LITTLE), 0.6, 4))


def few_times(rng):
    """Return a motion at few times, and changed calls, one of which turns on the spot."""
    first = run(rng, "friction above 1", "rear", BRAKING, 0.2, 4, {"friction": rng.uniform(1.2, 2)})
    spot = state(rng, first.kwargs, NONE, (1.5, 3))  # it does not stop before the last time
    return [first, *repeated_calls(rng, first, start=(spot, "front"), mass=None, front=None, rear=None)]


# at some mm/s
gliding_slowly = runs(("a slow car, friction 0", "front", ((0.008, 0.01), (0.003, 0.004)), 0.05, 4, NO_FRICTION))


def at_rest(rng):
    return [moving(rng, REST, "rear", WAYS[REST]).with_leading(uneven(rng, 3.0, 4))]


# its speed is near zero for so long that a stop at such a speed shows, although solvers make large steps
SPIN = (0.06, 0.08)
SPINNING = (0.001 * SPIN[1], 0.0012 * SPIN[1]), SPIN
stops = runs(  # the times go on beyond the stop
    ("a car that stops", "front", ((0.7, 1.5), (0.2, 0.6)), 2.1, 20),
    ("a car that spins until it stops", "rear", SPINNING, 1.12, 9, {"friction": 1.0, "gravity": 20.0, "front": 2.0}),
    (
        "a car that stops, spinning on ice",
        "rear",
        ((0.05, 0.1), (0.8, 1.2)),
        1.12,
        9,
        {"friction": 0.02, "gravity": 10.0, "front": 2.0},  # with G far behind the free axle its speed passes zero
    ),
)
