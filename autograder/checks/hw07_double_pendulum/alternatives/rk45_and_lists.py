"""Show that plain Python passes: lists, tuples, formulas by hand, RK45."""

from math import cos, pi, sin, sqrt

from scipy.integrate import solve_ivp


def mass_matrix(theta, *, masses, lengths):
    m1, m2 = masses
    l1, l2 = lengths
    c = m2 * l1 * l2 * cos(theta[1] - theta[0]) / 2
    return [[m1 * l1 * l1 / 3 + m2 * l1 * l1, c], [c, m2 * l2 * l2 / 3]]


def velocity_terms(theta, omega, *, masses, lengths):
    s = masses[1] * lengths[0] * lengths[1] * sin(theta[1] - theta[0]) / 2
    return (-s * omega[1] ** 2, s * omega[0] ** 2)


def gravity_terms(theta, *, masses, lengths, gravity):
    m1, m2 = masses
    return [
        (m1 + 2 * m2) * gravity * lengths[0] / 2 * sin(theta[0]),
        m2 * gravity * lengths[1] / 2 * sin(theta[1]),
    ]


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    (a, b), (_, d) = mass_matrix(theta, masses=masses, lengths=lengths)
    f = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    g = gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    p, q = -f[0] - g[0], -f[1] - g[1]
    return [(d * p - b * q) / (a * d - b * b), (a * q - b * p) / (a * d - b * b)]


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """The elbow's force F from two equations: both bars' elbows accelerate alike."""
    (m1, m2), (l1, l2) = masses, lengths
    s1, c1, s2, c2 = sin(theta[0]), cos(theta[0]), sin(theta[1]), cos(theta[1])
    # bar 1 about the ceiling: m1 l1^2/3 al1 = -m1 g l1/2 s1 - l1 (c1 Fx + s1 Fy)
    # bar 2 about its centre: m2 l2^2/12 al2 = -l2/2 (c2 Fx + s2 Fy)
    i1, i2 = 3 / m1, 3 / m2
    # elbow by bar 1: l1 al1 (c1, s1) - l1 om1^2 (s1, -c1); by bar 2: F/m2 - (0, g) - l2/2 al2 (c2, s2) + l2/2 om2^2 (s2, -c2)
    kxx = i1 * c1 * c1 + i2 * c2 * c2 + 1 / m2
    kxy = i1 * c1 * s1 + i2 * c2 * s2
    kyy = i1 * s1 * s1 + i2 * s2 * s2 + 1 / m2
    free = -3 * gravity * s1 / 2
    bx = free * c1 - l1 * omega[0] ** 2 * s1 - l2 / 2 * omega[1] ** 2 * s2
    by = free * s1 + l1 * omega[0] ** 2 * c1 + l2 / 2 * omega[1] ** 2 * c2 + gravity
    det = kxx * kyy - kxy * kxy
    fx, fy = (kyy * bx - kxy * by) / det, (kxx * by - kxy * bx) / det
    al1 = (free - i1 * (c1 * fx + s1 * fy)) / l1
    al2 = -6 / (m2 * l2) * (c2 * fx + s2 * fy)
    gx = m1 * l1 / 2 * (al1 * c1 - omega[0] ** 2 * s1) + fx
    gy = m1 * l1 / 2 * (al1 * s1 + omega[0] ** 2 * c1) + fy + m1 * gravity
    return (al1, al2), ((gx, gy), (fx, fy))


def energy(theta, omega, *, masses, lengths, gravity):
    (a, b), (_, d) = mass_matrix(theta, masses=masses, lengths=lengths)
    (m1, m2), (l1, l2) = masses, lengths
    y1, elbow = -l1 / 2 * cos(theta[0]), -l1 * cos(theta[0])
    potential = m1 * gravity * y1 + m2 * gravity * (elbow - l2 / 2 * cos(theta[1]))
    return a * omega[0] ** 2 / 2 + b * omega[0] * omega[1] + d * omega[1] ** 2 / 2 + potential


def angular_momentum(theta, omega, *, masses, lengths):
    (a, b), (c, d) = mass_matrix(theta, masses=masses, lengths=lengths)
    return (a + c) * omega[0] + (b + d) * omega[1]


def simulate(t, theta, omega, *, masses, lengths, gravity):
    def rates(_, y):
        alpha = angular_acceleration(y[:2], y[2:], masses=masses, lengths=lengths, gravity=gravity)
        return [y[2], y[3], *alpha]

    found = solve_ivp(rates, (t[0], t[-1]), [*theta, *omega], t_eval=t, rtol=1e-9, atol=1e-9)
    return [list(row) for row in zip(*found.y, strict=True)]


def small_oscillation_frequencies(*, masses, lengths, gravity):
    (a, b), (_, d) = mass_matrix((0, 0), masses=masses, lengths=lengths)
    k1, k2 = gravity_terms((pi / 2, pi / 2), masses=masses, lengths=lengths, gravity=gravity)
    det, half = a * d - b * b, (a * k2 + d * k1) / 2
    root = sqrt(max(half * half - det * k1 * k2, 0))
    return sqrt((half - root) / det), sqrt((half + root) / det)


def wireframe(theta, *, lengths):
    elbow = (lengths[0] * sin(theta[0]), -lengths[0] * cos(theta[0]))
    tip = (elbow[0] + lengths[1] * sin(theta[1]), elbow[1] - lengths[1] * cos(theta[1]))
    return [[(0.0, 0.0), elbow], [elbow, tip]]


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    rows = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    tips = [wireframe(row[:2], lengths=lengths)[1][1] for row in rows]
    ax.scatter([x for x, _ in tips], [y for _, y in tips], s=2)
    ax.set_xlabel("horizontal (m)")
    ax.set_ylabel("vertical (m)")
    ax.set_aspect("equal")


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    elbow = (lengths[0] * sin(theta[0]), -lengths[0] * cos(theta[0]))
    far = (elbow[0] + lengths[1] * sin(theta[1]), elbow[1] - lengths[1] * cos(theta[1]))
    ends = {1: ((0.0, 0.0), elbow), 2: (elbow, far)}
    if bar not in ends:
        raise ValueError(f"no bar {bar}")
    (a, b), (c, d) = ends[bar]
    forces = [(((a + c) / 2, (b + d) / 2), (0, -1)), (elbow, (1, 0)), (elbow, (0, 1))]
    return forces + [((0, 0), (1, 0)), ((0, 0), (0, 1))] if bar == 1 else forces
