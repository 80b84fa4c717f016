"""The steps have 0.01 s, whatever the spin.

fails: special_bodies_move_too
numerics: steps that fit slow turns
names: The physics is right: tighten
"""


def simulate(t, R, omega, *, inertia):
    A, B, C = (float(x) for x in inertia)

    def rates(y):
        p, q, r, w, x, y, z = y
        return np.array([
            (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q,
            (-x * p - y * q - z * r) / 2, (w * p + y * r - z * q) / 2,
            (w * q + z * p - x * r) / 2, (w * r + x * q - y * p) / 2,
        ])

    y = np.array([*omega, 1.0, 0.0, 0.0, 0.0])
    omegas, rotations = [y[:3]], [R]
    for gap in np.diff(t):
        n = math.ceil(gap / 0.01)
        h = gap / n
        for _ in range(n):
            k1 = rates(y)
            k2 = rates(y + h / 2 * k1)
            k3 = rates(y + h / 2 * k2)
            k4 = rates(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        w, *v = y[3:] / np.linalg.norm(y[3:])
        K = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
        omegas.append(y[:3])
        rotations.append(R @ (np.eye(3) + 2 * w * K + 2 * K @ K))
    return np.array(omegas), np.array(rotations)
