"""Show that complex numbers, a pseudoinverse of all ten equations and SymPy's frequencies pass."""

import math, cmath
import numpy as np
from numpy import sin, cos
import sympy as sp
from fractions import Fraction
from scipy.integrate import solve_ivp, odeint, ode
from scipy.linalg import eigh, eigvals, cho_factor, cho_solve


def wireframe(theta, *, lengths):
    e = lengths[0] * np.array([np.sin(theta[0]), -np.cos(theta[0])])
    p = e + lengths[1] * np.array([np.sin(theta[1]), -np.cos(theta[1])])
    return [[[0, 0], e.tolist()], [e.tolist(), p.tolist()]]


def _kin(theta, omega, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    e1, e2 = (cmath.exp(1j * q) for q in theta)
    v1 = l1 / 2 * e1 * omega[0]
    v2 = l1 * e1 * omega[0] + l2 / 2 * e2 * omega[1]
    return (m1 * abs(v1)**2 + m2 * abs(v2)**2 + m1 * l1**2 / 12 * omega[0]**2 + m2 * l2**2 / 12 * omega[1]**2) / 2


def mass_matrix(theta, *, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    k = m2 * l1 * l2 / 2 * math.cos(theta[0] - theta[1])
    return [[m1 * l1**2 / 3 + m2 * l1**2, k], [k, m2 * l2**2 / 3]]


def velocity_terms(theta, omega, *, masses, lengths):
    k = masses[1] * lengths[0] * lengths[1] / 2 * math.sin(theta[0] - theta[1])
    return [k * omega[1]**2, -k * omega[0]**2]


def gravity_terms(theta, *, masses, lengths, gravity):
    return np.array([(masses[0] / 2 + masses[1]) * lengths[0] * np.sin(theta[0]), masses[1] * lengths[1] / 2 * np.sin(theta[1])]) * gravity


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    (s1, s2), (c1, c2) = np.sin(theta), np.cos(theta)
    w1, w2 = omega[0]**2, omega[1]**2
    # unknowns a1x a1y a2x a2y al1 al2 Ax Ay Bx By
    A = np.zeros((10, 10)); b = np.zeros(10)
    A[0, [0, 6, 8]] = m1, -1, 1
    A[1, [1, 7, 9]] = m1, -1, 1; b[1] = -m1 * gravity
    A[2, [2, 8]] = m2, -1
    A[3, [3, 9]] = m2, -1; b[3] = -m2 * gravity
    # moments about G1: ceiling at -l1/2 e, elbow force -B at +l1/2 e; e = (s, -c)
    h = l1 / 2; k = l2 / 2
    # r x F = rx Fy - ry Fx, ceiling r = (-h s, h c)
    A[4, [4, 6, 7]] = m1 * l1**2 / 12, h * c1, h * s1
    # elbow r = (h s, -h c), F = -B
    A[4, [8, 9]] = h * c1, h * s1
    A[5, [5, 8, 9]] = m2 * l2**2 / 12, k * c2, k * s2
    A[6, [0, 4]] = 1, -h * c1; b[6] = -h * s1 * w1
    A[7, [1, 4]] = 1, -h * s1; b[7] = h * c1 * w1
    A[8, [2, 4, 5]] = 1, -l1 * c1, -k * c2; b[8] = -l1 * s1 * w1 - k * s2 * w2
    A[9, [3, 4, 5]] = 1, -l1 * s1, -k * s2; b[9] = l1 * c1 * w1 + k * c2 * w2
    x = np.linalg.pinv(A) @ b
    return x[4:6], x[6:].reshape(2, 2)


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    p = dict(masses=masses, lengths=lengths)
    return -np.linalg.solve(mass_matrix(theta, **p), np.asarray(velocity_terms(theta, omega, **p)) + np.asarray(gravity_terms(theta, **p, gravity=gravity)))


def energy(theta, omega, *, masses, lengths, gravity):
    w = np.asarray(omega)
    T = w @ np.asarray(mass_matrix(theta, masses=masses, lengths=lengths)) @ w / 2
    return T - gravity * (masses[0] * lengths[0] / 2 * cos(theta[0]) + masses[1] * (lengths[0] * cos(theta[0]) + lengths[1] / 2 * cos(theta[1])))


def angular_momentum(theta, omega, *, masses, lengths):
    return np.sum(np.asarray(mass_matrix(theta, masses=masses, lengths=lengths)) @ omega)


def small_oscillation_frequencies(*, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    M = np.array([[m1*l1**2/3 + m2*l1**2, m2*l1*l2/2], [m2*l1*l2/2, m2*l2**2/3]])
    K = gravity * np.diag([(m1/2 + m2)*l1, m2*l2/2])
    return np.sqrt(eigh(K, M, eigvals_only=True))


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    y = np.asarray(simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity), float)
    ax.plot(lengths[0]*sin(y[:, 0]) + lengths[1]*sin(y[:, 1]), -lengths[0]*cos(y[:, 0]) - lengths[1]*cos(y[:, 1]))
    ax.set_xlabel("x (m)"); ax.set_ylabel("y (m)"); ax.set_aspect("equal")


def simulate(t, theta, omega, *, masses, lengths, gravity):
    (m1, m2), (l1, l2) = map(float, masses), map(float, lengths)
    g = gravity
    mu = m1 / m2
    def acc(a, b, w, u):
        D = a - b; s, c = math.sin(D), math.cos(D)
        A, B, C, E = l1 * (mu / 3 + 1), l2 / 2 * c, l2 / 3, l1 / 2 * c
        P = -l2 / 2 * s * u * u - g * (mu / 2 + 1) * math.sin(a)
        Q = l1 / 2 * s * w * w - g / 2 * math.sin(b)
        det = A * C - B * E
        return (P * C - B * Q) / det, (A * Q - E * P) / det
    f = lambda T, s: [s[2], s[3], *acc(*s)]
    s0 = [*map(float, theta), *map(float, omega)]
    return solve_ivp(f, (t[0], t[-1]), s0, t_eval=t, rtol=1e-9, atol=1e-9).y.T


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    l1, l2 = lengths
    e1, e2 = ([np.sin(th), -np.cos(th)] for th in theta)
    if bar == 1:
        return [[[0, 0], None], [[l1 / 2 * e for e in e1], [0, -masses[0] * gravity]], [[l1 * e for e in e1], None]]
    if bar == 2:
        middle = [l1 * a + l2 / 2 * b for a, b in zip(e1, e2)]
        return [[[l1 * e for e in e1], None], [middle, [0, -masses[1] * gravity]]]
    raise ValueError("bar is 1 or 2")
