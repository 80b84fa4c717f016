"""Right: balances by hand, of bar 2 about the elbow over -m2 l2, then of both about the ceiling; Cramer's rule."""
import numpy as np
from scipy.integrate import solve_ivp


def mass_matrix(theta, *, masses, lengths):
    m1, m2 = masses
    l1, l2 = lengths
    c = np.cos(theta[0] - theta[1])
    elbow = [-l1 / 2 * c, -l2 / 3]  # of bar 2 about the elbow, over -m2 l2
    both = [(m1 / 3 + m2) * l1**2 + m2 / 2 * l1 * l2 * c, m2 / 3 * l2**2 + m2 / 2 * l1 * l2 * c]  # about the ceiling
    return [elbow, both]


def velocity_terms(theta, omega, *, masses, lengths):
    l1, l2 = lengths
    s = np.sin(theta[0] - theta[1])
    return l1 / 2 * s * omega[0] ** 2, masses[1] / 2 * l1 * l2 * s * (omega[1] ** 2 - omega[0] ** 2)


def gravity_terms(theta, *, masses, lengths, gravity):
    w1, w2 = gravity * np.asarray(masses)
    x1, x2 = lengths * np.sin(theta)
    return [-gravity / 2 * np.sin(theta[1]), w1 * x1 / 2 + w2 * (x1 + x2 / 2)]


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    # unknowns: a1x a1y al1 a2x a2y al2 F0x F0y F1x F1y
    (m1, m2), (l1, l2) = masses, lengths
    (s1, s2), (c1, c2) = np.sin(theta), np.cos(theta)
    w1, w2 = omega
    A = np.zeros((10, 10))
    b = np.zeros(10)
    A[0, 0], A[0, 6], A[0, 8] = m1, -1, 1
    A[1, 1], A[1, 7], A[1, 9], b[1] = m1, -1, 1, -m1 * gravity
    A[2, 3], A[2, 8] = m2, -1
    A[3, 4], A[3, 9], b[3] = m2, -1, -m2 * gravity
    # AMB about each centre; hinge above the centre at -l/2 (s, -c), below at +l/2 (s, -c)
    h1, h2 = l1 / 2, l2 / 2
    A[4, 2] = m1 * l1**2 / 12
    # r x F = rx Fy - ry Fx
    A[4, 6], A[4, 7] = h1 * c1, h1 * s1  # top: r = (-h s, h c), force F0 -> moment -h s Fy - h c Fx
    A[4, 8], A[4, 9] = h1 * c1, h1 * s1  # bottom: r = (h s, -h c), force -F1 -> moment -(h s Fy + h c Fx)
    A[5, 5] = m2 * l2**2 / 12
    A[5, 8], A[5, 9] = h2 * c2, h2 * s2
    # constraints: centre 1, elbow
    A[6, 0], A[6, 2], b[6] = 1, -h1 * c1, -h1 * s1 * w1**2
    A[7, 1], A[7, 2], b[7] = 1, -h1 * s1, h1 * c1 * w1**2
    A[8, 3], A[8, 2], A[8, 5], b[8] = 1, -l1 * c1, -h2 * c2, -l1 * s1 * w1**2 - h2 * s2 * w2**2
    A[9, 4], A[9, 2], A[9, 5], b[9] = 1, -l1 * s1, -h2 * s2, l1 * c1 * w1**2 + h2 * c2 * w2**2
    u = np.linalg.solve(A, b)
    return [u[2], u[5]], [[u[6], u[7]], [u[8], u[9]]]


def energy(theta, omega, *, masses, lengths, gravity):
    (m1, m2), (l1, l2), (p, q) = masses, lengths, omega
    y1 = -l1 * np.cos(theta[0])
    y2 = y1 - l2 / 2 * np.cos(theta[1])
    v2_squared = l1**2 * p**2 + l2**2 / 4 * q**2 + l1 * l2 * p * q * np.cos(theta[0] - theta[1])
    kinetic = m1 * l1**2 / 6 * p**2 + m2 / 2 * v2_squared + m2 * l2**2 / 24 * q**2
    return kinetic + gravity * (m1 * y1 / 2 + m2 * y2)


def angular_momentum(theta, omega, *, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    e1, e2 = [np.array([np.sin(a), -np.cos(a)]) for a in theta]
    n1, n2 = [np.array([np.cos(a), np.sin(a)]) for a in theta]
    r1, v1 = l1 / 2 * e1, l1 / 2 * omega[0] * n1
    r2, v2 = l1 * e1 + l2 / 2 * e2, l1 * omega[0] * n1 + l2 / 2 * omega[1] * n2
    H = m1 * l1**2 / 12 * omega[0] + m2 * l2**2 / 12 * omega[1]
    for m, r, v in ((m1, r1, v1), (m2, r2, v2)):
        H += m * (r[0] * v[1] - r[1] * v[0])
    return H


def wireframe(theta, *, lengths):
    elbow = (lengths[0] * np.sin(theta[0]), -lengths[0] * np.cos(theta[0]))
    tip = (elbow[0] + lengths[1] * np.sin(theta[1]), elbow[1] - lengths[1] * np.cos(theta[1]))
    return [[(0.0, 0.0), elbow], [elbow, tip]]


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    z = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    tips = np.array([wireframe(row[:2], lengths=lengths)[1][1] for row in z])
    ax.plot(tips[:, 0], tips[:, 1])
    ax.set(xlabel="x (m)", ylabel="y (m)")
    ax.set_aspect("equal")


def small_oscillation_frequencies(*, masses, lengths, gravity):
    M = np.array(mass_matrix(np.zeros(2), masses=masses, lengths=lengths))
    (m1, m2), (l1, l2) = masses, lengths
    K = gravity * np.array([[0, -1 / 2], [(m1 / 2 + m2) * l1, m2 * l2 / 2]])
    return np.sort(np.sqrt(np.abs(np.linalg.eigvals(np.linalg.inv(M) @ K))))


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    (a, b), (c, d) = mass_matrix(theta, masses=masses, lengths=lengths)
    f = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    g = gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    p, q = -f[0] - g[0], -f[1] - g[1]
    det = a * d - b * c
    return (d * p - b * q) / det, (a * q - c * p) / det


def simulate(t, theta, omega, *, masses, lengths, gravity):
    def rhs(_, z):
        alpha, _f = on_the_fly(z[:2], z[2:], masses=masses, lengths=lengths, gravity=gravity)
        return [z[2], z[3], *alpha]

    sol = solve_ivp(rhs, (t[0], t[-1]), [*theta, *omega], method="DOP853", dense_output=True, rtol=1e-9, atol=1e-9)
    return [list(sol.sol(s)) for s in t]


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    l1, l2 = lengths
    e1, e2 = ([np.sin(th), -np.cos(th)] for th in theta)
    if bar == 1:
        return [[[0, 0], None], [[l1 / 2 * e for e in e1], [0, -masses[0] * gravity]], [[l1 * e for e in e1], None]]
    if bar == 2:
        middle = [l1 * a + l2 / 2 * b for a, b in zip(e1, e2)]
        return [[[l1 * e for e in e1], None], [middle, [0, -masses[1] * gravity]]]
    raise ValueError("bar is 1 or 2")
