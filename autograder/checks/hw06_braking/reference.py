"""Reference functions of hw06, in the car's axes, with the free axle's side force as an unknown.

A velocity or force has the components (forward, left); the position of an axle is its distance forward of G.
"""

import cmath
import math
from functools import partial
from math import cos, hypot, sin

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import Force, FreeBody, NotAForce


def axles(locked, front, rear):
    """Return the positions of the free and of the dragging axle."""
    return (-rear, front) if locked == "front" else (front, -rear)


def wheelbase(car):
    return car["front"] + car["rear"]


def axle_load(locked, *, mass, front, rear, gravity):
    """Balance the moments of the weight and of this load about the other axle."""
    free, dragging = axles(locked, front, rear)
    return mass * gravity * (0 - free) / (dragging - free)


def velocity_of(point, state, locked, front, rear):
    """Return the velocity of a point of the centreline, forward and left; that of the free axle has no left part."""
    return state[3], (point - axles(locked, front, rear)[0]) * state[4]


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    forward, left = velocity_of(axles(locked, front, rear)[1], state, locked, front, rear)
    size = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    sliding = hypot(forward, left) + 1e-300  # at rest it has no direction
    return -size * forward / sliding, -size * left / sliding


def state_derivative(t, state, locked, *, yaw_inertia, **car):
    """Use F = m a and moments about G; the side force keeps the free axle from slipping."""
    mass, (free, dragging) = car["mass"], axles(locked, car["front"], car["rear"])
    heading, (forward, left), yaw_rate = state[2], velocity_of(0.0, state, locked, car["front"], car["rear"]), state[4]
    along, aside = friction_force(state, locked, **car)
    # without the side force, the free axle lacks this much sideways acceleration to have none
    lacking = yaw_rate * forward - aside / mass - free * dragging * aside / yaw_inertia
    side = lacking / (1 / mass + free**2 / yaw_inertia)
    slowing, turning = along / mass + yaw_rate * left, (dragging * aside + free * side) / yaw_inertia
    east, north = forward * cos(heading) - left * sin(heading), forward * sin(heading) + left * cos(heading)
    return np.array([east, north, yaw_rate, slowing, turning])


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    return (mass * hypot(*velocity_of(0.0, state, locked, front, rear)) ** 2 + yaw_inertia * state[4] ** 2) / 2


def ease_of_turning(locked, *, mass, yaw_inertia, front, rear, **_):
    """Return m wheelbase^2 over the inertia about the free axle, which may be less."""
    return mass * (front + rear) ** 2 / (yaw_inertia + mass * axles(locked, front, rear)[0] ** 2)


def stopped(start, locked, car):
    """Return the time from the start to the stop, and the state there, both to 1e-7.

    With a time that runs as fast as the car slides, d tau = sliding dt, nothing is singular. The inertia about the
    free axle is below mass wheelbase^2 (as G is between the axles, and by the cases' choice of yaw_inertia), so the
    energy is below mass sliding^2/2, and friction takes at least 2 friction load/mass of it for each unit of tau.
    """
    free, dragging = axles(locked, car["front"], car["rear"])

    def slowed(_, s):
        sliding = hypot(*velocity_of(dragging, s, locked, car["front"], car["rear"]))
        return [sliding * rate for rate in (*state_derivative(0.0, s[:5], locked, **car), 1.0)]

    decays = 16 * (free - dragging) / (car["friction"] * car["gravity"] * free)  # to exp(-16) of the speed
    *state, time = solve(slowed, [0.0, decays], [*start, 0.0], rtol=1e-9, method="python")[-1]
    return time, np.array([*state[:3], 0.0, 0.0])


def simulate(t, start, locked, **car):
    """Return (n, 5) states at the times t; from the stop on, the car is at rest."""
    latest, end = stopped(start, locked, car) if car["friction"] * car["gravity"] else (math.inf, start)
    states = np.tile(end, (len(t), 1))
    states[0] = start
    moves = t - t[0] < latest * (1 - 1e-4)  # in the rest of the time it moves by 1e-8 of its way
    if moves[1:].any():
        rates = partial(state_derivative, locked=locked, **car)
        states[moves] = solve(rates, t[moves], start, rtol=1e-11, method="python")
    return states


def yaw_growth_rate(speed, locked, **car):
    """Difference the yaw acceleration, which is odd in the yaw rate, to fourth order."""
    step = 1e-3 * speed / wheelbase(car)
    single, twice = (state_derivative(0, [0, 0, 0, speed, k * step], locked, **car)[4] for k in (1, 2))
    return (8 * single - twice) / (6 * step)


def critical_speed(locked, *, front, rear, friction, gravity):
    return math.sqrt(friction * gravity * (front + rear)) if locked == "rear" else math.inf


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    """Integrate growth/u' over the speed, by which ln r changes: Gauss-Legendre in ln u, for which NumPy suffices."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    half = math.log(speed / speed0) / 2
    slowing = state_derivative(0, [0, 0, 0, speed0, 0], locked, **car)[3]
    changes = [u * yaw_growth_rate(u, locked, **car) / slowing for u in speed0 * np.exp(half * (1 + nodes))]
    return yaw_rate0 * math.exp(half * np.dot(weights, changes))


WITH_THE_VELOCITY = "You drew the drag along the velocity of the locked axle: this is the force on the ground."
ON_THE_FREE_WHEEL = "You drew friction on the free axle. It rolls: the ground pushes it only sideways."
ONLY_BACKWARDS = "You drew the drag along the car. The locked axle slides sideways, too: drag opposes its velocity."
IN_THE_AXES_OF_THE_CAR = "You wrote forward and left components. The diagram has the x and y axes of the ground."
SIDE_FORCE_OF_THE_LOCKED = "You drew a side force at the locked axle. It slides: friction is all, against its velocity."


def free_body_diagram(state, locked, mass, front, rear, friction, gravity, drag=None):
    """Return the car from above and its forces; `drag` (forward, left) replaces the right one."""
    x, y, heading, speed, yaw_rate = map(float, state)
    G, forward = complex(x, y), cmath.exp(1j * heading)
    free, locked_axle = (G + at * forward for at in axles(locked, front, rear))
    slide = complex(*velocity_of(axles(locked, front, rear)[1], state, locked, front, rear)) if drag is None else -drag
    drags = friction * gravity != 0 and slide != 0
    # straight ahead nothing turns the car; on the spot and without drag the free axle does not accelerate
    turns = yaw_rate != 0 and (speed != 0 or drags)
    at_locked, at_free, against, side, along, car, corner, other = (
        [z.real, z.imag]
        for z in (
            locked_axle,
            free,
            -slide * forward,
            1j * forward,
            forward,
            -slide,
            G + front * forward,
            G - rear * forward,
        )
    )
    drag = Force("the drag", at_locked, "the locked axle", against, sense=True, acts=drags, reversed=WITH_THE_VELOCITY)
    wrong = (
        NotAForce(ON_THE_FREE_WHEEL, at_free, along),
        NotAForce(ON_THE_FREE_WHEEL, at_free, against),
        NotAForce(IN_THE_AXES_OF_THE_CAR, at_locked, car),
        NotAForce(IN_THE_AXES_OF_THE_CAR, at_free, (0.0, 1.0)),
        NotAForce(ONLY_BACKWARDS, at_locked, along),
        NotAForce(SIDE_FORCE_OF_THE_LOCKED, at_locked, side),
    )
    forces = drag, Force("the side force", at_free, "the free axle", side, acts=turns)
    return FreeBody("the car", forces, wrong=wrong, outline=[[other, corner]])
