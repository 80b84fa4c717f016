"""The angle at t[0] is arctan(q/p), which does not tell (p, q) from (-p, -q); arctan2(q, p) does.

fails: symmetric_bodies_precess
where: a random body with A = B
"""


def symmetric_solution(t, omega, *, inertia):
    p, q, r = omega
    A, _, C = inertia
    start = math.atan(q / p) if p else math.copysign(math.pi / 2, q)
    turned, across = start + (C - A) / A * r * (np.asarray(t) - t[0]), math.hypot(p, q)
    return np.column_stack([across * np.cos(turned), across * np.sin(turned), np.full(len(turned), r)])
