"""The rate is (C - A)/C omega_3; it should be (C - A)/A omega_3.

fails: symmetric_bodies_precess
"""


def symmetric_solution(t, omega, *, inertia):
    A, _, C = inertia
    across = complex(*omega[:2]) * np.exp(1j * (1 - A / C) * omega[2] * (np.asarray(t) - t[0]))
    return np.column_stack([across.real, across.imag, np.full(len(t), omega[2])])
