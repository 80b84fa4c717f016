"""Right: plain Python; quaternions and Runge-Kutta steps of fixed size, results as lists."""

from math import atan2, ceil, cos, hypot, pi, sin, sqrt


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def combined(*terms):
    return [sum(k * v[i] for k, v in terms) for i in range(3)]


def product(a, b):
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]


def columns(q):
    w, x, y, z = q
    return (
        [w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z],
    )


def quaternion(yaw, tilt, roll):
    def about(i, angle):
        q = [cos(angle / 2), 0, 0, 0]
        q[i] = sin(angle / 2)
        return q

    return product(product(about(3, yaw), about(1, tilt)), about(3, roll))


def frame(n):
    s = hypot(n[0], n[1])
    e1 = [-n[1] / s, n[0] / s, 0]
    return e1, cross(n, e1)


def omega_rate(n, w, mass, radius, inertia, gravity):
    (A, C), m = inertia, mass * radius**2
    e1, e2 = frame(n)
    e2_rate = cross(combined((dot(w, e1), e1), (dot(w, e2) / e2[2], [0, 0, 1])), e2)
    force = combined((mass * radius, cross(w, e2_rate)), (mass * gravity, [0, 0, 1]))
    moment = combined((-radius, cross(e2, force)), (-(C - A) * dot(w, n), cross(w, n)))
    parts = ((A + m, e1), (A, e2), (C + m, n))
    return combined(*((dot(moment, e) / size, e) for size, e in parts))


def stepped(rates, t, y, largest):
    """Runge-Kutta, a whole number of steps between samples."""
    found = [list(y)]
    for t0, t1 in zip(t[:-1], t[1:], strict=True):
        steps = ceil((t1 - t0) / largest)
        h = (t1 - t0) / steps
        for _ in range(steps):
            k1 = rates(y)
            k2 = rates([a + h / 2 * b for a, b in zip(y, k1, strict=True)])
            k3 = rates([a + h / 2 * b for a, b in zip(y, k2, strict=True)])
            k4 = rates([a + h * b for a, b in zip(y, k3, strict=True)])
            y = [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4, strict=True)]
        found.append(list(y))
    return found


def matrix_state(state, *, radius):
    x, y, yaw, tilt, roll, p, q, r = state
    q0 = quaternion(yaw, tilt, roll)
    R = columns(q0)
    e1, e2 = frame([sin(yaw) * sin(tilt), -cos(yaw) * sin(tilt), cos(tilt)])
    w = combined((p, [0, 0, 1]), (q, [cos(yaw), sin(yaw), 0]), (r, R[2]))
    return [*combined((1, [x, y, 0]), (radius, e2)), *(R[j][i] for i in range(3) for j in range(3)), *w]


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    state = [float(x) for x in state]
    w = state[12:]
    cols = [state[3 + i : 12 : 3] for i in range(3)]
    turned = [cross(w, col) for col in cols]
    centre = combined((radius, cross(w, frame(cols[2])[1])))
    return [
        *centre,
        *(turned[j][i] for i in range(3) for j in range(3)),
        *omega_rate(cols[2], w, mass, radius, inertia, gravity),
    ]


multiplier_state_derivative = matrix_state_derivative


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    _, _, yaw, tilt, roll, p, q, r = (float(x) for x in state)
    m = matrix_state(state, radius=radius)
    n, w = m[5:12:3], m[12:]
    e1, e2 = frame(n)
    changed = omega_rate(n, w, mass, radius, inertia, gravity)
    # omega' = yaw'' z + tilt'' e1 + roll'' n + yaw' tilt' z x e1 + roll' omega x n
    left = combined((1, changed), (-q * p, cross([0, 0, 1], e1)), (-r, cross(w, n)))
    p1 = dot(left, e2) / e2[2]
    return [
        -radius * r * cos(yaw), -radius * r * sin(yaw), p, q, r,
        p1, dot(left, e1), dot(left, n) - p1 * n[2],
    ]


def step_for(w, radius, gravity):
    return 0.02 / (1 + sqrt(dot(w, w)) + sqrt(gravity / radius))


def simulate_euler(t, state, **disk):
    w = matrix_state(state, radius=disk["radius"])[12:]
    start = [float(x) for x in state]
    return stepped(lambda y: euler_state_derivative(0, y, **disk), t, start, step_for(w, disk["radius"], disk["gravity"]))


def rotation_quaternion(cols):
    n = cols[2]
    yaw, tilt = atan2(n[0], -n[1]), atan2(hypot(n[0], n[1]), n[2])
    return quaternion(yaw, tilt, atan2(cols[0][2], cols[1][2]))


def simulate_matrix(t, state, **disk):
    state = [float(x) for x in state]
    start = [*state[:3], *rotation_quaternion([state[3 + i : 12 : 3] for i in range(3)]), *state[12:]]

    def rates(y):
        n, w = columns(y[3:7])[2], y[7:]
        length = sqrt(dot(n, n))
        n = [x / length for x in n]
        turning = [x / 2 for x in product([0, *w], y[3:7])]
        return [*combined((disk["radius"], cross(w, frame(n)[1]))), *turning, *omega_rate(n, w, **disk)]

    found = []
    largest = step_for(state[12:], disk["radius"], disk["gravity"])
    for row in stepped(rates, t, start, largest):
        size = sqrt(dot(row[3:7], row[3:7]))
        R = columns([x / size for x in row[3:7]])
        found.append([*row[:3], *(R[j][i] for i in range(3) for j in range(3)), *row[7:]])
    return found


def energy(state, *, mass, radius, inertia, gravity):
    m = matrix_state(state, radius=radius)
    n, w = m[5:12:3], m[12:]
    (A, C), v = inertia, cross(w, combined((radius, frame(n)[1])))
    spin = dot(w, n)
    return (mass * dot(v, v) + A * (dot(w, w) - spin**2) + C * spin**2) / 2 + mass * gravity * m[2]


def contact_force(state, *, mass, radius, inertia, gravity):
    m = matrix_state(state, radius=radius)
    n, w = m[5:12:3], m[12:]
    e1, e2 = frame(n)
    turning = combined((state[5], [0, 0, 1]), (state[6], e1))
    changed = omega_rate(n, w, mass, radius, inertia, gravity)
    acceleration = combined((radius, cross(changed, e2)), (radius, cross(w, cross(turning, e2))))
    return combined((mass, acceleration), (mass * gravity, [0, 0, 1]))


def steady_residual(lean, precession, spin, **disk):
    return euler_state_derivative(0, steady(lean, precession, spin), **disk)[6]


def steady(lean, precession, spin):
    return [0, 0, 0, lean + pi / 2, 0, precession, 0, spin + precession * sin(lean)]


def critical_speed(*, mass, radius, inertia, gravity):
    k, n = (i / (mass * radius**2) for i in inertia)
    return sqrt(gravity * radius * k / (n * (1 + n)))


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    k, n = (i / (mass * radius**2) for i in inertia)
    return gravity / radius / (1 + k) - n * (1 + n) / (k * (1 + k)) * (speed / radius) ** 2


def wireframe(state, *, radius, sides):
    m = matrix_state(state, radius=radius)
    R = [m[3 + i : 12 : 3] for i in range(3)]

    def at(angle):
        return combined((1, m[:3]), (radius * cos(angle), R[0]), (radius * sin(angle), R[1]))

    rim = [at(-2 * pi * i / sides) for i in range(sides)]
    return [[rim[i - 1], rim[i]] for i in range(sides)] + [[at(pi), at(0)], [at(pi / 2), at(-pi / 2)]]


def free_body_diagram(state, *, mass, radius, gravity):
    x, y, yaw, tilt = (float(one) for one in state[:4])
    flat = radius * cos(tilt)
    centre = (x - flat * sin(yaw), y + flat * cos(yaw), radius * sin(tilt))
    ground = [((x, y, 0.0), axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return [*ground, (centre, (0, 0, -gravity))]
