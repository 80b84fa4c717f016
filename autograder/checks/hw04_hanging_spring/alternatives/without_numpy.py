"""Plain Python: leapfrogs of more and more steps extrapolated to none, the ellipse by the angle of its axes."""

import math
from itertools import pairwise

LEAPS = (2, 4, 6, 8, 10, 12, 14)  # the error of a leapfrog is a series in h^2


def state_derivative(t, state, *, mass, stiffness, gravity):
    x, y, z, *v = (float(one) for one in state)
    return [*v, -stiffness * x / mass, -stiffness * y / mass, -stiffness * z / mass - gravity]


def leapfrogs(r, v, span, count, ratio, fall):
    """Kick, drift, kick, over and over; ratio = k/m."""
    h, r, v = span / count, list(r), list(v)
    for i in range(3):
        for _ in range(count):
            v[i] += h / 2 * (fall[i] - ratio * r[i])
            r[i] += h * v[i]
            v[i] += h / 2 * (fall[i] - ratio * r[i])
    return r + v


def extrapolated(table):
    """Neville's value at h = 0 of the polynomial in h^2 through what each of LEAPS gave."""
    row = list(table)
    for k in range(1, len(row)):
        for j in range(len(row) - 1, k - 1, -1):
            step = 1 / ((LEAPS[j] / LEAPS[j - k]) ** 2 - 1)
            row[j] = [b + (b - a) * step for a, b in zip(row[j - 1], row[j], strict=True)]
    return row[-1]


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    state = [float(one) for one in (*position, *velocity)]
    rows, fall, ratio = [state], (0.0, 0.0, -gravity), stiffness / mass
    for start, end in pairwise(t):
        parts = max(1, math.ceil((end - start) * math.sqrt(ratio)))  # a radian, or less, at a time
        for _ in range(parts):
            span = float(end - start) / parts
            state = extrapolated([leapfrogs(state[:3], state[3:], span, n, ratio, fall) for n in LEAPS])
        rows.append(state)
    return rows


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w, hang = math.sqrt(stiffness / mass), (0.0, 0.0, -mass * gravity / stiffness)
    # of each coordinate: the size and phase of its own oscillation about where the mass can hang
    sizes = [math.hypot(r - c, v / w) for r, c, v in zip(position, hang, velocity, strict=True)]
    phases = [math.atan2(-v / w, r - c) for r, c, v in zip(position, hang, velocity, strict=True)]
    each = list(zip(hang, sizes, phases, strict=True))
    return [
        [c + size * math.cos(w * one + phase) for c, size, phase in each]
        + [-w * size * math.sin(w * one + phase) for _, size, phase in each]
        for one in map(float, t)
    ]


def energy(state, *, mass, stiffness, gravity):
    x, y, z, *v = (float(one) for one in state)
    return (
        math.fsum((stiffness * x * x, stiffness * y * y, stiffness * z * z, *(mass * u * u for u in v))) / 2
        + mass * gravity * z
    )


def orbit(position, velocity, *, mass, stiffness, gravity):
    """r = centre + p cos + q sin; the axes are where r' is perpendicular to r - centre."""
    w, centre = math.sqrt(stiffness / mass), [0.0, 0.0, -mass * gravity / stiffness]
    p = [float(r) - c for r, c in zip(position, centre, strict=True)]
    q = [float(v) / w for v in velocity]
    pp, pq, qq = (math.fsum(a * b for a, b in zip(*pair, strict=True)) for pair in ((p, p), (p, q), (q, q)))
    phase = math.atan2(2 * pq, pp - qq) / 2
    c, s = math.cos(phase), math.sin(phase)
    pairs = list(zip(p, q, strict=True))
    return centre, [[a * c + b * s for a, b in pairs], [b * c - a * s for a, b in pairs]]


def project(points, azimuth, elevation):
    """Turn the world about z until the view is along x, then about y."""
    ca, sa, ce, se = math.cos(azimuth), math.sin(azimuth), math.cos(elevation), math.sin(elevation)
    return [(y * ca - x * sa, z * ce - (x * ca + y * sa) * se) for x, y, z in points]


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    rows = simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    ax.plot(*zip(*project([row[:3] for row in rows], azimuth, elevation), strict=True))
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")


def free_body_diagram(state, *, mass, stiffness, gravity):
    r = tuple(map(float, state[:3]))
    forces = [(r, (0.0, 0.0, -1.0))]
    return forces + [(r, tuple(-one for one in r))] if any(r) else forces
