"""The steps of 0.01 s are too long for a short pendulum.

fails: simulate_needs_no_dense_times
numerics: a step of fixed length
names: take smaller steps
"""

def simulate(t, theta0, omega0, *, length, gravity):
    def f(y):
        return np.array([y[1], -gravity / length * math.sin(y[0])])

    rows = [np.array([theta0, omega0])]
    for span in np.diff(t):
        y, steps = rows[-1], math.ceil(span / 0.01)
        h = span / steps
        for _ in range(steps):
            a = f(y)
            b = f(y + h / 2 * a)
            c = f(y + h / 2 * b)
            d = f(y + h * c)
            y = y + h / 6 * (a + 2 * b + 2 * c + d)
        rows.append(y)
    return np.array(rows)
