"""The number of steps is fixed, however long the motion is.

fails: invariants_stay_over_many_turns, special_bodies_move_too
numerics: steps that grow with the duration
names: The steps must be short for a fast turn
"""


def simulate(t, R, omega, *, inertia):
    def rates(y):
        return np.concatenate([euler_equations(y[:3], inertia=inertia), attitude_rate(y[3:].reshape(3, 3), y[:3]).ravel()])

    each = 900 // len(t) if len(t) > 20 else 20
    rows = [np.concatenate([omega, np.ravel(R)])]
    for dt in np.diff(t):
        y, h = rows[-1], dt / each
        for _ in range(each):
            k1 = rates(y)
            k2 = rates(y + h / 2 * k1)
            k3 = rates(y + h / 2 * k2)
            k4 = rates(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    rows = np.array(rows)
    return rows[:, :3], rows[:, 3:].reshape(-1, 3, 3)
