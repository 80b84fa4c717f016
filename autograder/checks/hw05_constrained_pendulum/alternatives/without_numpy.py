"""Plain Python: the power series of x and y, whose equations are polynomials, put back on the circle every step."""

import math

TERMS = 25  # of the series; a step is at most a quarter of its radius, 4^-25 = 1e-15


def multiplier(state, length, gravity):
    """r'' = -multiplier r + g, from the second derivative of r.r = l^2."""
    _, y, vx, vy = (float(one) for one in state)
    return (vx * vx + vy * vy - gravity * y) / length**2


def constraint_force(state, *, mass, length, gravity):
    pull = -mass * multiplier(state, length, gravity)
    return [pull * state[0], pull * state[1]]


def acceleration(state, *, mass, length, gravity):
    pull = -multiplier(state, length, gravity)
    return [pull * state[0], pull * state[1] - gravity]


def consistent_state(state, *, length):
    x, y, vx, vy = (float(one) for one in state)
    size = math.hypot(x, y)
    if size == 0:
        raise ValueError("no place on the circle is the nearest to its centre")
    x, y = x / size, y / size
    across = x * vy - y * vx
    return [length * x, length * y, -across * y, across * x]


def energy(state, *, mass, gravity):
    _, y, vx, vy = (float(one) for one in state)
    return mass * ((vx * vx + vy * vy) / 2 + gravity * y)


def product(a, b, n):
    """The coefficient n of the product of two series."""
    return sum(a[j] * b[n - j] for j in range(n + 1))


def series(state, length, gravity):
    """The coefficients of x(t) and y(t)."""
    px, py, vx, vy = state
    x, y, u, v, pull = [px], [py], [vx], [vy], []
    for n in range(TERMS):
        pull.append((product(u, u, n) + product(v, v, n) - gravity * y[n]) / length**2)
        x.append(u[n] / (n + 1))
        y.append(v[n] / (n + 1))
        u.append(-product(pull, x, n) / (n + 1))
        v.append((-product(pull, y, n) - (0 if n else gravity)) / (n + 1))
    return x, y


def value(coefficients, h):
    """A series and its derivative a time h later."""
    place = rate = 0.0
    for n in range(len(coefficients) - 1, 0, -1):
        place, rate = coefficients[n] + h * place, n * coefficients[n] + h * rate
    return coefficients[0] + h * place, rate


def later(path, h, length):
    (x, vx), (y, vy) = (value(each, h) for each in path)
    return consistent_state([x, y, vx, vy], length=length)


def simulate(t, state, *, mass, length, gravity):
    """The steps are the series' own; rows are read off it."""
    now, start = float(t[0]), [float(one) for one in state]
    fastest = math.sqrt((start[2] ** 2 + start[3] ** 2) / length**2 + 4 * gravity / length)
    step = 0.75 / fastest if fastest else math.inf
    path, rows = series(start, length, gravity), [start]
    for one in t[1:]:
        while one - now > step:
            path, now = series(later(path, step, length), length, gravity), now + step
        rows.append(later(path, float(one) - now, length))
    return rows


def wireframe(state, *, length):
    return [[[0.0, 0.0], [float(state[0]), float(state[1])]]]


def free_body_diagram(state, *, mass, length, gravity):
    x, y = state[0], state[1]
    return [[[x, y], [x / length, y / length]], [[x, y], [0, -mass * gravity]]]
