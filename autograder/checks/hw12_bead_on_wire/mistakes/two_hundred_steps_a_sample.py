"""Two hundred Runge-Kutta steps go from each time to the next, however far.

fails: simulate_needs_no_dense_times
numerics: steps that grow with the distance of the times
names: take smaller steps
"""

def simulate(t, x, v, *, curvature, gravity):
    def rates(y):
        return np.array([y[1], acceleration_newton(y[0], y[1], curvature=curvature, gravity=gravity)])

    rows = [np.array([x, v])]
    for h in np.diff(t) / 200:
        y = rows[-1]
        for _ in range(200):
            k1 = rates(y)
            k2 = rates(y + h / 2 * k1)
            k3 = rates(y + h / 2 * k2)
            k4 = rates(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    return np.array(rows)
