"""Right: plain Python and lists, RK45, brentq on the height, a golden section for the best angle's neighbourhood."""

import math

from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def state_derivative(t, state, *, mass, drag, gravity):
    x, y, vx, vy = state
    return [vx, vy, -drag / mass * vx, -drag / mass * vy - gravity]


def simulate(t, speed, angle, **known):
    start = (0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle))
    found = solve_ivp(
        state_derivative_of(known), (t[0], t[-1]), start, "RK45", t_eval=t, rtol=1e-9, atol=1e-9
    )
    return [tuple(row) for row in zip(*found.y, strict=True)]


def state_derivative_of(known):
    return lambda t, y: state_derivative(t, y, **known)


def integrals(k, t):
    """The integral of e^(-k t), and the integral of that, from 0 to t."""
    s = k * t
    if abs(s) < 0.5:
        terms = [t]
        for n in range(2, 22):
            terms.append(-terms[-1] * s / n)
        inner = [t * t / 2]
        for n in range(3, 22):
            inner.append(-inner[-1] * s / n)
        return math.fsum(terms), math.fsum(inner)
    return (1 - math.exp(-s)) / k, (s - 1 + math.exp(-s)) / k**2


def state(t, speed, angle, *, mass, drag, gravity):
    k = drag / mass
    first, second = integrals(k, t)
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    return [
        vx * first,
        vy * first - gravity * second,
        vx * math.exp(-k * t),
        vy * math.exp(-k * t) - gravity * first,
    ]


def trajectory(t, speed, angle, **known):
    return [state(float(ti), speed, angle, **known) for ti in t]


def flight_time(speed, angle, *, gravity, **known):
    longest = 2 * speed * math.sin(angle) / gravity

    def mean_height(share):
        t = share * longest
        return state(t, speed, angle, gravity=gravity, **known)[1] / t

    return longest * brentq(
        mean_height, 0.1 / (1 + known["drag"] * longest), 1 + 1e-9, xtol=1e-15, maxiter=500
    )


def horizontal_range(speed, angle, **known):
    return state(flight_time(speed, angle, **known), speed, angle, **known)[0]


def best_angle(speed, **known):
    def slope(log_tan):
        """The derivative of the range by the angle, by the landing's velocity."""
        angle = math.atan(math.exp(log_tan))
        _, _, vx, vy = state(flight_time(speed, angle, **known), speed, angle, **known)
        return math.cos(angle) * vx + math.sin(angle) * vy

    return math.atan(math.exp(brentq(slope, math.log(1e-9), 2.0, xtol=1e-13)))


def limit_shape(angle):
    return ((0, 0), (math.cos(angle), math.sin(angle)), (math.cos(angle), 0))


def plot_comparison(ax, t, speed, angle, **known):
    for rows, label in (
        (simulate(t, speed, angle, **known), "numbers"),
        (trajectory(t, speed, angle, **known), "formula"),
    ):
        ax.plot([row[0] for row in rows], [row[1] for row in rows], label=label)
    ax.axis("equal")
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")
    ax.legend()


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = (float(one) for one in state)
    forces = []
    if drag and (vx or vy):
        forces.append(((x, y), (-vx, -vy)))
    if gravity:
        forces.append(((x, y), (0.0, -1.0)))
    return forces
