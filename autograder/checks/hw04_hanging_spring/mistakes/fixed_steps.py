"""The steps have 0.0075 s, whatever the spring: too long for a stiff one.

fails: simulate_does_not_depend_on_the_sampling
numerics: a step of fixed length
names: take smaller steps | tighten rtol and atol
"""

def simulate(t, position, velocity, **parameters):
    def f(y):
        return np.array(state_derivative(0, y, **parameters))

    rows = [np.concatenate([position, velocity])]
    for span in np.diff(t):
        y, steps = rows[-1], int(np.ceil(span / 0.0075))
        h = span / steps
        for _ in range(steps):
            a = f(y)
            b = f(y + h / 2 * a)
            c = f(y + h / 2 * b)
            d = f(y + h * c)
            y = y + h / 6 * (a + 2 * b + 2 * c + d)
        rows.append(y)
    return np.array(rows)
