"""A hundred Runge-Kutta steps go from each time to the next, however far.

fails: simulate_needs_no_dense_times
numerics: steps as long as the times are apart
names: take smaller steps
"""

def simulate(t, theta0, omega0, *, length, gravity):
    def f(y):
        return np.array([y[1], -gravity / length * math.sin(y[0])])

    rows = [np.array([theta0, omega0])]
    for h in np.diff(t) / 100:
        y = rows[-1]
        for _ in range(100):
            a = f(y)
            b = f(y + h / 2 * a)
            c = f(y + h / 2 * b)
            y = y + h / 6 * (a + 2 * b + 2 * c + f(y + h * c))
        rows.append(y)
    return np.array(rows)
