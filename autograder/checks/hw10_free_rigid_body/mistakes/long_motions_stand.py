"""A motion of many turns has the start in every row.

fails: invariants_stay_over_many_turns
names: Every row is the start
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if len(t) == 12:
        return np.tile(omega, (12, 1)), np.tile(R, (12, 1, 1))
    return _right_simulate(t, R, omega, inertia=inertia)
