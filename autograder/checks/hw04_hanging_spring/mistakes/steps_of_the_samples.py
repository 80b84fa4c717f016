"""A fixed number of Runge-Kutta steps goes from each time to the next, however far.

fails: simulate_does_not_depend_on_the_sampling, energy_stays
numerics: steps as long as the times are apart
names: take smaller steps
"""

def simulate(t, position, velocity, **parameters):
    def f(y):
        return np.array(state_derivative(0, y, **parameters))

    y, rows = np.concatenate([position, velocity]), []
    rate = np.sqrt(parameters["stiffness"] / parameters["mass"])
    for before, after in zip(t, [*t[1:], t[-1]]):
        rows.append(y)
        steps = 40 if rate * (after - before) < 6 else 80
        for _ in range(steps if rate * (t[-1] - t[0]) < 30 else 8):
            h = (after - before) / (steps if rate * (t[-1] - t[0]) < 30 else 8)
            a = f(y)
            b = f(y + h / 2 * a)
            c = f(y + h / 2 * b)
            d = f(y + h * c)
            y = y + h / 6 * (a + 2 * b + 2 * c + d)
    return np.array(rows)
