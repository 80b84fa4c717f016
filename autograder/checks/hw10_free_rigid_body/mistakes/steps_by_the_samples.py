"""300 Runge-Kutta steps go from each time to the next, however far.

fails: special_bodies_move_too
numerics: steps that grow with the distance of the times
names: take smaller steps
"""


def simulate(t, R, omega, *, inertia):
    def rates(y):
        return np.concatenate([euler_equations(y[:3], inertia=inertia), attitude_rate(y[3:].reshape(3, 3), y[:3]).ravel()])

    rows = [np.concatenate([omega, np.ravel(R)])]
    for dt in np.diff(t):
        y, h = rows[-1], dt / 300
        for _ in range(300):
            k1 = rates(y)
            k2 = rates(y + h / 2 * k1)
            k3 = rates(y + h / 2 * k2)
            k4 = rates(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    rows = np.array(rows)
    return rows[:, :3], rows[:, 3:].reshape(-1, 3, 3)
