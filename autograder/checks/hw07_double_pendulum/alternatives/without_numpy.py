"""Plain Python: each bar as two points, complex numbers for the plane, midpoint steps extrapolated to none."""

import cmath
import math
from itertools import pairwise

GAUSS = tuple(
    (1 + sign / math.sqrt(3)) / 2 for sign in (-1, 1)
)  # two points that have a bar's moments up to the second
COUNTS = (2, 4, 6, 8, 10, 12, 14, 16)  # midpoint steps; their error is a series in h^2


def bars(theta, lengths):
    """The two bars as vectors, from hinge to end."""
    return [-1j * length * cmath.exp(1j * float(angle)) for angle, length in zip(theta, lengths, strict=True)]


def points(theta, masses, lengths):
    """(mass, share of bar 1, share of bar 2) of four particles that move as the bars do, and the bars."""
    particles = [(masses[0] / 2, share, 0.0) for share in GAUSS] + [
        (masses[1] / 2, 1.0, share) for share in GAUSS
    ]
    return particles, bars(theta, lengths)


def dot(a, b):
    return (a.conjugate() * b).real


def mass_matrix(theta, *, masses, lengths):
    particles, (a, b) = points(theta, masses, lengths)
    cross = sum(m * s * r for m, s, r in particles) * dot(a, b)
    first, second = (sum(p[0] * p[i] ** 2 for p in particles) * abs(bar) ** 2 for i, bar in ((1, a), (2, b)))
    return [[first, cross], [cross, second]]


def projected(vector, bar):
    """The part of a vector along the motion of a bar's end, times the bar's length."""
    return dot(1j * bar, vector)


def velocity_terms(theta, omega, *, masses, lengths):
    particles, (a, b) = points(theta, masses, lengths)
    both = sum(
        m * s * r for m, s, r in particles
    )  # a bar's own centripetal force has no part along its own motion
    return [-both * omega[1] ** 2 * projected(b, a), -both * omega[0] ** 2 * projected(a, b)]


def gravity_terms(theta, *, masses, lengths, gravity):
    particles, both = points(theta, masses, lengths)
    return [
        sum(p[0] * p[i] for p in particles) * projected(1j * gravity, bar)
        for i, bar in enumerate(both, start=1)
    ]


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    known = {"masses": masses, "lengths": lengths}
    (p, q), (_, r) = mass_matrix(theta, **known)
    forces = zip(
        velocity_terms(theta, omega, **known), gravity_terms(theta, gravity=gravity, **known), strict=True
    )
    a, b = (-(one + other) for one, other in forces)
    return [(r * a - q * b) / (p * r - q * q), (p * b - q * a) / (p * r - q * q)]


def eliminated(rows):
    """The solution of linear equations, each a list of coefficients and the right side; largest pivots first."""
    rows = [[one / max(map(abs, row[:-1])) for one in row] for row in rows]
    for i in range(len(rows)):
        best = max(range(i, len(rows)), key=lambda j: abs(rows[j][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for j in range(i + 1, len(rows)):
            share = rows[j][i] / rows[i][i]
            rows[j] = [b - share * a for a, b in zip(rows[i], rows[j], strict=True)]
    found = []
    for i, row in reversed(list(enumerate(rows))):
        found.insert(0, (row[-1] - sum(a * b for a, b in zip(row[i + 1 : -1], found, strict=True))) / row[i])
    return found


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """Six balances and four constraints for a1, a2, alpha1, alpha2 and the forces on the upper ends, as weights."""
    (a, b), (m1, m2) = (bar / 2 for bar in bars(theta, lengths)), masses
    weight = sum(masses)  # the forces are found in units of both masses
    c1, c2 = -(omega[0] ** 2) * a, -(omega[0] ** 2) * a - omega[1] ** 2 * b
    rows = [
        [m1, 0, 0, 0, 0, 0, -weight, 0, weight, 0, 0],
        [0, m1, 0, 0, 0, 0, 0, -weight, 0, weight, -m1 * gravity],
        [0, 0, m2, 0, 0, 0, 0, 0, -weight, 0, 0],
        [0, 0, 0, m2, 0, 0, 0, 0, 0, -weight, -m2 * gravity],
        [0, 0, 0, 0, m1 * abs(a) ** 2 / 3, 0, -weight * a.imag, weight * a.real]
        + [-weight * a.imag, weight * a.real, 0],
        [0, 0, 0, 0, 0, m2 * abs(b) ** 2 / 3, 0, 0, -weight * b.imag, weight * b.real, 0],
        [1, 0, 0, 0, a.imag, 0, 0, 0, 0, 0, c1.real],
        [0, 1, 0, 0, -a.real, 0, 0, 0, 0, 0, c1.imag],
        [-1, 0, 1, 0, a.imag, b.imag, 0, 0, 0, 0, c2.real],
        [0, -1, 0, 1, -a.real, -b.real, 0, 0, 0, 0, c2.imag],
    ]
    *_, alpha1, alpha2, fx, fy, gx, gy = eliminated(rows)
    return [alpha1, alpha2], [[weight * fx, weight * fy], [weight * gx, weight * gy]]


def energy(theta, omega, *, masses, lengths, gravity):
    particles, (a, b) = points(theta, masses, lengths)
    speeds = [abs(s * omega[0] * a + r * omega[1] * b) for _, s, r in particles]
    heights = [(s * a + r * b).imag for _, s, r in particles]
    return math.fsum(
        p[0] * (speed * speed / 2 + gravity * height)
        for p, speed, height in zip(particles, speeds, heights, strict=True)
    )


def angular_momentum(theta, omega, *, masses, lengths):
    particles, (a, b) = points(theta, masses, lengths)
    return math.fsum(m * dot(s * a + r * b, s * omega[0] * a + r * omega[1] * b) for m, s, r in particles)


def midpoints(state, span, count, rates):
    """Gragg's midpoint steps over a span."""
    h = span / count
    before, now = state, [one + h * rate for one, rate in zip(state, rates(state), strict=True)]
    for _ in range(count - 1):
        before, now = now, [one + 2 * h * rate for one, rate in zip(before, rates(now), strict=True)]
    return [(a + b + h * rate) / 2 for a, b, rate in zip(before, now, rates(now), strict=True)]


def extrapolated(state, span, rates):
    """Neville's value at h = 0, and the largest difference to the one before."""
    row = [midpoints(state, span, count, rates) for count in COUNTS]
    for k in range(1, len(row)):
        error = row[-1]
        for j in range(len(row) - 1, k - 1, -1):
            share = 1 / ((COUNTS[j] / COUNTS[j - k]) ** 2 - 1)
            row[j] = [b + (b - a) * share for a, b in zip(row[j - 1], row[j], strict=True)]
    return row[-1], [a - b for a, b in zip(row[-1], error, strict=True)]


def simulate(t, theta, omega, *, masses, lengths, gravity):
    def rates(state):
        return [
            *state[2:], *angular_acceleration(state[:2], state[2:], masses=masses, lengths=lengths, gravity=gravity)
        ]

    masses, lengths, t = ([float(one) for one in each] for each in (masses, lengths, t))
    state = [float(one) for one in (*theta, *omega)]
    rate = math.sqrt(gravity / min(lengths)) + max(map(abs, state[2:]))
    rows, h = [state], 0.2 / rate if rate else math.inf
    for now, end in pairwise(t):
        while now < end:
            last = now + h >= end
            size = end - now if last else h
            moved, errors = extrapolated(state, size, rates)
            error = max(
                abs(one) / scale for one, scale in zip(errors, (1, 1, rate or 1, rate or 1), strict=True)
            )
            if error <= 1e-12:
                state, now = moved, end if last else now + size
            grown = size * min(3.0, max(0.2, 0.9 * (1e-12 / (error + 1e-30)) ** (1 / 15)))
            h = max(h, grown) if last and error <= 1e-12 else grown
        rows.append(state)
    return rows


def small_oscillation_frequencies(*, masses, lengths, gravity):
    """det(K - w^2 M) = 0 for K, M at rest below; the discriminant as a sum of squares, no root as a difference."""
    (p, q), (_, r) = mass_matrix([0.0, 0.0], masses=masses, lengths=lengths)
    k1, k2 = (
        gravity * length * (m / 2 + below)
        for length, m, below in zip(lengths, masses, (masses[1], 0.0), strict=True)
    )
    if k1 == 0:
        return [0.0, 0.0]
    larger = k1 * r + k2 * p + math.hypot(k1 * r - k2 * p, 2 * q * math.sqrt(k1 * k2))
    return [math.sqrt(2 * k1 * k2 / larger), math.sqrt(larger / (2 * (p * r - q * q)))]


def wireframe(theta, *, lengths):
    upper, lower = bars(theta, lengths)
    elbow, tip = [upper.real, upper.imag], [(upper + lower).real, (upper + lower).imag]
    return [[[0.0, 0.0], elbow], [elbow, tip]]


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    rows = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    tips = [sum(bars(row[:2], lengths)) for row in rows]
    ax.plot([tip.real for tip in tips], [tip.imag for tip in tips])
    reach = 1.05 * sum(lengths)
    ax.set(xlabel="x (m)", ylabel="y (m)", xlim=(-reach, reach), ylim=(-reach, reach), box_aspect=1)


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    l1, l2 = lengths
    e1, e2 = ([math.sin(th), -math.cos(th)] for th in theta)
    if bar == 1:
        return [[[0, 0], None], [[l1 / 2 * e for e in e1], [0, -masses[0] * gravity]], [[l1 * e for e in e1], None]]
    if bar == 2:
        middle = [l1 * a + l2 / 2 * b for a, b in zip(e1, e2)]
        return [[[l1 * e for e in e1], None], [middle, [0, -masses[1] * gravity]]]
    raise ValueError("bar is 1 or 2")
