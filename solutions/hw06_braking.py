"""hw06: A car going straight ahead with the brakes of one axle locked: does it stay straight?

figure.svg, beside this file, shows the axes, the names and the positive senses.

The ground plane is x, y; heading is the angle from the x axis to the car's forward direction, counter-clockwise
positive, never wrapped. G is on the centreline, at ground height, `front` behind the front axle and `rear` ahead of
the rear one. The free axle rolls and does not slip sideways; the locked axle drags, as one point on the centreline,
with Coulomb friction: `friction` times its static load, against the velocity of that point. `locked` is "front" or
"rear".

state = x, y of G; heading; speed, the forward component of velocity, the same for all points of the centreline,
negative in reverse; yaw_rate, the rate of heading.
"""

import math

import numpy as np

__all__ = [
    "axle_load",
    "critical_speed",
    "free_body_diagram",
    "friction_force",
    "kinetic_energy",
    "simulate",
    "small_yaw_rate",
    "state_derivative",
    "yaw_growth_rate",
]


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    """The forces on the car in the plane of the ground, seen from above.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known, both along x and y of the ground. The order
    is free.
    Raises ValueError for another `locked`.
    """
    x, y, heading, _, _ = state
    numbers = {"mass": mass, "front": front, "rear": rear, "friction": friction, "gravity": gravity}
    along, aside = friction_force(state, locked, **numbers)
    free, arm = _axles(locked, front, rear)
    forward, sideways = (np.array([math.cos(angle), math.sin(angle)]) for angle in (heading, heading + math.pi / 2))
    at_free, at_locked = (np.array([x, y]) + distance * forward for distance in (free, free + arm))
    return [(at_locked, along * forward + aside * sideways), (at_free, sideways)]


def axle_load(locked, *, mass, front, rear, gravity):
    """Load that the locked axle carries.

    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    gravity     : m/s^2, may be 0
    Returns N.
    Raises ValueError for another `locked`.
    """
    free, arm = _axles(locked, front, rear)
    return mass * gravity * abs(free / arm)


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    """Force of the ground on the car at the locked axle, against its velocity; zero at rest.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (2,): forward and left components, N.
    Raises ValueError for another `locked`.
    """
    arm = _axles(locked, front, rear)[1]
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return np.array(_drag_force(*state[3:], arm=arm, drag=drag))


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Rates of x, y, heading, speed and yaw_rate; all zero at rest.

    t           : s, not used
    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (5,).
    Raises ValueError for another `locked`.
    """
    surface = {"friction": friction, "gravity": gravity}
    forward, sideways = friction_force(state, locked, mass=mass, front=front, rear=rear, **surface)
    car = _car(locked, mass, yaw_inertia, front, rear, 0.0, gravity)  # it glides, but for that force
    force = np.array([0.0, 0.0, 0.0, forward / mass, car["arm"] * sideways / car["inertia"]])
    return _rates(t, state, **car) + force


def simulate(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Motion from `state` at t[0]; a car that has come to rest stays.

    t           : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (n, 5); row i is the state at t[i].
    Raises ValueError for another `locked`.
    """
    from tam570.integrate import solve

    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    since = t - t[0]
    stop = _stopping_time(state, since[-1], car)
    if stop == 0:
        return np.tile(np.asarray(state, float), (len(t), 1))
    brink = min(since[-1], _BRINK * stop)
    times = np.append(since[since < brink], brink)
    numbers = solve(_rates, times, state, parameters=car, rtol=1e-13)
    rows = numbers[np.minimum(np.arange(len(t)), len(times) - 1)]
    rows[:, 3:] *= _share_of_speed(since, stop)[:, None]
    return rows


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    """Kinetic energy of the car.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    Returns J.
    Raises ValueError for another `locked`.
    """
    speed, yaw_rate = state[3:]
    sideways = -_axles(locked, front, rear)[0] * yaw_rate
    return (mass * (speed**2 + sideways**2) + yaw_inertia * yaw_rate**2) / 2


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """d(yaw acceleration)/d(yaw_rate) about straight motion: positive where a small yaw rate grows.

    speed       : m/s, > 0
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns 1/s.
    Raises ValueError for another `locked`.
    """
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    turning, wheelbase = mass * car["free"] * speed, front + rear
    return (turning - car["drag"] * wheelbase**2 / speed) / car["inertia"]


def critical_speed(locked, *, front, rear, friction, gravity):
    """Speed above which straight motion is unstable; math.inf where it never is.

    locked      : "front" or "rear"
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns m/s; 0 for locked rear wheels without friction.
    Raises ValueError for another `locked`.
    """
    free, arm = _axles(locked, front, rear)
    return math.sqrt(friction * gravity * abs(arm)) if free > 0 else math.inf


def small_yaw_rate(speed, speed0, yaw_rate0, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Yaw rate at `speed` of a car that had yaw_rate0 at speed0, exact by the equations linear in the yaw rate.

    speed       : m/s, 0 < speed <= speed0
    speed0      : m/s
    yaw_rate0   : rad/s
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, > 0
    gravity     : m/s^2, > 0
    Returns rad/s.
    Raises ValueError for another `locked`.
    """
    # dr/du = r'/u' with u' = -drag/mass is linear in r: two terms of ln r, one in ln u and one in u^2.
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    power = mass * (front + rear) ** 2 / car["inertia"]
    lost = mass * (speed0 - speed) * (speed0 + speed) / 2  # J
    growth = mass * car["free"] * lost / (car["drag"] * car["inertia"])
    return yaw_rate0 * math.exp(growth + power * math.log(speed / speed0))


_LAST = 1e-10  # share of the time to the stop in which the car is taken to slow at a constant rate
_BRINK = 1 - _LAST  # share of it in which the equations of motion are integrated
_FOLDS = 40  # e^-40 of the speed is below its rounding


def _axles(locked, front, rear):
    """Position of the free axle, forward of G, and of the locked one, forward of the free."""
    if locked not in ("front", "rear"):
        raise ValueError(f'locked is "front" or "rear", not {locked!r}')
    return (-rear, front + rear) if locked == "front" else (front, -front - rear)


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    """What the equations need: inertia is that about the free axle, drag the largest friction force."""
    free, arm = _axles(locked, front, rear)
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return {"mass": mass, "inertia": yaw_inertia + mass * free**2, "free": free, "arm": arm, "drag": drag}


def _drag_force(speed, yaw_rate, *, arm, drag):
    sliding = _sliding_speed(speed, yaw_rate, arm) + 1e-300  # at rest too a direction: none
    return -drag * (speed / sliding), -drag * (arm * yaw_rate / sliding)


def _sliding_speed(speed, yaw_rate, arm):
    """Of the locked axle: it moves to the left only by turning about the free one."""
    return math.hypot(speed, arm * yaw_rate)


def _accelerations(speed, yaw_rate, *, mass, inertia, free, arm, drag):
    """Rates of speed and yaw rate: forces forward, and moments about the free axle."""
    forward, sideways = _drag_force(speed, yaw_rate, arm=arm, drag=drag)
    return (forward / mass - free * yaw_rate * yaw_rate, (arm * sideways + mass * free * speed * yaw_rate) / inertia)


def _rates(t, state, *, free, **car):
    x, y, heading, speed, yaw_rate = state
    sideways = -free * yaw_rate  # of G
    c, s = math.cos(heading), math.sin(heading)
    return (
        speed * c - sideways * s,
        speed * s + sideways * c,
        yaw_rate,
        *_accelerations(speed, yaw_rate, free=free, **car),
    )


def _stopping_time(state, until, car):
    """Time to come to rest; infinite if it is beyond `until`."""
    # With v^2 = 2 T/mass the power of friction gives v' = -drag/mass S/v. S is the sliding speed, and S/v is
    # between 1 and the root of this ratio: that bounds the time from below, and how v falls in slowed time.
    ratio = car["mass"] * car["arm"] ** 2 / car["inertia"]
    v = math.hypot(state[3], abs(car["arm"]) * state[4] / math.sqrt(ratio))
    slowing = car["drag"] / car["mass"]
    if v == 0.0 or v > until * slowing * math.sqrt(max(1.0, ratio)):
        return math.inf if v else 0.0
    return _time_at_rest(state[3:], _FOLDS / (slowing * min(1.0, ratio)), car)


def _time_at_rest(motion, slowed_time, car):
    """Time after a slowed time, which runs at 1/S of the pace of time: in it the stop is an exponential decay."""
    from tam570.integrate import solve

    start = (*motion, 0.0)
    return float(solve(_slowed_rates, (0.0, slowed_time), start, parameters=car, rtol=1e-13)[-1, 2])


def _slowed_rates(_, state, *, arm, **car):
    speed, yaw_rate, t = state
    sliding = _sliding_speed(speed, yaw_rate, arm)
    slowing, turning = _accelerations(speed, yaw_rate, arm=arm, **car)
    return sliding * slowing, sliding * turning, sliding


def _share_of_speed(since, stop):
    """1 before the last moment, then down to 0 at the stop at a constant rate."""
    if stop == math.inf:
        return np.ones(len(since))
    return np.clip((stop - since) / (_LAST * stop), 0.0, 1.0)
