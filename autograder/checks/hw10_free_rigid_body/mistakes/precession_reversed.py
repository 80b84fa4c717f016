"""The precession goes the other way.

fails: symmetric_bodies_precess
"""


def symmetric_solution(t, omega, *, inertia):
    p, q, r = omega
    turned = (inertia[0] - inertia[2]) / inertia[0] * r * (np.asarray(t) - t[0])
    c, s = np.cos(turned), np.sin(turned)
    return np.column_stack([p * c - q * s, q * c + p * s, np.full(len(turned), r)])
