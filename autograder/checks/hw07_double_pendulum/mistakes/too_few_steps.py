"""Two Runge-Kutta steps go from row to row of a long motion.

fails: energy_is_conserved_from_horizontal
names: take smaller steps
numerics: steps as long as half the distance of the times
"""


def simulate(t, theta, omega, *, masses, lengths, gravity):
    known = _parameters(masses, lengths, gravity)
    rates = lambda y: np.array(_rates(0.0, tuple(y), **known))
    rows = [np.array([*theta, *omega], float)]
    for span in np.diff(t):
        n = math.ceil(2000 * span / (t[-1] - t[0])) if t[-1] - t[0] < 9 else 2
        y, h = rows[-1], span / n
        for _ in range(n):
            k1 = rates(y)
            k2 = rates(y + h / 2 * k1)
            k3 = rates(y + h / 2 * k2)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + rates(y + h * k3))
        rows.append(y)
    return np.array(rows)
