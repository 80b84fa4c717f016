"""Plain Python: one function for e^z and its remainders, bisections, Dormand's and Prince's steps."""

import math
from itertools import pairwise

WEIGHTS = (
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)  # Dormand and Prince 1980; the last row is the step
ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)


def remainder(order, z):
    """(e^z less its series before z^order) / z^order: 1 at order 0, then 1, 1/2, 1/6 at z = 0; z <= 0 or small."""
    if order == 0:
        return math.exp(z)
    if abs(z) > 1:
        return (remainder(order - 1, z) - 1 / math.factorial(order - 1)) / z
    return math.fsum(z**n / math.factorial(n + order) for n in range(20))


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = (float(one) for one in state)
    return [vx, vy, -drag * vx / mass, -gravity - drag * vy / mass]


def step(state, h, first, rates):
    """The state after h, the rates there, and the largest error estimates."""
    slopes = [first]
    for row in WEIGHTS:
        moved = [
            one + h * math.fsum(w * slope[i] for w, slope in zip(row, slopes, strict=True))
            for i, one in enumerate(state)
        ]
        slopes.append(rates(moved))
    errors = [h * math.fsum(w * slope[i] for w, slope in zip(ERROR, slopes, strict=True)) for i in range(4)]
    return moved, slopes[-1], errors


def simulate(t, speed, angle, *, mass, drag, gravity):
    def rates(state):
        return state_derivative(0.0, state, mass=mass, drag=drag, gravity=gravity)

    t = [float(one) for one in t]
    state = [0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle)]
    slope, rows, h = rates(state), [state], (t[1] - t[0]) / 10
    span, fastest = t[-1] - t[0], speed + gravity * (t[-1] - t[0])
    scales = [fastest * min(span, mass / drag if drag else span)] * 2 + [fastest] * 2
    for now, end in pairwise(t):
        while now < end:
            last = now + h >= end
            size = end - now if last else h
            moved, later, errors = step(state, size, slope, rates)
            error = (
                max(abs(one) / scale for one, scale in zip(errors, scales, strict=True)) if fastest else 0.0
            )
            if error <= 1e-12:
                state, slope, now = moved, later, end if last else now + size
            grown = size * min(4.0, max(0.2, 0.9 * (1e-12 / (error + 1e-30)) ** 0.2))
            h = max(h, grown) if last and error <= 1e-12 else grown
        rows.append(state)
    return rows


def trajectory(t, speed, angle, *, mass, drag, gravity):
    vx, vy, rows = speed * math.cos(angle), speed * math.sin(angle), []
    for one in t:
        since, z = float(one), -drag * float(one) / mass
        left, mean, late = (remainder(order, z) for order in range(3))
        fallen = gravity * since * mean
        rows.append(
            (vx * since * mean, vy * since * mean - gravity * since**2 * late, vx * left, vy * left - fallen)
        )
    return rows


def flight_time(speed, angle, *, mass, drag, gravity):
    """vy/g = t late(-ct/m)/mean(-ct/m), which is between t/2 and t and grows with t."""
    low = speed * math.sin(angle) / gravity
    high, climb = 2 * low, low
    for _ in range(60):
        t = (low + high) / 2
        z = -drag * t / mass
        above = t * remainder(2, z) < climb * remainder(1, z)
        low, high = (t, high) if above else (low, t)
    return (low + high) / 2


def horizontal_range(speed, angle, *, mass, drag, gravity):
    t = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * t * remainder(1, -drag * t / mass)


def best_angle(speed, *, mass, drag, gravity):
    """At the longest range the velocities of launch and landing are perpendicular."""

    def forwards(angle):
        t = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
        z = -drag * t / mass
        return speed * remainder(0, z) > gravity * t * remainder(1, z) * math.sin(angle)

    low, high = 1e-200, math.pi / 2
    while high - low > 1e-12 * high:
        middle = math.sqrt(low) * math.sqrt(high) if high > 2 * low else (low + high) / 2
        low, high = (middle, high) if forwards(middle) else (low, middle)
    return high


def limit_shape(angle):
    """Along the launch until the drag has stopped it, then down."""
    return [(0.0, 0.0), (math.cos(angle), math.sin(angle)), (math.cos(angle), 0.0)]


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    for motion, dashes in ((simulate, "-"), (trajectory, "--")):
        rows = motion(t, speed, angle, mass=mass, drag=drag, gravity=gravity)
        ax.plot([row[0] for row in rows], [row[1] for row in rows], dashes, label=motion.__name__)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
    ax.legend()


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = (float(one) for one in state)
    forces = []
    if drag and (vx or vy):
        forces.append(((x, y), (-vx, -vy)))
    if gravity:
        forces.append(((x, y), (0.0, -1.0)))
    return forces
