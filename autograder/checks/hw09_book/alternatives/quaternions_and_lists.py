"""Show that plain Python passes: unit quaternions by Shepperd's choice of the largest, lists."""

import math


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def quaternion(axis, angle):
    if axis not in ["x", "y", "z"]:
        raise ValueError(axis)
    s = math.sin(angle / 2)
    return math.cos(angle / 2), s * (axis == "x"), s * (axis == "y"), s * (axis == "z")


def matrix(q):
    w, x, y, z = q
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


def axis_rotation(axis, angle):
    return matrix(quaternion(axis, angle))


def space_sequence(steps):
    q = (1, 0, 0, 0)
    for axis, angle in steps:
        q = product(quaternion(axis, angle), q)
    return matrix(q)


def body_sequence(steps):
    q = (1, 0, 0, 0)
    for axis, angle in steps:
        q = product(q, quaternion(axis, angle))
    return matrix(q)


def book_rotations():
    x, z = ("x", math.pi / 2), ("z", math.pi / 2)
    return [space_sequence([z, x]), space_sequence((x, z))]


def axis_angle(R):
    rows = [[float(a) for a in row] for row in R]
    for i in range(3):
        for j in range(3):
            dot = sum(rows[k][i] * rows[k][j] for k in range(3)) - (i == j)
            if not abs(dot) <= 1e-6:
                raise ValueError("not orthogonal")
    (a, b, c), (d, e, f), (g, h, i) = rows
    if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0:
        raise ValueError("a reflection")
    columns = [
        (1 + a + e + i, h - f, c - g, d - b),
        (h - f, 1 + a - e - i, b + d, c + g),
        (c - g, b + d, 1 - a + e - i, f + h),
        (d - b, c + g, f + h, 1 - a - e + i),
    ]
    w, x, y, z = max(columns, key=lambda q: sum(u * u for u in q))
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    length = math.sqrt(x * x + y * y + z * z)
    if length == 0:
        return (0, 0, 1), 0
    return (x / length, y / length, z / length), 2 * math.atan2(length, w)


def book_edges(R, *, size):
    edges = []
    for i in range(8):
        for bit in (1, 2, 4):
            if not i & bit:
                edges.append([corner(R, size, i | bit), corner(R, size, i)])
    return edges


def corner(R, size, i):
    r = [s / 2 if i & bit else -s / 2 for s, bit in zip(size, (1, 2, 4))]
    return [sum(a * b for a, b in zip(row, r)) for row in R]
