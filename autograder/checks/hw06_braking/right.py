"""What is right in hw06, found in the ground's axes with the free axle's side force as a Lagrange multiplier.

Forces and velocities in the car's axes are (forward, left) pairs; axles are at distances forward of G.
"""

import math

import numpy as np

from tam570.integrate import solve


def axles(locked, front, rear):
    """Positions of the free and of the dragging axle."""
    return (-rear, front) if locked == "front" else (front, -rear)


def wheelbase(car):
    return car["front"] + car["rear"]


def axle_load(locked, *, mass, front, rear, gravity):
    """By the moments of the weight and of this load about the other axle."""
    free, dragging = axles(locked, front, rear)
    return mass * gravity * (0 - free) / (dragging - free)


def velocity_of(point, state, locked, front, rear):
    """Of a point of the centreline: the free axle has none to the left."""
    speed, yaw_rate = state[3:]
    return float(speed), float((point - axles(locked, front, rear)[0]) * yaw_rate)


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    velocity = velocity_of(axles(locked, front, rear)[1], state, locked, front, rear)
    fast = math.hypot(*velocity)
    return tuple(-size * v / fast for v in velocity) if fast else (0.0, 0.0)


def state_derivative(t, state, locked, *, yaw_inertia, **car):
    """F = m a, moments about G, and the free axle's sideways velocity stays zero, by a Lagrange multiplier."""
    mass, (free, dragging) = car["mass"], axles(locked, car["front"], car["rear"])
    heading, yaw_rate = float(state[2]), float(state[4])
    c, s = math.cos(heading), math.sin(heading)
    forward, left = velocity_of(0.0, state, locked, car["front"], car["rear"])
    along, aside = friction_force(state, locked, **car)
    fx, fy, moment = along * c - aside * s, along * s + aside * c, dragging * aside
    # the sideways velocity of the free axle is -s vx + c vy + free yaw_rate; what its rate lacks, the multiplier adds
    lacking = yaw_rate * forward - (c * fy - s * fx) / mass - free * moment / yaw_inertia
    multiplier = lacking / (1 / mass + free**2 / yaw_inertia)
    ax, ay = (fx - s * multiplier) / mass, (fy + c * multiplier) / mass
    turning = (moment + free * multiplier) / yaw_inertia
    slowing = ax * c + ay * s + yaw_rate * left
    return np.array([forward * c - left * s, forward * s + left * c, yaw_rate, slowing, turning])


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    forward, left = velocity_of(0.0, state, locked, front, rear)
    return (mass * (forward**2 + left**2) + yaw_inertia * state[4] ** 2) / 2


def ease_of_turning(locked, *, mass, yaw_inertia, front, rear, **_):
    """m wheelbase^2 over the inertia about the free axle, which may be less."""
    return mass * (front + rear) ** 2 / (yaw_inertia + mass * axles(locked, front, rear)[0] ** 2)


def stopped(start, locked, car):
    """Time of the stop since the start, and the state there, both to 1e-7.

    In a time that runs as fast as the car slides, d tau = sliding dt, nothing is singular. The inertia about the
    free axle is below mass wheelbase^2 (as G is between the axles, and by the draw of yaw_inertia), the energy
    so below mass sliding^2/2, and friction takes at least 2 friction load/mass of it for each unit of tau.
    """

    dragging = axles(locked, car["front"], car["rear"])[1]

    def slowed(_, s):
        speed = math.hypot(*velocity_of(dragging, s[:5], locked, car["front"], car["rear"]))
        return *(speed * rate for rate in state_derivative(0.0, s[:5], locked, **car)), speed

    load = axle_load(locked, **{name: car[name] for name in ("mass", "front", "rear", "gravity")})
    decays = 16 * car["mass"] / (car["friction"] * load)  # to exp(-16) of the speed
    *state, time = solve(slowed, [0.0, decays], [*start, 0.0], rtol=1e-9, method="python")[-1]
    return time, np.array([*state[:3], 0.0, 0.0])


def simulate(t, start, locked, **car):
    """(n, 5) states at the times t; from the stop on it rests."""
    if not start[3:].any():
        return np.tile(start, (len(t), 1))
    brakes = car["friction"] * car["gravity"]
    latest, end = stopped(start, locked, car) if brakes else (math.inf, start)
    moves = t - t[0] < latest * (1 - 1e-4)  # in the rest of the time it goes 1e-8 of its way
    moves[0] = True
    states = np.tile(end, (len(t), 1))
    if moves.sum() > 1:
        states[moves] = solve(
            lambda t, s: state_derivative(t, s, locked, **car), t[moves], start, rtol=1e-11, method="python"
        )
    states[0] = start
    return states


def yaw_growth_rate(speed, locked, **car):
    """The yaw acceleration, odd in the yaw rate, differenced to fourth order."""
    step = 1e-3 * speed / wheelbase(car)
    single, twice = (state_derivative(0, [0, 0, 0, speed, k * step], locked, **car)[4] for k in (1, 2))
    return (8 * single - twice) / (6 * step)


def critical_speed(locked, *, front, rear, friction, gravity):
    return math.sqrt(friction * gravity * (front + rear)) if locked == "rear" else math.inf


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    """ln r changes by the integral of growth/u' over the speed; Gauss-Legendre in ln u."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    low, high = math.log(speed), math.log(speed0)
    speeds = np.exp((high + low) / 2 + (high - low) / 2 * nodes)
    rates = np.array([yaw_growth_rate(u, locked, **car) for u in speeds])
    slowing = state_derivative(0, [0, 0, 0, speed0, 0], locked, **car)[3]
    return yaw_rate0 * math.exp(-(high - low) / 2 * np.sum(weights * speeds * rates / slowing))
