"""At t[0] omega is put in the plane of the axes 0 and 2: it starts with the q that is given.

fails: symmetric_bodies_precess
"""


def symmetric_solution(t, omega, *, inertia):
    p, q, r = omega
    A, _, C = inertia
    turned, across = (C - A) / A * r * (np.asarray(t) - t[0]), math.hypot(p, q)
    return np.column_stack([across * np.cos(turned), across * np.sin(turned), np.full(len(turned), r)])
