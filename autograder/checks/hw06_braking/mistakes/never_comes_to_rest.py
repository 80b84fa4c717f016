"""Fixed steps go on through the stop, and the car goes to and fro.

fails: simulate_comes_to_rest_and_stays
names: it goes back after the stop
"""


def simulate(t, state, locked, **car):
    parameters = _car(locked, **car)

    def rates(y):
        return np.array(_rates(0.0, y, **parameters))

    rows = [np.array(state)]
    for h in np.diff(t):
        y, n = rows[-1], math.ceil(1000 * h / (t[-1] - t[0]))
        for _ in range(n):
            k1 = rates(y)
            k2 = rates(y + h / n / 2 * k1)
            k3 = rates(y + h / n / 2 * k2)
            k4 = rates(y + h / n * k3)
            y = y + h / n / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    return np.array(rows)
