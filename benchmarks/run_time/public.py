"""Public problems, on which nothing is tuned: rhs(t, y), start, duration.

DETEST: Hull, Enright, Fellen, Sedgwick, Comparing numerical methods for ordinary differential equations, SIAM J. Numer.
Anal. 9 (1972). Arenstorf, Brusselator, Lorenz, Pleiades: Hairer, Norsett, Wanner, Solving ODEs I. Figure eight:
Chenciner and Montgomery (2000). A problem is added by one more row of PROBLEMS.
"""

import math

PI = math.pi


def _b4(t, y):
    r = math.sqrt(y[0] * y[0] + y[1] * y[1])
    return -y[1] - y[0] * y[2] / r, y[0] - y[1] * y[2] / r, y[0] / r


def _chain(rate):
    def rates(t, y):
        return -y[0], *(rate(i) * y[i - 1] - rate(i + 1) * y[i] for i in range(1, 9)), rate(9) * y[8]

    return rates


def _heat(t, y):
    u = (0.0, *y, 0.0)
    return tuple(u[i - 1] - 2 * u[i] + u[i + 1] for i in range(1, len(y) + 1))


def _cube(x, y, z=0.0):
    square = x * x + y * y + z * z
    return square * math.sqrt(square)


SUN, GRAVITY = 1.00000597682, 2.95912208286  # mass with the inner planets; AU^3 / (100 d)^2 of the sun's mass
PLANETS = 0.000954786104043, 0.000285583733151, 0.0000437273164546, 0.0000517759138449, 0.00000277777777778


def _outer_planets(t, y):
    places = [y[3 * i : 3 * i + 3] for i in range(5)]
    near = [[m / _cube(*p) * x for x in p] for m, p in zip(PLANETS, places, strict=True)]
    rates = []
    for i, (m, p) in enumerate(zip(PLANETS, places, strict=True)):
        pull = [-(SUN + m) * x / _cube(*p) for x in p]
        for j, (other, q) in enumerate(zip(PLANETS, places, strict=True)):
            if i != j:
                apart = [b - a for a, b in zip(p, q, strict=True)]
                pull = [f + other * d / _cube(*apart) - n for f, d, n in zip(pull, apart, near[j], strict=True)]
        rates += [GRAVITY * f for f in pull]
    return *y[15:], *rates


OUTER = (
    *(3.42947415189, 3.35386959711, 1.35494901715, 6.64145542550, 5.97156957878, 2.18231499728),
    *(11.2630437207, 14.6952576794, 6.27960525067, -30.1552268759, 1.65699966404, 1.43785752721),
    *(-21.1238353380, 28.4465098142, 15.3882659679),
    *(-0.557160570446, 0.505696783289, 0.230578543901, -0.415570776342, 0.365682722812, 0.169143213293),
    *(-0.325325669158, 0.189706021964, 0.0877265322780, -0.0240476254170, -0.287659532608, -0.117219543175),
    *(-0.176860753121, -0.216393453025, -0.0148647893090),
)


def _kepler(t, s):
    x, y, u, v = s
    cube = _cube(x, y)
    return u, v, -x / cube, -y / cube


def _ellipse(e):
    return 1 - e, 0.0, 0.0, math.sqrt((1 + e) / (1 - e))


def _bessel(t, y):
    x = t + 1
    return y[1], -(y[1] / x + (1 - 0.25 / (x * x)) * y[0])


def _arenstorf(t, s):
    x, y, u, v = s
    mu = 0.012277471
    earth, moon = _cube(x + mu, y), _cube(x - 1 + mu, y)
    return (
        u,
        v,
        x + 2 * v - (1 - mu) * (x + mu) / earth - mu * (x - 1 + mu) / moon,
        y - 2 * u - (1 - mu) * y / earth - mu * y / moon,
    )


def _henon_heiles(t, s):
    x, y, u, v = s
    return u, v, -x - 2 * x * y, -y - x * x + y * y


def _heavy_top(t, s):
    """Return rates of the angular velocity and the vertical, in the body's axes."""
    p, q, r, x, y, z = s
    A, B, C, weight = 1.0, 1.2, 0.5, 2.0
    return (
        ((B - C) * q * r + weight * y) / A,
        ((C - A) * r * p - weight * x) / B,
        (A - B) * p * q / C,
        r * y - q * z,
        p * z - r * x,
        q * x - p * y,
    )


def _double_pendulum(t, s):
    """Point masses and rods of one unit each."""
    a, b, p, q = s
    c, d = math.cos(a - b), math.sin(a - b)
    f, g = -d * q * q - 2 * 9.81 * math.sin(a), d * p * p - 9.81 * math.sin(b)
    return p, q, (f - c * g) / (2 - c * c), (2 * g - c * f) / (2 - c * c)


def _bodies(masses):
    """Return the rates of bodies in a plane; the state has all x, all y, all velocities along x, then along y."""
    k = len(masses)

    def rates(t, s):
        x, y = s[:k], s[k : 2 * k]
        fx, fy = [0.0] * k, [0.0] * k
        for i in range(k):
            for j in range(i):
                dx, dy = x[j] - x[i], y[j] - y[i]
                cube = _cube(dx, dy)
                fx[i], fy[i] = fx[i] + masses[j] * dx / cube, fy[i] + masses[j] * dy / cube
                fx[j], fy[j] = fx[j] - masses[i] * dx / cube, fy[j] - masses[i] * dy / cube
        return *s[2 * k :], *fx, *fy

    return rates


EIGHT = (
    *(0.97000436, -0.97000436, 0.0, -0.24308753, 0.24308753, 0.0),
    *(0.466203685, 0.466203685, -0.93240737, 0.43236573, 0.43236573, -0.86473146),
)
PLEIADES = (
    *(3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0, 3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0),
    *(0.0, 0.0, 0.0, 0.0, 0.0, 1.75, -1.5, 0.0, 0.0, 0.0, -1.25, 1.0, 0.0, 0.0),
)


def _unit(size):
    return 1.0, *[0.0] * (size - 1)


PROBLEMS = {
    "DETEST A1": (lambda t, y: (-y[0],), (1.0,), 20.0),
    "DETEST A2": (lambda t, y: (-y[0] * y[0] * y[0] / 2,), (1.0,), 20.0),
    "DETEST A3": (lambda t, y: (y[0] * math.cos(t),), (1.0,), 20.0),
    "DETEST A4": (lambda t, y: (y[0] / 4 * (1 - y[0] / 20),), (1.0,), 20.0),
    "DETEST A5": (lambda t, y: ((y[0] - t) / (y[0] + t),), (4.0,), 20.0),
    "DETEST B1": (lambda t, y: (2 * (y[0] - y[0] * y[1]), -(y[1] - y[0] * y[1])), (1.0, 3.0), 20.0),
    "DETEST B2": (lambda t, y: (-y[0] + y[1], y[0] - 2 * y[1] + y[2], y[1] - y[2]), (2.0, 0.0, 1.0), 20.0),
    "DETEST B3": (lambda t, y: (-y[0], y[0] - y[1] * y[1], y[1] * y[1]), (1.0, 0.0, 0.0), 20.0),
    "DETEST B4": (_b4, (3.0, 0.0, 0.0), 20.0),
    "DETEST B5": (lambda t, y: (y[1] * y[2], -y[0] * y[2], -0.51 * y[0] * y[1]), (0.0, 1.0, 1.0), 20.0),
    "DETEST C1": (_chain(lambda i: 1.0), _unit(10), 20.0),
    "DETEST C2": (_chain(float), _unit(10), 20.0),
    "DETEST C3": (_heat, _unit(10), 20.0),
    "DETEST C4": (_heat, _unit(51), 20.0),
    "DETEST C5": (_outer_planets, OUTER, 20.0),
    **{f"DETEST D{i}": (_kepler, _ellipse(0.2 * i - 0.1), 20.0) for i in range(1, 6)},
    "DETEST E1": (_bessel, (0.6713967071418030, 0.09540051444747446), 20.0),
    "DETEST E2": (lambda t, y: (y[1], (1 - y[0] * y[0]) * y[1] - y[0]), (2.0, 0.0), 20.0),
    "DETEST E3": (lambda t, y: (y[1], y[0] ** 3 / 6 - y[0] + 2 * math.sin(2.78535 * t)), (0.0, 0.0), 20.0),
    "DETEST E4": (lambda t, y: (y[1], 0.032 - 0.4 * y[1] * y[1]), (30.0, 0.0), 20.0),
    "DETEST E5": (lambda t, y: (y[1], math.sqrt(1 + y[1] * y[1]) / (25 - t)), (0.0, 0.0), 20.0),
    "Arenstorf": (_arenstorf, (0.994, 0.0, 0.0, -2.00158510637908252), 17.0652165601579625),
    "Kepler, e = .9": (_kepler, _ellipse(0.9), 20 * PI),
    "Brusselator": (lambda t, y: (1 + y[0] * y[0] * y[1] - 4 * y[0], 3 * y[0] - y[0] * y[0] * y[1]), (1.5, 3.0), 20.0),
    "Lorenz": (
        lambda t, y: (10 * (y[1] - y[0]), y[0] * (28 - y[2]) - y[1], y[0] * y[1] - 8 / 3 * y[2]),
        (1.0, 1.0, 1.0),
        10.0,
    ),
    "Henon-Heiles": (_henon_heiles, (0.0, 0.1, 0.47, 0.0), 100.0),
    "Euler's top": (lambda t, y: (-y[1] * y[2], y[2] * y[0], -y[0] * y[1] / 3), (0.1, 1.0, 0.2), 100.0),
    "heavy top": (_heavy_top, (0.1, 0.2, 5.0, 0.6, 0.0, 0.8), 20.0),
    "Duffing": (lambda t, y: (y[1], y[0] - y[0] ** 3 - 0.2 * y[1] + 0.3 * math.cos(1.2 * t)), (0.5, 0.0), 20.0),
    "double pendulum, points": (_double_pendulum, (PI / 2, PI / 2, 0.0, 0.0), 5.0),
    "figure eight": (_bodies((1.0, 1.0, 1.0)), EIGHT, 6.32591398),
    "Pleiades": (_bodies(tuple(range(1, 8))), PLEIADES, 3.0),
}
