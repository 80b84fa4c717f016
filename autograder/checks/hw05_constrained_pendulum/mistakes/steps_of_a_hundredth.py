"""The step is a hundredth of a second, whatever the motion.

fails: with_gravity_it_swings_or_goes_round
numerics: a step of 0.01 s does for rods of a metre
names: tighten rtol and atol | take smaller steps
"""


def simulate(t, state, *, mass, length, gravity):
    rows = [np.asarray(state, float)]
    for span in np.diff(t):
        steps = math.ceil(span / 0.01)
        y = np.array([*rows[-1][:2] / length, (rows[-1][0] * rows[-1][3] - rows[-1][1] * rows[-1][2]) / length**2])
        for _ in range(steps):
            y = _step(y, span / steps, gravity / length)
        across = np.array([-y[1], y[0]]) / math.hypot(*y[:2])
        rows.append(length * np.array([across[1], -across[0], *(y[2] * across)]))
    return np.array(rows)


def _step(y, h, pull):
    def rates(y):
        return np.array(_rates(0.0, y, pull=pull))

    k1 = rates(y)
    k2 = rates(y + h / 2 * k1)
    k3 = rates(y + h / 2 * k2)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + rates(y + h * k3))
