"""Plain Python: the power series of omega and of a quaternion from the start; Gauss's mean for the period."""

import cmath
import math
from itertools import product

TERMS = 24  # of the series
NEXT = (1, 2), (2, 0), (0, 1)


def euler_equations(omega, *, inertia):
    return [(inertia[j] - inertia[k]) * omega[j] * omega[k] / inertia[i] for i, (j, k) in enumerate(NEXT)]


def attitude_rate(R, omega):
    """Each row of R is a direction of space in body axes, which omega turns the other way: row' = row x omega."""
    return [[row[j] * omega[k] - row[k] * omega[j] for j, k in NEXT] for row in R]


def euler_rates_313(angles, omega):
    _, theta, phi = (float(one) for one in angles)
    if abs(math.sin(theta)) < 1e-12:
        raise ValueError("psi and phi turn about the same line")
    node = complex(omega[0], omega[1]) * cmath.exp(1j * phi)  # omega along the line of nodes, and across it
    psi_rate = node.imag / math.sin(theta)
    return [psi_rate, node.real, omega[2] - psi_rate * math.cos(theta)]


def energy(omega, *, inertia):
    return math.fsum(i * w * w for i, w in zip(inertia, omega, strict=True)) / 2


def angular_momentum(R, omega, *, inertia):
    return [math.fsum(r * i * w for r, i, w in zip(row, inertia, omega, strict=True)) for row in R]


def series(omega, q, inertia):
    """The coefficients of omega and of the quaternion q, q' = q omega / 2."""
    w, q = [[one] for one in omega], [[one] for one in q]
    ratios = [(inertia[j] - inertia[k]) / inertia[i] for i, (j, k) in enumerate(NEXT)]

    def times(a, b, n):
        return sum(x * y for x, y in zip(a, reversed(b), strict=True)) / (n + 1)

    for n in range(TERMS):
        faster = [ratio * times(w[j], w[k], n) for ratio, (j, k) in zip(ratios, NEXT, strict=True)]
        scalar = -sum(times(q[i + 1], w[i], n) for i in range(3)) / 2
        vector = [
            (times(q[0], w[i], n) + times(q[j + 1], w[k], n) - times(q[k + 1], w[j], n)) / 2
            for i, (j, k) in enumerate(NEXT)
        ]
        for one, more in zip(w + q, (*faster, scalar, *vector), strict=True):
            one.append(more)
    return w, q


def reach(w, q, fastest):
    """The time after which the last terms of the series are no longer below rounding."""
    sizes = [max(abs(one[n]) / fastest for one in w) + max(abs(one[n]) for one in q) for n in (-2, -1)]
    return min(
        (1e-17 / (size + 1e-300)) ** (1 / n) for n, size in zip((TERMS - 1, TERMS), sizes, strict=True)
    )


def value(coefficients, h):
    total = 0.0
    for one in reversed(coefficients):
        total = one + h * total
    return total


def turned(R, q):
    """R after the rotation of a quaternion of any length, about body axes."""
    size = math.fsum(one * one for one in q)
    s, v = q[0], q[1:]
    rows = []
    for row in R:  # row of R times the matrix of q is the row turned back by q
        along = 2 * math.fsum(a * b for a, b in zip(row, v, strict=True))
        cross = [row[j] * v[k] - row[k] * v[j] for j, k in NEXT]
        left = s * s - math.fsum(one * one for one in v)
        rows.append(
            [(left * a + along * b + 2 * s * c) / size for a, b, c in zip(row, v, cross, strict=True)]
        )
    return rows


def simulate(t, R, omega, *, inertia):
    """The steps are the series' own; rows are read off it."""
    start, inertia, now = [float(one) for one in omega], [float(one) for one in inertia], float(t[0])
    R = [[float(one) for one in row] for row in R]
    omegas, rotations = [start], [R]
    fastest = max(map(abs, start)) or 1.0
    w, q = series(start, [1.0, 0.0, 0.0, 0.0], inertia)
    for one in t[1:]:
        while one - now > (step := reach(w, q, fastest)):
            now += step
            here = [value(each, step) for each in q]
            size = math.hypot(*here)
            w, q = series([value(each, step) for each in w], [each / size for each in here], inertia)
        h = float(one) - now
        omegas.append([value(each, h) for each in w])
        rotations.append(turned(R, [value(each, h) for each in q]))
    return omegas, rotations


def symmetric_solution(t, omega, *, inertia):
    rate = omega[2] * (inertia[2] - inertia[0]) / inertia[0]
    across = [complex(omega[0], omega[1]) * cmath.exp(1j * rate * (one - t[0])) for one in t]
    return [[each.real, each.imag, float(omega[2])] for each in across]


def wobble_rate(omega, *, inertia):
    """omega = (L/A) along L, and a spin about the axis: the axis goes round L at L/A."""
    return math.hypot(*(i * w for i, w in zip(inertia, omega, strict=True))) / inertia[0]


def growth_rate_squared(axis, spin, *, inertia):
    j, k = NEXT[axis]
    up, down = inertia[k] - inertia[axis], inertia[axis] - inertia[j]
    return spin * spin * (up / inertia[j]) * (down / inertia[k])


def tumble_period(omega, *, inertia):
    """Landau and Lifshitz's period, 37.12, as 2 pi over a mean of two rates; one is zero on the separatrix."""
    A, B, C = (float(one) for one in inertia)
    p, q, r = (float(one) ** 2 for one in omega)
    low, high = B * (B - A) * q + C * (C - A) * r, A * (C - A) * p + B * (C - B) * q  # H^2 - 2EA, 2EC - H^2
    rates = [math.sqrt(max((C - B) * low, (B - A) * high) / (A * B * C))]
    rates.append(math.sqrt((C - A) * abs(C * (C - B) * r - A * (B - A) * p) / (A * B * C)))
    a, b = rates
    if b == 0:
        return math.inf
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / a


def wireframe(R, *, size):
    """From each corner the edges that go up along one of the axes."""
    edges = []
    for corner in product((-0.5, 0.5), repeat=3):
        for axis in (axis for axis in range(3) if corner[axis] < 0):
            other = [0.5 if i == axis else one for i, one in enumerate(corner)]
            edges.append([angular_momentum(R, end, inertia=size) for end in (corner, other)])
    return edges


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for column in (0, 1):
        ax.plot([radius * one[1][column] for one in rotations], [radius * one[2][column] for one in rotations])
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
