"""The given omega is treated as omega at t = 0, not at t[0].

fails: symmetric_bodies_precess
"""

_right_symmetric = symmetric_solution


def symmetric_solution(t, omega, *, inertia):
    return _right_symmetric(np.concatenate([[0.0], t]), omega, inertia=inertia)[1:]
