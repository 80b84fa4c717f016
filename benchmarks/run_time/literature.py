"""More problems of the literature, on which nothing is tuned: rhs(t, y), start, duration; each with its source."""

import math

from run_time.public import _bodies, _cube

PI = math.pi


def _lorenz_96(t, y):
    """Lorenz, Predictability: a problem partly solved, ECMWF Seminar (1996)."""
    k = len(y)
    return [(y[(i + 1) % k] - y[i - 2]) * y[i - 1] - y[i] + 8.0 for i in range(k)]


def _fpu(alpha, beta):
    """Fermi, Pasta, Ulam, Studies of nonlinear problems, Los Alamos LA-1940 (1955)."""

    def rates(t, s):
        k = len(s) // 2
        q = (0.0, *s[:k], 0.0)
        d = [q[i + 1] - q[i] for i in range(k + 1)]
        force = [x + alpha * x * x + beta * x * x * x for x in d]
        return *s[k:], *(force[i + 1] - force[i] for i in range(k))

    return rates


def _toda(t, s):
    """Three particles on a ring. Toda, J. Phys. Soc. Japan 22 (1967); Ford, Stoddard, Turner (1973)."""
    a, b, c, *velocities = s
    u, v, w = math.exp(a - b), math.exp(b - c), math.exp(c - a)
    return *velocities, w - u, u - v, v - w


def _abc(t, s):
    """Arnold, C. R. Acad. Sci. 261 (1965); Dombre and others, J. Fluid Mech. 167 (1986)."""
    x, y, z = s
    a, b, c = 1.0, math.sqrt(2 / 3), math.sqrt(1 / 3)
    return (a * math.sin(z) + c * math.cos(y), b * math.sin(x) + a * math.cos(z), c * math.sin(y) + b * math.cos(x))


def _oblate(t, s):
    """A satellite about an oblate earth, J2 alone. Vallado, Fundamentals of Astrodynamics, 8.6."""
    x, y, z, *velocities = s
    square = x * x + y * y + z * z
    r5 = square * square * math.sqrt(square)
    k, ratio = 1.5 * 1.0826e-3 / r5, 5 * z * z / square
    pull = square / r5
    return *velocities, *(-w * (pull - k * (ratio - n)) for w, n in ((x, 1), (y, 1), (z, 3)))


def _relativistic(t, s):
    """Kepler's problem with the first correction of general relativity, by 3 h^2 / r^5."""
    x, y, u, v = s
    square, h = x * x + y * y, x * v - y * u
    factor = -(1 + 0.03 * h * h / square) / _cube(x, y)
    return u, v, factor * x, factor * y


def _restricted(t, s):
    """Earth, moon and a body in space. Szebehely, Theory of Orbits (1967)."""
    x, y, z, u, v, w = s
    m = 0.01215
    a, b = (1 - m) / _cube(x + m, y, z), m / _cube(x - 1 + m, y, z)
    return u, v, w, x + 2 * v - a * (x + m) - b * (x - 1 + m), y - 2 * u - (a + b) * y, -(a + b) * z


def _hill(t, s):
    """Hill, Researches in the lunar theory, Am. J. Math. 1 (1878)."""
    x, y, u, v = s
    cube = _cube(x, y)
    return u, v, 2 * v + 3 * x - x / cube, -2 * u - y / cube


def _choreography(u, v):
    """Suvakov and Dmitrasinovic, Phys. Rev. Lett. 110, 114301 (2013)."""
    return _bodies((1.0, 1.0, 1.0)), (-1.0, 1.0, 0.0, 0.0, 0.0, 0.0, u, u, -2 * u, v, v, -2 * v)


def _torqued(t, s):
    """A rigid body under a torque that turns with it. Hughes, Spacecraft Attitude Dynamics, 4.4."""
    p, q, r = s
    return -1.1 * q * r + 0.1, 0.9 * r * p, -0.2 * p * q - 0.05 * math.sin(t)


def _leipnik(t, s):
    """A rigid body with feedback. Leipnik and Newton, Phys. Lett. A 86 (1981)."""
    x, y, z = s
    return -0.4 * x + y + 10 * y * z, -x - 0.4 * y + 5 * x * z, 0.175 * z - 5 * x * y


def _quaternion(t, s):
    """A free body with the quaternion of its attitude. Goldstein, Classical Mechanics, 4.5 and 5.6."""
    p, q, r, a, b, c, d = s
    return (
        *(-0.5 * q * r, 0.6 * r * p, -0.15 * p * q),
        *((-b * p - c * q - d * r) / 2, (a * p + c * r - d * q) / 2, (a * q + d * p - b * r) / 2),
        (a * r + b * q - c * p) / 2,
    )


def _foucault(t, s):
    """Landau and Lifshitz, Mechanics, 39; in days of 50 s."""
    x, y, u, v = s
    turn = 2 * 2 * PI / 50 * math.sin(0.85)
    return u, v, -x + turn * v, -y - turn * u


def _spherical(t, s):
    """Polar angle and azimuth. Landau and Lifshitz, Mechanics, 14."""
    theta, _, p, q = s
    c, d = math.cos(theta), math.sin(theta)
    return p, q, q * q * c * d - math.sin(theta), -2 * p * q * c / d


def _elastic(t, s):
    """Vitt and Gorelik (1933); Lynch, Int. J. Non-Linear Mech. 37 (2002)."""
    x, y, u, v = s
    r = math.sqrt(x * x + y * y)
    pull = 4 * (r - 0.75) / r
    return u, v, -pull * x, -pull * y - 1


def _wilberforce(t, s):
    """Berg and Marshall, Am. J. Phys. 59 (1991)."""
    z, a, u, v = s
    return u, v, -5.4 * z - 0.2 * a, -5.4 * a - 0.25 * z


def _atwood(t, s):
    """A swinging Atwood machine. Tufillaro, Abbott, Griffiths, Am. J. Phys. 52 (1984)."""
    r, a, u, v = s
    mu = 3.0
    return u, v, (r * v * v + math.cos(a) - mu) / (1 + mu), -(2 * u * v + math.sin(a)) / r


def _top(t, s):
    """Lagrange's top in Euler's angles, with its two momenta. Goldstein, Classical Mechanics, 5.7."""
    theta, _, _, p = s
    a, b, c, d = 1.5, 1.2, math.cos(theta), math.sin(theta)
    precession = (b - a * c) / (d * d)
    tipping = precession * precession * c * d - a * precession * d + math.sin(theta)
    return p, precession, a / 0.5 - precession * c, tipping


def _stoermer(t, s):
    """A charge in the field of a dipole. Stoermer, The Polar Aurora (1955)."""
    x, y, z, u, v, w = s
    square = x * x + y * y + z * z
    r5 = square * square * math.sqrt(square)
    a, b, c = 3 * x * z / r5, 3 * y * z / r5, (3 * z * z - square) / r5
    return u, v, w, v * c - w * b, w * a - u * c, u * b - v * a


def _sleigh(t, s):
    """Chaplygin's sleigh. Neimark and Fufaev, Dynamics of Nonholonomic Systems (1972)."""
    _, _, angle, u, w = s
    return u * math.cos(angle), u * math.sin(angle), w, 0.3 * w * w, -0.3 * u * w / 0.39


def _hoop(t, s):
    """A bead on a turning hoop. Strogatz, Nonlinear Dynamics and Chaos, 3.5."""
    return s[1], math.sin(s[0]) * (2.3 * math.cos(s[0]) - 1) - 0.05 * s[1]


def _morse(t, s):
    """Morse, Phys. Rev. 34 (1929)."""
    e = math.exp(-s[0])
    return s[1], -2 * e * (1 - e)


STIFF_A1 = 0.5, 1.0, 100.0, 90.0  # Enright, Hull, Lindberg, BIT 15 (1975), with C1 below


def _stiff_c1(t, y):
    a, b, c, d = y
    return -a + b * b + c * c + d * d, -10 * b + 10 * (c * c + d * d), -40 * c + 40 * d * d, -100 * d + 2


PROBLEMS = {
    "Lotka-Volterra": (lambda t, y: (y[0] * (2 / 3 - 4 / 3 * y[1]), y[1] * (y[0] - 1)), (0.9, 1.8), 40.0),
    "Roessler": (lambda t, y: (-y[1] - y[2], y[0] + 0.2 * y[1], 0.2 + y[2] * (y[0] - 5.7)), (1.0, 1.0, 0.0), 40.0),
    "Chua, cubic": (  # Zhong, IEEE Trans. Circuits Syst. 41 (1994)
        lambda t, y: (10 * (y[1] - y[0] ** 3 / 16 + y[0] / 6), y[0] - y[1] + y[2], -16 * y[1]),
        (0.1, 0.2, 0.3),
        20.0,
    ),
    "Thomas": (  # Int. J. Bifurcation and Chaos 9 (1999)
        lambda t, y: tuple(math.sin(y[(i + 1) % 3]) - 0.18 * y[i] for i in range(3)),
        (1.0, 0.2, -0.3),
        50.0,
    ),
    "Sprott A": (lambda t, y: (y[1], -y[0] + y[1] * y[2], 1 - y[1] * y[1]), (0.0, 5.0, 0.0), 40.0),  # PRE 50 (1994)
    "Sprott B": (lambda t, y: (y[1] * y[2], y[0] - y[1], 1 - y[0] * y[1]), (0.05, 0.05, 0.05), 40.0),
    "Sprott S": (lambda t, y: (-y[0] - 4 * y[1], y[0] + y[2] * y[2], 1 + y[0]), (0.05, 0.05, 0.05), 40.0),
    "Halvorsen": (  # Sprott, Chaos and Time-Series Analysis (2003)
        lambda t, y: tuple(-1.4 * y[i] - 4 * (y[i - 2] + y[i - 1]) - y[i - 2] ** 2 for i in range(3)),
        (-5.0, 0.0, 0.0),
        5.0,
    ),
    "oblate earth": (_oblate, (1.1, 0.0, 0.0, 0.0, 0.7, 0.65), 60.0),
    "relativistic Kepler": (_relativistic, (0.6, 0.0, 0.0, 1.5), 50.0),
    "restricted three-body": (_restricted, (0.83, 0.0, 0.12, 0.0, 0.22, 0.0), 6.0),
    "Hill": (_hill, (0.3, 0.0, 0.0, 1.7), 10.0),
    "butterfly": (*_choreography(0.30689, 0.12551), 6.2356),
    "moth": (*_choreography(0.46444, 0.39606), 14.8939),
    "Pythagorean": (  # Burrau (1913); Szebehely and Peters, Astron. J. 72 (1967)
        _bodies((3.0, 4.0, 5.0)),
        (1.0, -2.0, 1.0, 3.0, -1.0, -1.0, *[0.0] * 6),
        10.0,
    ),
    "body under a torque": (_torqued, (0.1, 1.0, 0.2), 50.0),
    "Leipnik and Newton": (_leipnik, (0.349, 0.0, -0.16), 40.0),
    "free body, quaternion": (_quaternion, (0.2, 1.0, 0.4, 1.0, 0.0, 0.0, 0.0), 60.0),
    "Foucault": (_foucault, (1.0, 0.0, 0.0, 0.0), 50.0),
    "spherical pendulum": (_spherical, (1.0, 0.0, 0.0, 0.5), 40.0),
    "elastic pendulum": (_elastic, (0.4, -0.9, 0.0, 0.0), 40.0),
    "Wilberforce": (_wilberforce, (0.1, 0.0, 0.0, 0.0), 60.0),
    "swinging Atwood": (_atwood, (1.0, PI / 2, 0.0, 0.0), 20.0),
    "Lagrange's top": (_top, (0.5, 0.0, 0.0, 0.0), 30.0),
    "Stoermer": (_stoermer, (1.0, 0.0, 0.3, 0.0, 0.2, 0.2), 20.0),
    "Chaplygin's sleigh": (_sleigh, (0.0, 0.0, 0.0, -1.0, 0.1), 30.0),
    "bead on a hoop": (_hoop, (0.1, 0.0), 60.0),
    "Morse": (_morse, (-0.5, 0.0), 40.0),
    "Toda": (_toda, (0.3, -0.2, 0.1, 0.5, -1.0, 0.5), 30.0),
    "ABC flow": (_abc, (0.5, 1.0, 1.5), 40.0),
    "FPU alpha, 8": (_fpu(0.25, 0.0), (*(math.sin(PI * i / 9) for i in range(1, 9)), *[0.0] * 8), 60.0),
    "FPU beta, 16": (_fpu(0.0, 0.7), (*(math.sin(PI * i / 17) for i in range(1, 17)), *[0.0] * 16), 40.0),
    "Lorenz 96": (_lorenz_96, (8.01, *[8.0] * 7), 6.0),
    "van der Pol, 5": (lambda t, y: (y[1], 5 * (1 - y[0] * y[0]) * y[1] - y[0]), (2.0, 0.0), 30.0),
    "Ueda": (lambda t, y: (y[1], 7.5 * math.cos(t) - 0.05 * y[1] - y[0] ** 3), (2.5, 0.0), 20.0),
    "driven pendulum": (  # Baker and Gollub, Chaotic Dynamics (1990)
        lambda t, y: (y[1], -y[1] / 2 - math.sin(y[0]) + 1.15 * math.cos(2 * t / 3)),
        (0.2, 0.0),
        60.0,
    ),
    "STIFF A1": (lambda t, y: tuple(-k * x for k, x in zip(STIFF_A1, y, strict=True)), (1.0, 1.0, 1.0, 1.0), 20.0),
    "STIFF C1": (_stiff_c1, (1.0, 1.0, 1.0, 1.0), 20.0),
}
