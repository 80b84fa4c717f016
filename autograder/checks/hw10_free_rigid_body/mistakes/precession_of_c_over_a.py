"""omega goes round in the body at C/A omega_3; it should be (C - A)/A omega_3.

fails: symmetric_bodies_precess
"""


def symmetric_solution(t, omega, *, inertia):
    p, q, r = omega
    A, _, C = inertia
    turned = C / A * r * (np.asarray(t) - t[0])
    c, s = np.cos(turned), np.sin(turned)
    return np.column_stack([p * c - q * s, q * c + p * s, np.full(len(turned), r)])
