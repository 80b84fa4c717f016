"""Hidden checks of hw06. What is right is found in the ground's axes, the free axle's side force a Lagrange multiplier.

Forces and velocities in the car's axes are (forward, left) pairs; axles are at distances forward of G.
"""

import math
from functools import partial

import numpy as np

from tam570.integrate import solve
from tam570_grader import array, check, expect, expect_that, given, mistimed, number, once, rows, suspect, uneven

RESULTS = {
    "axle_load": number,
    "friction_force": array(2),
    "state_derivative": array(5),
    "simulate": rows(5),
    "kinetic_energy": number,
    "yaw_growth_rate": number,
    "critical_speed": array(infinite=True),
    "small_yaw_rate": number,
}
NEEDS = ("numpy",)
MANUAL = {"c": (2, "the definition of steering stability, with plots that answer the question by it")}

FORMULA = 1e-9  # of the largest term: roundings make 1e-15, solving for the side force 1e-13; wrong terms .1
GROWTH = 1e-6  # a student's central difference is good to 1e-9; wrong terms are off by .1
SMALL_YAW = 1e-6  # the same, and an integral by rtol 1e-9 in the place of the closed form
# solve_ivp at rtol = atol = 1e-9, whatever its method, stays below 8e-8 well before the stop.
TRAJECTORY = 1e-6
SLOW = 1e-3  # at 1e-6 m/s and more a guard against 0/0 (v + 1e-9) is still right, a deadband off by 1
AT_REST = 5e-3  # of the first speed: a student may call it rest below 1e-3 m/s, and cars start from 0.4 m/s
NEARLY = 1e-3  # of a difference, to say of what kind it is
SEEN = 1e-4  # to say what a wrong result is, as loosely as suspects
STOPPED = 5e-5  # of the distance friction needs: from that threshold to the stop it is the square, up to 1e-5


# The car


def axles(locked, front, rear):
    """Positions of the free and of the dragging axle."""
    return (-rear, front) if locked == "front" else (front, -rear)


def other(locked):
    return "rear" if locked == "front" else "front"


def load(locked, *, mass, front, rear, gravity):
    """By the moments of the weight and of this load about the other axle."""
    free, dragging = axles(locked, front, rear)
    return mass * gravity * (0 - free) / (dragging - free)


def velocity_of(point, state, locked, front, rear):
    """Of a point of the centreline: the free axle has none to the left."""
    speed, yaw_rate = state[3:]
    return float(speed), float((point - axles(locked, front, rear)[0]) * yaw_rate)


def against(velocity, size):
    fast = math.hypot(*velocity)
    return tuple(-size * v / fast for v in velocity) if fast else (0.0, 0.0)


def coulomb(state, locked, *, mass, front, rear, friction, gravity):
    dragging = axles(locked, front, rear)[1]
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return against(velocity_of(dragging, state, locked, front, rear), size)


def derivative(state, locked, *, force=coulomb, yaw_inertia, **car):
    """F = m a, moments about G, and the free axle's sideways velocity stays zero, by a Lagrange multiplier."""
    mass, (free, dragging) = car["mass"], axles(locked, car["front"], car["rear"])
    heading, yaw_rate = float(state[2]), float(state[4])
    c, s = math.cos(heading), math.sin(heading)
    forward, left = velocity_of(0.0, state, locked, car["front"], car["rear"])
    along, aside = force(state, locked, **car)
    fx, fy, moment = along * c - aside * s, along * s + aside * c, dragging * aside
    # the sideways velocity of the free axle is -s vx + c vy + free yaw_rate; what its rate lacks, the multiplier adds
    lacking = yaw_rate * forward - (c * fy - s * fx) / mass - free * moment / yaw_inertia
    multiplier = lacking / (1 / mass + free**2 / yaw_inertia)
    ax, ay = (fx - s * multiplier) / mass, (fy + c * multiplier) / mass
    turning = (moment + free * multiplier) / yaw_inertia
    slowing = ax * c + ay * s + yaw_rate * left
    return np.array([forward * c - left * s, forward * s + left * c, yaw_rate, slowing, turning])


def inertia_about_free(locked, *, mass, yaw_inertia, front, rear):
    return yaw_inertia + mass * axles(locked, front, rear)[0] ** 2


# Wrong answers that are known


def swapped(function):
    return lambda state, locked, **car: function(state, other(locked), **car)


def load_of_the_other(state, locked, *, front, rear, **road):
    ratio = front / rear if locked == "front" else rear / front
    return tuple(ratio * force for force in coulomb(state, locked, front=front, rear=rear, **road))


def straight_back(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return -size * float(np.sign(state[3])), 0.0


def against_G(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return against(velocity_of(0.0, state, locked, front, rear), size)


def turning_about_G(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return against((float(state[3]), axles(locked, front, rear)[1] * float(state[4])), size)


def by_the_slope(*motion, **car):
    """The atan of left over forward tells a direction from its opposite no more."""
    return tuple(force * float(np.sign(motion[0][3])) for force in coulomb(*motion, **car))


def never_forward(*motion, **car):
    forward, left = coulomb(*motion, **car)
    return -abs(forward), left


def along_each_axis(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    dragging = axles(locked, front, rear)[1]
    return tuple(-size * float(np.sign(v)) for v in velocity_of(dragging, state, locked, front, rear))


def of_small_angles(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    forward, left = velocity_of(axles(locked, front, rear)[1], state, locked, front, rear)
    return -size * float(np.sign(forward)), -size * (left / abs(forward) if forward else float(np.sign(left)))


def in_the_grounds_axes(state, locked, **car):
    c, s, (forward, left) = math.cos(state[2]), math.sin(state[2]), coulomb(state, locked, **car)
    return forward * c - left * s, forward * s + left * c


def whole_weight(*motion, mass, front, rear, friction, gravity):
    size = load(motion[1], mass=mass, front=front, rear=rear, gravity=gravity)
    more = {"friction": friction * mass * gravity / size if size else 0.0, "gravity": gravity}
    return coulomb(*motion, mass=mass, front=front, rear=rear, **more)


def under(force):
    return lambda state, locked, **car: derivative(state, locked, force=force, **car)


def without_turning_term(state, locked, *, friction, gravity, **body):
    rates = derivative(state, locked, friction=friction, gravity=gravity, **body)
    free = axles(locked, body["front"], body["rear"])[0]
    rates[4] -= body["mass"] * free * state[3] * state[4] / inertia_about_free(locked, **body)
    return rates


def with_square(times):
    """With d omega^2 in the speed's rate as -times(d) omega^2, where -d omega^2 belongs."""

    def rates(state, locked, *, front, rear, **car):
        right, free = derivative(state, locked, front=front, rear=rear, **car), axles(locked, front, rear)[0]
        right[3] += (free - times(free)) * state[4] ** 2
        return right

    return rates


def about_G(state, locked, *, friction, gravity, **body):
    rates = derivative(state, locked, friction=friction, gravity=gravity, **body)
    rates[4] *= inertia_about_free(locked, **body) / body["yaw_inertia"]
    return rates


def with_state(change):
    """The rates, with the state taken for another."""

    def rates(state, locked, **car):
        return derivative(np.array(change(*state)), locked, **car)

    return rates


def to_the_other_side_in_y(state, locked, **car):
    rates = derivative(state, locked, **car)
    rates[1] -= 2 * velocity_of(0.0, state, locked, car["front"], car["rear"])[1] * math.cos(state[2])
    return rates


def along_the_car(state, locked, **car):
    rates = derivative(state, locked, **car)
    rates[:2] = state[3] * math.cos(state[2]), state[3] * math.sin(state[2])
    return rates


SWAPPED = "the locked axle and the free one exchanged"
WRONG_FORCES = {
    SWAPPED: swapped(coulomb),
    "the load of the other axle": load_of_the_other,
    "friction straight back along the car, whatever way the locked axle moves": straight_back,
    "friction against the velocity of G, where it is the locked axle that drags": against_G,
    "the locked axle's velocity to the side by its distance from G, where that is from the free axle": turning_about_G,
    "friction under the whole weight": whole_weight,
}
WRONG_RATES = {
    SWAPPED: swapped(derivative),
    **{says: under(force) for says, force in WRONG_FORCES.items() if says != SWAPPED},
    "the term with mass, speed and yaw rate (m d v omega) missing from the turning": without_turning_term,
    "the term with the square of the yaw rate missing from the speed's rate": with_square(lambda d: 0.0),
    "the term with the square of the yaw rate in the speed's rate reversed": with_square(lambda d: -d),
    "the square of the yaw rate in the speed's rate with one sign, whichever axle is locked": with_square(abs),
    "the inertia about G where that about the free axle belongs": about_G,
}
WRONG_VELOCITIES = {
    "the velocity of G in the axes of the car, where x and y are those of the ground": with_state(
        lambda x, y, heading, *rates: (x, y, 0.0, *rates)
    ),
    "the heading taken for degrees": with_state(lambda x, y, heading, *rates: (x, y, math.radians(heading), *rates)),
    "G moving along the car alone, its velocity to the side left out": along_the_car,
    "G's velocity to the side with the wrong sign in the rate of y": to_the_other_side_in_y,
}
WRONG_IN_REVERSE = {
    "the direction of friction by an atan of left over forward, which is the same in reverse": by_the_slope,
    "friction backward along the car in reverse too": never_forward,
}


def force_suspects(wrong_forces):
    return [
        suspect(says, friction_force=lambda *of, wrong=wrong, **car: np.array(wrong(*of, **car)))
        for says, wrong in wrong_forces.items()
    ]


def rate_suspects(wrong_rates):
    return [
        suspect(says, state_derivative=lambda t, state, locked, wrong=wrong, **car: wrong(state, locked, **car))
        for says, wrong in wrong_rates.items()
    ]


FORCE_SUSPECTS = force_suspects(
    {
        **WRONG_FORCES,
        "friction of its full size along each of the car's axes": along_each_axis,
        "the force in the axes of the ground, where forward and left are those of the car": in_the_grounds_axes,
        "the direction of friction for small angles, its full size along the car": of_small_angles,
    }
)
RATE_SUSPECTS = rate_suspects({**WRONG_RATES, **WRONG_VELOCITIES})
REVERSE_SUSPECTS = rate_suspects(
    {
        "the speed taken for positive": with_state(lambda x, y, heading, speed, yaw: (x, y, heading, abs(speed), yaw)),
        **{says: under(force) for says, force in WRONG_IN_REVERSE.items()},
    }
)


# Cars and their motions


def car(draw, **fixed):
    mass, (front, rear) = 10 ** draw.uniform(0.5, 3.3), draw.uniform(0.3, 2, 2)
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


def wheelbase(car):
    return car["front"] + car["rear"]


def state(draw, car, speed, yaw):
    """Anywhere, a heading not within a turn of zero; speed in the usual speed, yaw in that per wheelbase."""
    heading = draw.choice([draw.uniform(-10, -3.3), draw.uniform(6.5, 10)])  # wrapped, it is another
    return np.array([*draw.uniform(-5, 5, 2), heading, speed * usual(car), yaw * usual(car) / wheelbase(car)])


def parts(car, *names):
    return {name: car[name] for name in names}


BODY = ("mass", "yaw_inertia", "front", "rear")
FORCE = ("mass", "front", "rear", "friction", "gravity")
ALL = (*BODY, "friction", "gravity")
LOAD = ("mass", "front", "rear", "gravity")


def signed(draw, low, high):
    return draw.choice([-1, 1]) * draw.uniform(low, high)


def motions(draw, count, speed, yaw, **fixed):
    """For each axle so many (state, locked, car), with speeds and yaw rates made by these functions of draw."""
    made = []
    for locked in ("front", "rear"):
        for _ in range(count):
            c = car(draw, **fixed)
            made.append((state(draw, c, speed(draw), yaw(draw)), locked, c))
    return made


def forwards(draw):
    return draw.uniform(0.3, 2)


def backwards(draw):
    return -draw.uniform(0.3, 2)


def turning(draw):
    return signed(draw, 0.3, 2)


def quick(draw):
    return draw.uniform(1, 2)


def turning_a_little(draw):
    """So little that a quick car's speed does not pass zero in the first fifth of the time that it moves."""
    return signed(draw, 0.2, 0.5)


def nothing(draw):
    return 0.0


KINDS = {
    "a car in reverse": (backwards, turning),
    "a car that turns about its free axle on the spot": (nothing, turning),
    "straight motion": (forwards, nothing),
    "straight motion in reverse": (backwards, nothing),
}


ODD_CARS = {
    "G half way between the axles": {"front": 1.2, "rear": 1.2},
    "all parameters 1": dict.fromkeys(("mass", "yaw_inertia", "front", "rear", "friction", "gravity"), 1.0),
    "friction 0": {"friction": 0.0},
    "gravity 0": {"gravity": 0.0},
    "friction and gravity 0": {"friction": 0.0, "gravity": 0.0},
    "friction above 1": {"friction": 1.6},
}


def odd_cars(draw):
    """(locked, car, kind), for each axle: of exact values that no draw hits."""
    found = []
    for kind, fixed in ODD_CARS.items():
        for locked in ("front", "rear"):
            c = car(draw, **fixed)
            if "front" in fixed and "mass" not in fixed:
                c["yaw_inertia"] = c["mass"] * c["front"] * c["rear"] * draw.uniform(0.4, 2)
            found.append((locked, c, kind))
    return found


def odd_motions(draw):
    """(kind, [(state, locked, car)]): each odd car going forwards, on the spot, straight on and at rest."""
    ways = {
        "a car that goes forwards and turns": (forwards, turning),
        "a car that turns about its free axle on the spot": (nothing, turning),
        "straight motion": (forwards, nothing),
        "at rest": (nothing, nothing),
    }
    return [
        (f"{kind}, {says}", [(state(draw, c, speed(draw), yaw(draw)), locked, c)])
        for locked, c, kind in odd_cars(draw)
        for says, (speed, yaw) in ways.items()
    ]


def odd_headings(draw):
    """As `odd_motions`: G at the origin, along the axes and beyond a turn, forwards and in reverse."""
    found = []
    for heading in (0.0, math.pi / 2, math.pi, -math.pi / 2, 9.0, -20.0):
        cases = motions(draw, 1, forwards, turning) + motions(draw, 1, backwards, nothing)
        for s, _, _ in cases:
            s[:3] = 0.0, 0.0, heading
        found.append((f"G at the origin, heading {heading:.3g}", cases))
    return found


def creeping(draw):
    """(state, locked, car), for each axle: the locked one moves at a micrometre to a millimetre a second, any way."""
    cases = motions(draw, 3, nothing, nothing)
    for (s, _, c), size in zip(cases, (1e-6, 3e-5, 1e-3) * 2, strict=True):
        v, way = size * draw.uniform(0.6, 1.0), draw.uniform(-3, 3)
        s[3:] = v * math.cos(way), v * math.sin(way) / wheelbase(c)
    return cases


def hardly_moving(draw):
    """(state, locked, car), for each axle: speed and yaw rate below what np.allclose tells from zero, 1e-8."""
    cases = motions(draw, 1, nothing, nothing)
    for s, _, _ in cases:
        s[3:] = 8e-9 * draw.choice([-1, 1], 2)
    return cases


HARDLY = "speed and yaw rate 8e-9, which are not zero"
CREEPING = "a car that moves slowly, its locked axle at a thousandth of a metre a second or less"


# Part a: forces, equations of motion


LOAD_SUSPECTS = [
    suspect(
        "the load of the other axle: the locked axle and the free one exchanged",
        axle_load=lambda locked, **c: load(other(locked), **c),
    ),
    suspect("the whole weight", axle_load=lambda locked, **c: c["mass"] * c["gravity"]),
    suspect("half the weight", axle_load=lambda locked, **c: c["mass"] * c["gravity"] / 2),
]


@check(points=0.75, part="a", suspects=LOAD_SUSPECTS)
def axle_load_balances_the_weight(student, draw):
    """axle_load: what the locked axle carries of the weight of a car at rest."""
    cases = [(locked, car(draw), f"a locked {locked} axle") for locked in ("front", "rear") * 6]
    cases += [(locked, c, of_kind(kind, locked)) for locked, c, kind in odd_cars(draw)]
    found = student.axle_load.many([given(locked, **parts(c, *LOAD)).on(kind) for locked, c, kind in cases])
    for value, (locked, c, kind) in zip(found, cases, strict=True):
        scale = c["mass"] * (c["gravity"] or 1.0)
        expect(
            value,
            load(locked, **parts(c, *LOAD)),
            within=FORMULA,
            scale=scale,
            of="the load",
            unit="of the weight",
            kind=kind,
            at=(locked, c),
            hint="which axle carries more, the one near G or the one far from it?",
        )


def of_kind(kind, locked):
    return f"{kind}, a locked {locked} axle"


def as_at_rest(found, right, unbraked, hint):
    """What to say of a result that is zero, or without friction, where it should not be: `hint` if it is neither."""
    if not np.any(found) and np.any(right):
        return "it is zero there, as if the car were at rest; at rest speed and yaw rate are both zero, exactly"
    if np.allclose(found, unbraked, rtol=SEEN, atol=0) and not np.allclose(right, unbraked, rtol=SEEN, atol=0):
        return "friction is zero there, as if the car were at rest; at rest speed and yaw rate are both zero, exactly"
    return hint


def of_force(found, right, hint):
    """As `as_at_rest`; or whether it is the size alone."""
    size, needed = math.hypot(*found), math.hypot(*right)
    if size and needed and np.max(np.abs(np.divide(found, size) - np.divide(right, needed))) <= SEEN:
        wrong = "large" if size > needed else "small"
        return f"the direction is right, the size too {wrong}: `friction` times the load there, at any speed"
    return as_at_rest(found, right, (0.0, 0.0), hint)


def judge_forces(student, cases, kind, hint, within=FORMULA):
    calls = [given(s, locked, **parts(c, *FORCE)).on(of_kind(kind, locked)) for s, locked, c in cases]
    found = student.friction_force.many(calls)
    for value, call, (s, locked, c) in zip(found, calls, cases, strict=True):
        scale = c["mass"] * max(c["friction"] * c["gravity"], 0.1)
        right = coulomb(s, locked, **parts(c, *FORCE))
        expect(
            value,
            right,
            within=within,
            scale=scale,
            of="the friction force",
            unit="of friction times the weight",
            kind=call.kind,
            hint=partial(of_force, value, right, hint),
            at=(s, locked, c),
        )


@check(points=1, part="a", suspects=FORCE_SUSPECTS)
def friction_opposes_the_sliding(student, draw):
    """friction_force: forward and left, against the velocity of the axle that drags, in proportion to its load."""
    judge_forces(
        student,
        motions(draw, 8, forwards, turning),
        "a car that goes forwards and turns",
        "which way does the locked axle move, seen from the car?",
    )


@check(points=0.5, part="a", after=friction_opposes_the_sliding, suspects=force_suspects(WRONG_IN_REVERSE))
def friction_in_any_motion_and_at_rest(student, draw):
    """friction_force: in reverse, on the spot, straight, slow, without friction; zero at rest."""
    for kind, (speed, yaw) in KINDS.items():
        judge_forces(
            student, motions(draw, 3, speed, yaw), kind, "Coulomb friction is along the velocity, not the axes"
        )
    judge_forces(student, motions(draw, 2, forwards, turning, friction=0.0), "friction 0", "")
    judge_forces(student, motions(draw, 2, nothing, nothing), "a car at rest", "what is zero over zero?")
    for kind, cases in odd_motions(draw) + odd_headings(draw):
        judge_forces(student, cases, kind, "")
    judge_forces(student, creeping(draw), CREEPING, "is it as large as at a high speed?", SLOW)
    calls = [given(s, locked, **parts(c, *FORCE)) for s, locked, c in hardly_moving(draw)]
    expect_friction(student.friction_force, calls, coulomb, HARDLY)


def expect_friction(function, calls, right, kind):
    """Along the right friction, however small: a guard against 0/0 leaves but a part of it there."""
    for found, call in zip(function.many([call.on(kind) for call in calls]), calls, strict=True):
        braking = right(*call.args, **call.kwargs)[-2:]
        expect_that(
            found[-2:] @ braking > 0,
            "there is no friction",
            kind=kind,
            at=call,
            hint=partial(as_at_rest, found[-2:], braking, (0.0, 0.0), "does it brake?"),
        )


BY_PARTS = {
    "the velocity of G": "G does slip sideways, as it is not on the free axle; then turn (forward, left) by the "
    "heading, each part with its sign",
    "the rate of heading": "it is the yaw rate",
    "the rate of speed": "the velocity is right; in axes that turn, the speed's rate has a term with the yaw rate "
    "squared, of one sign with the front locked and of the other with the rear",
    "the yaw acceleration": "the other rates are right: balance the moments about the free axle; the product of speed "
    "and yaw rate is there without friction, too",
}


def judge_rates(student, cases, kind, hint, within=FORMULA):
    """hint : where to look, or that for each of the rates"""
    calls = [given(t, s, locked, **parts(c, *ALL)).on(of_kind(kind, locked)) for t, (s, locked, c) in enumerate(cases)]
    for found, call, (s, locked, c) in zip(student.state_derivative.many(calls), calls, cases, strict=True):
        expected = derivative(s, locked, **parts(c, *ALL))
        v, length = usual(c) + abs(s[3]) + abs(s[4]) * wheelbase(c), wheelbase(c)
        # in a turn about an axle the inertia may be less than m length^2, by the smaller of the two
        quick = c["mass"] * length**2 / inertia_about_free(locked, **parts(c, *BODY))
        scale = [v, v, v / length, v * v / length, quick * (v / length) ** 2]
        for name, index in (
            ("the velocity of G", [0, 1]),
            ("the rate of heading", [2]),
            ("the rate of speed", [3]),
            ("the yaw acceleration", [4]),
        ):
            look = partial(of_rates, found, expected, s, locked, c, hint if isinstance(hint, str) else hint[name])
            expect(
                found[index],
                expected[index],
                within=within,
                scale=np.array(scale)[index],
                of=name,
                unit="of the size of its terms",
                kind=call.kind,
                at=(s, locked, c),
                hint=look,
            )


def of_rates(found, expected, state, locked, car, hint):
    unbraked = derivative(state, locked, **{**car, "friction": 0.0})
    if np.max(np.abs(found - expected)[:3]) == 0 or np.allclose(found[:3], expected[:3], rtol=SEEN, atol=SEEN):
        hint = of_friction(found - expected, state, locked, car) or hint
    return as_at_rest(found, expected, unbraked, hint)


def of_friction(residual, state, locked, car):
    """What is wrong with the friction in the rates, if it has the right direction or the right size, else nothing."""
    free, dragging = axles(locked, car["front"], car["rear"])
    inertia = inertia_about_free(locked, **parts(car, *BODY))
    more = complex(car["mass"] * residual[3], inertia * residual[4] / (dragging - free))
    right = complex(*coulomb(state, locked, **parts(car, *FORCE)))
    if not (more and right):
        return ""
    along, aside = (more / right).real, (more / right).imag
    if abs(aside) <= NEARLY * abs(along):
        wrong = "large" if along > 0 else "small"
        return f"it is friction that is wrong in it: of the right direction, and too {wrong}"
    if abs(abs(1 + more / right) - 1) <= NEARLY * abs(more / right):
        return "it is friction that is wrong in it: of the right size, but not against the locked axle's velocity"
    return ""


@check(points=1.25, part="a", suspects=RATE_SUSPECTS)
def equations_of_motion(student, draw):
    """state_derivative: the balances of momentum, and a free axle that does not slip sideways."""
    judge_rates(student, motions(draw, 10, forwards, turning), "a car that goes forwards and turns", BY_PARTS)


@check(points=0.5, part="a", after=equations_of_motion, suspects=REVERSE_SUSPECTS)
def equations_in_any_motion(student, draw):
    """state_derivative: in reverse, turning on the spot, straight, slow."""
    for kind, (speed, yaw) in KINDS.items():
        judge_rates(student, motions(draw, 3, speed, yaw), kind, "the direction of friction is that of a velocity")
    for kind, cases in odd_headings(draw):
        judge_rates(student, cases, kind, "does it matter where it goes?")
    judge_rates(student, creeping(draw), CREEPING, "is friction as large as at a high speed?", SLOW)
    calls = [given(0.0, s, locked, **parts(c, *ALL)) for s, locked, c in hardly_moving(draw)]
    expect_friction(student.state_derivative, calls, lambda _, s, locked, **c: derivative(s, locked, **c), HARDLY)


@check(points=0.5, part="a", after=equations_of_motion)
def equations_without_friction_and_at_rest(student, draw):
    """state_derivative: without friction, without gravity; all zero at rest."""
    for fixed, kind in (({"friction": 0.0}, "friction 0"), ({"gravity": 0.0}, "gravity 0")):
        judge_rates(student, motions(draw, 3, forwards, turning, **fixed), kind, "the free axle guides it still")
    judge_rates(student, motions(draw, 2, nothing, nothing), "a car at rest", "what is zero over zero?")
    for kind, cases in odd_motions(draw):
        judge_rates(student, cases, kind, "which terms are zero, and which are not?")


def energy(state, locked, *, mass, yaw_inertia, front, rear):
    forward, left = velocity_of(0.0, state, locked, front, rear)
    return (mass * (forward**2 + left**2) + yaw_inertia * state[4] ** 2) / 2


ENERGY_SUSPECTS = [
    suspect(SWAPPED, kinetic_energy=swapped(energy)),
    suspect(
        "G's velocity to the side left out",
        kinetic_energy=lambda s, locked, **c: (c["mass"] * s[3] ** 2 + c["yaw_inertia"] * s[4] ** 2) / 2,
    ),
    suspect(
        "the turning left out", kinetic_energy=lambda s, locked, **c: energy(s, locked, **{**c, "yaw_inertia": 0.0})
    ),
    suspect("the kinetic energy without its half", kinetic_energy=lambda *motion, **c: 2 * energy(*motion, **c)),
]


@check(points=0.5, part="a", suspects=ENERGY_SUSPECTS)
def kinetic_energy_of_G_and_of_turning(student, draw):
    """kinetic_energy: of G, which moves to the side too, and of the turning about it."""
    of = [
        ("a car that goes forwards and turns", motions(draw, 5, forwards, turning)),
        ("a car in reverse", motions(draw, 3, backwards, turning)),
        *odd_motions(draw),
        *odd_headings(draw),
    ]
    cases = [(*case, of_kind(kind, case[1])) for kind, some in of for case in some]
    calls = [given(s, locked, **parts(c, *BODY)).on(kind) for s, locked, c, kind in cases]
    for value, (s, locked, c, kind) in zip(student.kinetic_energy.many(calls), cases, strict=True):
        right = energy(s, locked, **parts(c, *BODY))
        expect(
            value,
            right,
            within=FORMULA,
            scale=right or 1.0,
            of="the kinetic energy",
            unit="of itself",
            kind=kind,
            at=(s, locked, c),
            hint="what is the velocity of G?",
        )


# Part a: motion


def sliding(state, locked, car):
    """Speed of the middle of the locked axle."""
    dragging = axles(locked, car["front"], car["rear"])[1]
    return math.hypot(*velocity_of(dragging, state, locked, car["front"], car["rear"]))


def moved(t, start, locked, **car):
    """Right states at t, all of them before the stop; within 1e-9 of their scales."""
    return solve(lambda _, s: derivative(s, locked, **car), t, start, rtol=1e-11, method="python")


def stopped(start, locked, car):
    """Time of the stop since the start, and the state there, both to 1e-5.

    In a time that runs as fast as the car slides, d tau = sliding dt, nothing is singular. The inertia about the
    free axle is below mass wheelbase^2 (as G is between the axles, and by the draw of yaw_inertia), the energy
    so below mass sliding^2/2, and friction takes at least 2 friction load/mass of it for each unit of tau.
    """

    def slowed(_, s):
        speed = sliding(s[:5], locked, car)
        return *(speed * rate for rate in derivative(s[:5], locked, **car)), speed

    # to exp(-12) of the speed
    decays = 12 * car["mass"] / (car["friction"] * load(locked, **parts(car, *LOAD)))
    *state, time = solve(slowed, [0.0, decays], [*start, 0.0], rtol=1e-7, method="python")[-1]
    return time, np.array(state)


def integrated(t, start, locked, rates, **car):
    """States at t of wrong rates, and of right ones beyond the stop."""
    from scipy.integrate import solve_ivp

    def still_sliding(_, s):
        # the way from here to the stop is the square of this, 1e-8
        return sliding(s, locked, car) - 1e-4 * usual(car)

    still_sliding.terminal = True
    # short steps where it interpolates between them
    longest = (t[-1] - t[0]) / 30 if len(t) > 2 else np.inf
    options = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-11, "max_step": longest}
    run = solve_ivp(
        lambda _, s: rates(s, locked, **car), (t[0], t[-1]), start, dense_output=True, events=still_sliding, **options
    )
    states = run.sol(np.minimum(t, run.t[-1])).T
    states[t > (run.t[-1] if run.status == 1 else math.inf), 3:] = 0.0
    return states


def simulate_suspect(says, wrong):
    """Compared loosely: the right answer ends well before the stop, a wrong one may run into it."""
    return suspect(says, within=1e-4, simulate=lambda t, s, locked, **c: integrated(t, s, locked, wrong, **c))


def braked(t, start, locked, **car):
    return integrated(t, start, locked, derivative, **car)


def from_time_zero(t, start, locked, **car):
    return braked(t, braked(np.array([0.0, t[0]]), start, locked, **car)[1], locked, **car)


def loosely(t, start, locked, **car):
    """solve_ivp as it is when nothing is said of its tolerances."""
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda _, s: derivative(s, locked, **car), (t[0], t[-1]), start, t_eval=t).y.T


TIME_SUSPECTS = [
    *mistimed(braked, from_time_zero),
    suspect("the tolerances that solve_ivp has when none are given", simulate=loosely),  # its steps are the same
]

# Friction straight back jumps to and fro where the speed is zero, which an integrator would follow for minutes.
SIMULATE_SUSPECTS = [simulate_suspect(says, wrong) for says, wrong in WRONG_RATES.items() if "straight" not in says]
VELOCITY_SUSPECTS = [simulate_suspect(says, wrong) for says, wrong in WRONG_VELOCITIES.items()]


def scales(start, car):
    v = abs(start[3]) + abs(start[4]) * wheelbase(car)
    far = v * v / max(car["friction"] * car["gravity"], 0.1)
    return np.array([far, far, 1.0, v, v / wheelbase(car)])


@once
def braking(draw, count):
    """Calls to simulate that end before the speed passes zero, what is right, its scales and the kind of motion."""
    cases = []
    for locked, sign, share, kind in (("front", 1, 0.75, ""), ("rear", 1, 0.2, ""), ("rear", -1, 0.75, " in reverse")):
        c = car(draw)  # ahead of the free axle the locked one swings it round, and so backwards
        start = state(draw, c, sign * quick(draw), turning_a_little(draw))
        t = uneven(draw, share * stopped(start, locked, c)[0], count)
        expected = moved(t, start, locked, **c)
        cases.append((given(t, start, locked, **c), expected, scales(start, c), f"a locked {locked} axle{kind}"))
    return cases


COLUMNS = (
    ("the place", [0, 1], "of the distance that friction needs"),
    ("the heading", [2], "rad"),
    ("the speed", [3], "of that at the start"),
    ("the yaw rate", [4], "of the speed over the wheelbase"),
)


TOO_EARLY = {
    True: "it is taken for at rest and is not: a car in reverse moves, and so does one that turns on the spot",
    False: "speed and yaw rate are zero there, before it stops: is the time of the stop one since t[0] for you, or one "
    "on the clock of t? does it stop too early?",
}


STRAIGHT = "it goes straight on: a yaw rate that is small is not zero, and may grow"
NOT_AT_REST = "it stops where its speed passes zero, but it turns on there: at rest the yaw rate is zero, too"


def goes_straight(states):
    """Whether it moves and never turns."""
    return bool(states[1:, 3].any() and not states[1:, 4].any() and np.ptp(states[:, 2]) == 0)


def near_miss(states, expected, scale, hint):
    """What to say of a motion that ends early, or is right but for whole turns or its rows: `hint` if nothing."""
    if (states == states[0]).all():
        return "row 1 is the start again" if len(states) == 2 else "every row is the start again"
    if goes_straight(states) and not goes_straight(expected):
        return STRAIGHT
    stands = expected[:, 3:].any(axis=1) & ~states[:, 3:].any(axis=1)
    if stands.any():
        row = int(np.argmax(stands))
        turns_on = row and expected[row - 1, 3] * expected[row, 3] < 0
        return NOT_AT_REST if turns_on else TOO_EARLY[len(states) == 2]
    turns = np.rint((states - expected) / [np.inf, np.inf, 2 * math.pi, np.inf, np.inf])
    if turns.any() and np.max(np.abs(states - expected - 2 * math.pi * turns) / scale) <= SEEN:
        return "it is off by whole turns alone, as if the heading were wrapped; it is never wrapped"
    if len(states) > 2 and np.max(np.abs(states[:-1] - expected[1:]) / scale) <= SEEN:
        return "row i is the state at t[i + 1]: row 0 must be the start"
    return hint


def judge_runs(student, cases, hint, half=1e-3):
    """Compare simulations column by column, the worst first: half the points for errors below `half`."""
    found = student.simulate.many([call.on(kind) for call, *_, kind in cases])
    judged = []
    for states, (call, expected, scale, kind) in zip(found, cases, strict=True):
        look = partial(near_miss, states, expected, scale, hint)
        for name, at, unit in COLUMNS:
            error = np.max(np.abs(states - expected)[:, at] / scale[at])
            judged.append((error, states[:, at], expected[:, at], scale[at], name, unit, call, kind, look))
    for _, states, expected, scale, name, unit, call, kind, look in sorted(judged, key=lambda it: it[0], reverse=True):
        expect(
            states,
            expected,
            scale=scale,
            within=TRAJECTORY,
            of=name,
            unit=unit,
            t=call.args[0],
            kind=kind,
            hint=look,
            at=call,
            partial={half: 0.5},
        )


@check(points=1, part="a", suspects=TIME_SUSPECTS + SIMULATE_SUSPECTS + VELOCITY_SUSPECTS)
def simulate_brakes(student, draw):
    """simulate: braking with either axle locked, row i at t[i], row 0 the given state."""
    judge_runs(student, braking(draw, 100), "put `state_derivative` into an integrator; is its tolerance tight?")


@check(points=0.25, part="a", after=simulate_brakes, suspects=SIMULATE_SUSPECTS)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for."""
    judge_runs(student, braking(draw, 4), "the steps of the integration are not those of t")
    judge_runs(student, plain_runs(draw, True), "row 0 is the start, row 1 the state at the other time")
    judge_runs(student, nearly_straight(draw), "row 0 is the start, row 1 the state at the other time", 1e-5)
    first, *others = in_turn(draw)
    judge_runs(student, [first], "does `state_derivative` take it as it is?")
    judge_runs(student, others, "is something kept from one call to the next?")


RUNS = {
    True: (
        ("straight motion", forwards, nothing, {}),
        ("straight motion in reverse", backwards, nothing, {}),
        ("a turn on the spot", nothing, turning, {}),
        ("all parameters 1", quick, turning_a_little, ODD_CARS["all parameters 1"]),
    ),
    False: (
        ("straight motion, friction 0", forwards, nothing, {"friction": 0.0}),
        ("straight motion in reverse, gravity 0", backwards, nothing, {"gravity": 0.0}),
        ("a turn on the spot, friction 0", nothing, turning, {"friction": 0.0}),
    ),
}


@once
def plain_runs(draw, slowed):
    """As `braking`, at two times: straight on, or turning on the spot, slowed by friction or without it."""
    cases = []
    for kind, speed, yaw, fixed in RUNS[slowed]:
        for locked in ("front", "rear"):
            c = car(draw, **fixed)
            start = state(draw, c, speed(draw), yaw(draw))
            start[:3] *= draw.integers(0, 2)  # from the origin along x, or from anywhere
            v = abs(start[3]) + abs(start[4]) * wheelbase(c)
            t = uneven(draw, 0.3 * stopped(start, locked, c)[0] if slowed else wheelbase(c) / v, 2)
            expected = moved(t, start, locked, **c)
            cases.append((given(t, start, locked, **c), expected, scales(start, c), f"{kind}, a locked {locked} axle"))
    return cases


@once
def nearly_straight(draw):
    """As `braking`, at two times: above its critical speed a small yaw rate grows, and turns it by 1e-4 and more."""
    c = car(draw)
    start = state(draw, c, draw.uniform(1.5, 1.8), 0.0)
    start[4] = draw.choice([-1, 1]) * draw.uniform(2e-4, 3e-4)
    # friction slows it by less than friction * gravity, so it does not stop before
    t = uneven(draw, 0.7 * start[3] / (c["friction"] * c["gravity"]), 2)
    kind = "a small yaw rate, a locked rear axle"
    return [(given(t, start, "rear", **c), moved(t, start, "rear", **c), scales(start, c), kind)]


@once
def in_turn(draw):
    """As `braking`, a motion and others of which one thing alone is another: what is kept from a call is wrong then."""
    c = car(draw, friction=draw.uniform(1.2, 2))
    start, other_start = (state(draw, c, quick(draw), turning_a_little(draw)) for _ in range(2))
    # friction slows it by less than friction * gravity, so it does not stop before
    spans = 0.2 * usual(c) / (c["friction"] * c["gravity"]) * draw.uniform(0.8, 1.0, 2)
    t, other_t = (uneven(draw, span, 4) for span in spans)
    changed = {name: {**c, name: draw.uniform(1.2, 1.4) * c[name]} for name in ("friction", "yaw_inertia", "gravity")}
    calls = {
        "friction above 1, a locked rear axle": given(t, start, "rear", **c),
        f"{BUT_FOR}other times": given(other_t, start, "rear", **c),
        f"{BUT_FOR}another start": given(t, other_start, "rear", **c),
        f"{BUT_FOR}the other axle": given(t, start, "front", **c),
        **{f"{BUT_FOR}another {name}": given(t, start, "rear", **other) for name, other in changed.items()},
    }
    return [
        (call, moved(*call.args, **call.kwargs), scales(call.args[1], call.kwargs), kind)
        for kind, call in calls.items()
    ]


BUT_FOR = "the motion of a call before, but for "


def sleigh(t, start, locked, *, mass, yaw_inertia, front, rear):
    """Heading, speed and yaw rate without friction (Chaplygin), t = 0 at the start.

    With u = V cos psi and sqrt(J/m) r = V sin psi the energy is m V^2/2, and tan(psi/2) grows exponentially.
    """
    free = axles(locked, front, rear)[0]
    gyration = math.sqrt(inertia_about_free(locked, mass=mass, yaw_inertia=yaw_inertia, front=front, rear=rear) / mass)
    V, psi0 = math.hypot(start[3], gyration * start[4]), math.atan2(gyration * start[4], start[3])
    psi = 2 * np.arctan(math.tan(psi0 / 2) * np.exp(free * V / gyration**2 * t))
    heading = start[2] + (psi - psi0) * gyration / free
    return np.column_stack([heading, V * np.cos(psi), V * np.sin(psi) / gyration])


@check(points=0.5, part="a", after=simulate_brakes)
def simulate_glides_without_friction(student, draw):
    """simulate: without friction or gravity it keeps its energy, however slow, ends with G ahead of the free axle."""
    cases = []
    for locked, speed, fixed in (("front", backwards, {"friction": 0.0}), ("rear", forwards, {"gravity": 0.0})):
        c = car(draw, **fixed)
        start = state(draw, c, speed(draw), signed(draw, 0.1, 0.3))
        t = uneven(draw, 8 * wheelbase(c) / abs(start[3]), 60)
        expected, scale = np.zeros((60, 5)), scales(start, c)
        scale[:2] = np.inf  # the place is judged where it brakes
        expected[:, 2:] = sleigh(t - t[0], start, locked, **parts(c, *BODY))
        kind = f"{min(fixed)} 0, a locked {locked} axle"
        cases.append((given(t, start, locked, **c), expected, scale, kind))
    hint = "is the car stopped, or held straight, by anything but friction?"
    judge_runs(student, cases, hint)
    judge_runs(student, plain_runs(draw, False), hint)
    judge_slow(student, slow_glides(draw), "slow is not at rest: without friction it goes on for ever")


@once
def slow_glides(draw):
    """Calls, right states, scales, kinds: a few millimetres a second, above what may be called rest with friction."""
    cases = []
    for locked, sign, fixed in (("front", 1, {"friction": 0.0}), ("rear", -1, {"gravity": 0.0})):
        c = car(draw, **fixed)
        start = state(draw, c, 0.0, 0.0)
        start[3] = sign * draw.uniform(3e-3, 6e-3)
        start[4] = 0.5 * start[3] / wheelbase(c)
        t = uneven(draw, draw.uniform(10, 20), 4)
        far = (t[-1] - t[0]) * abs(start[3])
        scale = np.array([far, far, far / wheelbase(c), start[3], start[3] / wheelbase(c)])
        kind = f"a slow car, {min(fixed)} 0, a locked {locked} axle"
        cases.append((given(t, start, locked, **c), moved(t, start, locked, **c), np.abs(scale), kind))
    return cases


@once
def slow_brakes(draw):
    """As `slow_glides`, with friction: a fortieth of the usual speed, well above what may be called rest."""
    cases = []
    for locked, share in (("front", 0.6), ("rear", 0.2)):
        c = car(draw)
        slow = draw.uniform(0.02, 0.03)
        start = state(draw, c, slow, slow * turning_a_little(draw))
        start[:2] = 0.0  # at 5 m a relative tolerance of 1e-9 would be 1e-5 of the way to the stop
        t = uneven(draw, share * stopped(start, locked, c)[0], 4)
        far = start[3] ** 2 / (c["friction"] * c["gravity"])
        scale = np.array([far, far, far / wheelbase(c), start[3], start[3] / wheelbase(c)])
        cases.append(
            (given(t, start, locked, **c), moved(t, start, locked, **c), scale, f"a slow car, a locked {locked} axle")
        )
    return cases


def judge_slow(student, cases, otherwise):
    found = student.simulate.many([call.on(kind) for call, *_, kind in cases])
    for states, (call, expected, scale, kind) in zip(found, cases, strict=True):
        straight = goes_straight(states) and not goes_straight(expected)
        hint = STRAIGHT if straight else otherwise
        expect(
            states,
            expected,
            within=SLOW,
            scale=scale,
            of="the motion",
            unit="of the way that it goes",
            kind=kind,
            t=call.args[0],
            at=call,
            hint=hint,
        )


@once
def stops(draw):
    """Calls to simulate that go on beyond the stop, the right place and heading there, the rows after it, the kind."""
    cases = []
    for locked, speed, yaw, count, slippery, kind in (
        ("front", (0.7, 1.5), (0.2, 0.6), 40, 1.0, "a locked front axle"),
        ("rear", (-1.5, -0.7), (0.2, 0.6), 40, 1.0, "a locked rear axle, in reverse"),
        ("rear", (0.7, 1.5), (0.2, 0.6), 2, 1.0, "a locked rear axle, only two times asked for"),
        ("rear", (0.05, 0.2), (0.8, 1.2), 30, 0.03, "a locked rear axle, spinning on ice"),
        ("front", (0.05, 0.2), (0.8, 1.2), 2, 1.0, "a locked front axle, spinning, only two times asked for"),
    ):
        c = car(draw)
        start = state(draw, c, draw.uniform(*speed), signed(draw, *yaw))
        c["friction"] *= slippery
        latest, end = stopped(start, locked, c)
        t = uneven(draw, latest * (draw.uniform(1.8, 2.5) if count > 2 else 1.12), count)
        after = t - t[0] > (1.3 if count > 2 else 1.1) * latest
        cases.append((given(t, start, locked, **c), end[:3], after, scales(start, c), kind))
    return cases


def judge_start_at_rest(student, draw):
    c = car(draw)
    t, start = uneven(draw, 3.0, 10), state(draw, c, 0.0, 0.0)
    for locked in ("front", "rear"):
        kind = of_kind("a car at rest from the start", locked)
        states = student.on(kind).simulate(t, start, locked, **c)
        expect(
            states,
            np.tile(start, (10, 1)),
            within=FORMULA,
            of="the state",
            t=t,
            kind=kind,
            at=(start, c),
            hint="what is zero over zero?",
        )


# Part a and d: is it stable?


def growth(speed, locked, **car):
    """The yaw acceleration, odd in the yaw rate, differenced to fourth order."""
    step = 1e-3 * speed / wheelbase(car)
    once_, twice = (derivative([0, 0, 0, speed, k * step], locked, **car)[4] for k in (1, 2))
    return (8 * once_ - twice) / (6 * step)


def frictionless_growth(speed, locked, **car):
    return growth(speed, locked, **{**car, "friction": 0.0})


def arm_not_squared(speed, locked, **car):
    body = parts(car, *BODY)
    turning = car["mass"] * axles(locked, car["front"], car["rear"])[0] * speed
    drag = car["friction"] * load(locked, **parts(car, *LOAD))
    return (turning - drag * wheelbase(car) / speed) / inertia_about_free(locked, **body)


def arm_from_G(speed, locked, **car):
    """Friction's part by the distance from G to the locked axle."""
    turning = frictionless_growth(speed, locked, **car)
    share = (axles(locked, car["front"], car["rear"])[1] / wheelbase(car)) ** 2
    return turning + share * (growth(speed, locked, **car) - turning)


def never_stabilised(speed, locked, **car):
    turning = frictionless_growth(speed, locked, **car)
    return growth(speed, locked, **car) - turning + abs(turning)


def growth_with(rates):
    def yaw_growth_rate(speed, locked, **car):
        step = 1e-6 * speed / wheelbase(car)
        return rates(np.array([0, 0, 0, speed, step]), locked, **car)[4] / step

    return yaw_growth_rate


GROWTH_SUSPECTS = [
    suspect(says, within=1e-5, yaw_growth_rate=growth_with(wrong))
    for says, wrong in WRONG_RATES.items()
    if "square" not in says and "straight" not in says
] + [
    suspect("friction left out", yaw_growth_rate=frictionless_growth),
    suspect("the wheelbase where its square belongs", within=1e-5, yaw_growth_rate=arm_not_squared),
    suspect(
        "the distance from G to the locked axle, where the wheelbase belongs", within=1e-5, yaw_growth_rate=arm_from_G
    ),
    suspect("the part of the speed positive with either axle locked", within=1e-5, yaw_growth_rate=never_stabilised),
    suspect(
        "a growth rate below zero cut off to zero",
        within=1e-5,
        yaw_growth_rate=lambda *motion, **c: max(growth(*motion, **c), 0.0),
    ),
    suspect(
        "friction's part with the wrong sign",
        yaw_growth_rate=lambda speed, locked, **c: (
            2 * frictionless_growth(speed, locked, **c) - growth(speed, locked, **c)
        ),
    ),
]


@check(points=0.75, part="a", suspects=GROWTH_SUSPECTS)
def growth_rate_is_the_slope(student, draw):
    """yaw_growth_rate: how fast the yaw acceleration rises with a small yaw rate, at low and high speed."""
    kinds = ("front", {}), ("rear", {}), ("rear", {"friction": 0.0}), ("front", {"gravity": 0.0})
    cases = [(locked, car(draw, **fixed), "".join(f"{name} 0, " for name in fixed)) for locked, fixed in kinds * 3]
    cases += [(locked, c, f"{kind}, ") for locked, c, kind in odd_cars(draw)]
    calls = [
        given(draw.uniform(0.3, 3) * usual(c), locked, **c).on(f"{kind}a locked {locked} axle")
        for locked, c, kind in cases
    ]
    ones = "all parameters 1"
    calls += [given(1.0, axle, **ODD_CARS[ones]).on(of_kind(ones, axle)) for axle in ("front", "rear")]
    for found, call in zip(student.yaw_growth_rate.many(calls), calls, strict=True):
        c, (speed, locked) = call.kwargs, call.args
        quick = c["mass"] * wheelbase(c) ** 2 / inertia_about_free(locked, **parts(c, *BODY))
        scale = quick * (speed / wheelbase(c) + c["friction"] * c["gravity"] / speed)
        expect(
            found,
            growth(*call.args, **c),
            within=GROWTH,
            scale=scale,
            of="the growth rate",
            unit="of the size of its terms",
            kind=call.kind,
            at=call,
            hint="linearise at yaw_rate 0; friction's sideways part is linear in it too",
        )


def critical(locked, *, front, rear, friction, gravity):
    return math.sqrt(friction * gravity * (front + rear)) if locked == "rear" else math.inf


def lacking(*, friction, gravity, **_):
    return "" if friction and gravity else " without friction or gravity"


CRITICAL_SUSPECTS = [
    suspect(SWAPPED, critical_speed=lambda locked, **c: critical(other(locked), **c)),
    suspect(
        "the distance from G to an axle for the wheelbase",
        critical_speed=lambda locked, front, **c: critical(locked, front=front, **{**c, "rear": 0.0}),
    ),
    suspect(
        "0 where there is no friction, with the front locked too, where it never is unstable",
        critical_speed=lambda locked, **c: 0.0 if lacking(**c) else critical(locked, **c),
    ),
    suspect("the square of the speed", critical_speed=lambda locked, **c: critical(locked, **c) ** 2),
]


@check(points=0.5, part="a", suspects=CRITICAL_SUSPECTS)
def critical_speed_is_where_growth_begins(student, draw):
    """critical_speed: with the rear locked, that at which the growth rate is zero; with the front locked, math.inf."""
    names = ("front", "rear", "friction", "gravity")
    cars = [car(draw) for _ in range(6)] + [car(draw, friction=0.0), car(draw, gravity=0.0)]
    cars += [c for _, c, _ in odd_cars(draw)]
    calls = [given("rear", **parts(c, *names)) for c in cars]
    calls = [call.on(f"a locked rear axle{lacking(**call.kwargs)}") for call in calls]
    for found, call in zip(student.critical_speed.many(calls), calls, strict=True):
        right, kind = critical(*call.args, **call.kwargs), call.kind
        expect_that(
            math.isfinite(found),
            "critical_speed is infinite",
            kind=kind,
            at=call,
            hint="is it unstable at any speed at all there?",
        )
        expect(
            found,
            right,
            within=FORMULA,
            scale=right or 1.0,
            of="the critical speed",
            unit="of itself",
            kind=kind,
            at=call,
            hint="where is your growth rate zero?",
        )
    for c in (car(draw), *(c for _, c, _ in odd_cars(draw))):
        call = given("front", **parts(c, *names))
        kind = f"a locked front axle{lacking(**call.kwargs)}"
        found = student.on(kind).critical_speed(*call.args, **call.kwargs)
        expect_that(
            found == math.inf,
            "critical_speed is not math.inf",
            kind=kind,
            at=call,
            hint="can your growth rate be positive there?",
        )


def slowed(speed, speed0, yaw_rate0, locked, **car):
    """ln r changes by the integral of growth/u' over the speed; Gauss-Legendre in ln u."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    low, high = math.log(speed), math.log(speed0)
    speeds = np.exp((high + low) / 2 + (high - low) / 2 * nodes)
    rates = np.array([growth(u, locked, **car) for u in speeds])
    slowing = derivative([0, 0, 0, speed0, 0], locked, **car)[3]
    return yaw_rate0 * math.exp(-(high - low) / 2 * np.sum(weights * speeds * rates / slowing))


def power_law(speed, speed0, yaw_rate0, locked, **car):
    """Friction's part alone."""
    power = car["mass"] * wheelbase(car) ** 2 / inertia_about_free(locked, **parts(car, *BODY))
    return yaw_rate0 * (speed / speed0) ** power


def power_about_G(speed, speed0, yaw_rate0, locked, **car):
    """The power in friction's part with the inertia about G."""
    inertia = inertia_about_free(locked, **parts(car, *BODY))
    more = car["mass"] * wheelbase(car) ** 2 * (1 / car["yaw_inertia"] - 1 / inertia)
    return slowed(speed, speed0, yaw_rate0, locked, **car) * (speed / speed0) ** more


def always_growing(speed, speed0, yaw_rate0, locked, **car):
    """The part of the speed positive with either axle locked."""
    unit = speed, speed0, 1.0, locked
    without_friction = abs(math.log(slowed(*unit, **car) / power_law(*unit, **car)))
    return power_law(speed, speed0, yaw_rate0, locked, **car) * math.exp(without_friction)


def without_power_law(*motion, **car):
    speed, speed0, yaw_rate0, locked = motion
    unit = speed, speed0, 1.0, locked
    return yaw_rate0 * slowed(*unit, **car) / power_law(*unit, **car)


def constant_rate(at):
    """The growth rate of one speed, at(speed, speed0), all the time."""

    def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
        slowing = derivative([0, 0, 0, speed0, 0], locked, **car)[3]
        return yaw_rate0 * math.exp(growth(at(speed, speed0), locked, **car) * (speed - speed0) / slowing)

    return small_yaw_rate


SLOWED_SUSPECTS = [
    suspect(SWAPPED, small_yaw_rate=lambda u, u0, r0, locked, **c: slowed(u, u0, r0, other(locked), **c)),
    suspect("friction's part alone", small_yaw_rate=power_law),
    suspect("friction's part left out", small_yaw_rate=without_power_law),
    suspect(
        "the inertia about G in friction's part, where that about the free axle belongs", small_yaw_rate=power_about_G
    ),
    suspect("the part of the speed positive with either axle locked", small_yaw_rate=always_growing),
    suspect(
        "the growth rate of the first speed at every speed", small_yaw_rate=constant_rate(lambda speed, speed0: speed0)
    ),
    suspect(
        "the growth rate of the last speed at every speed", small_yaw_rate=constant_rate(lambda speed, speed0: speed)
    ),
    suspect(
        "the growth rate of the speed half way at every speed",
        small_yaw_rate=constant_rate(lambda speed, speed0: (speed + speed0) / 2),
    ),
    suspect("the yaw rate without its sign", small_yaw_rate=lambda *motion, **c: abs(slowed(*motion, **c))),
    suspect(
        "the growth with the wrong sign: the speed falls",
        small_yaw_rate=lambda u, u0, r0, locked, **c: slowed(u0, u, r0, locked, **c),
    ),
]


@once
def slowing(draw):
    """Calls to small_yaw_rate and what is right."""
    calls = []
    for locked in ("front", "rear") * 4:
        c = car(draw)
        speed0 = draw.uniform(0.7, 1.8) * usual(c)
        calls.append(given(draw.uniform(0.1, 0.7) * speed0, speed0, signed(draw, 0.01, 2), locked, **c))
    plain = [(locked, c) for locked, c, kind in odd_cars(draw) if c["friction"] * c["gravity"]]
    for locked, c in plain:
        for fast, slow, yaw in ((1.0, 1.0, 0.3), (1.0, 0.4, 0.0), (1.0, 1.0, 0.0), (0.8, 0.5, 1.0)):
            calls.append(given(slow * usual(c), fast * usual(c), yaw, locked, **c))
        calls.append(given(1.0, 2.0, -1.0, locked, **c))
    return [(call.on(kind_of_slowing(*call.args)), slowed(*call.args, **call.kwargs)) for call in calls]


def kind_of_slowing(speed, speed0, yaw_rate0, locked):
    special = {
        "a speed that has not fallen yet": speed == speed0,
        "no yaw rate": yaw_rate0 == 0,
        "a negative yaw rate": yaw_rate0 < 0,
        "a positive yaw rate": yaw_rate0 > 0,
    }
    return ", ".join([says for says, it in special.items() if it] + [f"a locked {locked} axle"])


@check(points=0.75, part="d", suspects=SLOWED_SUSPECTS)
def small_yaw_rate_is_the_linear_solution(student, draw):
    """small_yaw_rate: the linear equation, solved exactly over the falling speed."""
    cases = slowing(draw)
    for found, (call, expected) in zip(student.small_yaw_rate.many([call for call, _ in cases]), cases, strict=True):
        expect(
            found,
            expected,
            within=SMALL_YAW,
            scale=abs(expected) or 1.0,
            of="the yaw rate",
            unit="of itself",
            at=call,
            kind=call.kind,
            hint="divide the yaw acceleration by the rate of speed: time is gone; separate, integrate",
        )


OTHERS = ("both", "", "Front", "r", "front rear", None)


@check(points=0.25, part="a")
def mechanics_refuses_other_axles(student, draw):
    """axle_load, friction_force, state_derivative, kinetic_energy, simulate: ValueError for another `locked`."""
    c = car(draw)
    s, t = state(draw, c, 1.0, 0.5), np.array([0.0, 0.1])
    student.axle_load("front", **parts(c, *LOAD))  # what gives no number for an axle earns nothing
    refuses_others(student, "axle_load", lambda locked: given(locked, **parts(c, *LOAD)))
    refuses_others(student, "friction_force", lambda locked: given(s, locked, **parts(c, *FORCE)))
    refuses_others(student, "state_derivative", lambda locked: given(0.0, s, locked, **c))
    refuses_others(student, "kinetic_energy", lambda locked: given(s, locked, **parts(c, *BODY)))
    refuses_others(student, "simulate", lambda locked: given(t, s, locked, **c))
    rest = state(draw, c, 0.0, 0.0)  # where it is as wrong
    for name, call in (
        ("friction_force", lambda locked: given(rest, locked, **parts(c, *FORCE))),
        ("state_derivative", lambda locked: given(0.0, rest, locked, **c)),
        ("kinetic_energy", lambda locked: given(rest, locked, **parts(c, *BODY))),
        ("simulate", lambda locked: given(t, rest, locked, **c)),
    ):
        refuses_others(student, name, call, ("both",), ", a car at rest")


@check(points=0.25, part="a")
def stability_refuses_other_axles(student, draw):
    """yaw_growth_rate, critical_speed, small_yaw_rate: ValueError for another `locked`."""
    c = car(draw)
    names = "front", "rear", "friction", "gravity"
    student.critical_speed("front", **parts(c, *names))
    refuses_others(student, "yaw_growth_rate", lambda locked: given(2.0, locked, **c))
    refuses_others(student, "critical_speed", lambda locked: given(locked, **parts(c, *names)))
    refuses_others(student, "small_yaw_rate", lambda locked: given(1.0, 2.0, 0.1, locked, **c))


def refuses_others(student, name, call, asked=("front", "rear", *OTHERS), at_rest=""):
    """A function that refuses the axles, too, has not earned it."""
    for locked in asked:
        it, right = call(locked), locked not in ("front", "rear")
        kind = f'a `locked` that is neither "front" nor "rear", {locked!r}' if right else f"a locked {locked} axle"
        kind += at_rest
        refused = getattr(student.on(kind), name).refuses(*it.args, **it.kwargs)
        says = "does not raise ValueError" if right else "raises ValueError"
        expect_that(refused == right, f"{name} {says}", kind=kind, at=it)


# Last: a student whose integrator never gets past the stop shall lose nothing else by it.


def unrest(states, start, hint):
    """What to say of the rows after the stop, in their scales: `hint` if there is no more to see."""
    if not states.any():
        return "place and heading are zero there; they stay what they are where it stops"
    if len(states) > 1 and (states[:, 3] * start[3] < 0).all():
        return "it goes back after the stop"
    if np.ptp(states[:, :3], axis=0).max() <= STOPPED:
        return hint
    if states[:, 3:].any():
        return "speed and yaw rate are small there but never zero, and place or heading goes on: find the stop itself"
    return "speed and yaw rate are zero there, and yet place or heading goes on"


@check(points=0.75, part="a", after=simulate_brakes)
def simulate_comes_to_rest_and_stays(student, draw):
    """simulate: a car that has come to rest stays where it is, in place and heading; one at rest does not start.

    A slow one is not at rest.
    """
    cases = stops(draw)
    judge_slow(student, slow_brakes(draw), "slow is not at rest: it has a way to go before it stops")
    found = student.simulate.many([call.on(kind) for call, *_, kind in cases])
    for states, (call, place, after, scale, kind) in zip(found, cases, strict=True):
        later = call.args[0][after]
        look = partial(unrest, states[after] / scale, call.args[1])
        expect(
            states[after, 3:] / scale[3:],
            np.zeros((after.sum(), 2)),
            within=AT_REST,
            of="speed or yaw rate",
            unit="of that at the start",
            t=later,
            kind=kind,
            at=call,
            hint=partial(look, "find the time at which it stops; from then on nothing changes"),
        )
        expect(
            states[after, :3] / scale[:3],
            np.tile(place / scale[:3], (after.sum(), 1)),
            within=STOPPED,
            of="place or heading, in its scale,",
            t=later,
            kind=kind,
            at=call,
            hint=partial(look, "is it where it stops, and does it stay there?"),
        )
    judge_start_at_rest(student, draw)
