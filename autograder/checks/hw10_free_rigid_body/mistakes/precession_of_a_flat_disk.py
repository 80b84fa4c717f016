"""The rate is omega_3, which holds only for a flat disk, C = 2 A.

fails: symmetric_bodies_precess
"""


def symmetric_solution(t, omega, *, inertia):
    A, _, C = inertia
    across = complex(*omega[:2]) * np.exp(1j * 1.0 * omega[2] * (np.asarray(t) - t[0]))
    return np.column_stack([across.real, across.imag, np.full(len(t), omega[2])])
