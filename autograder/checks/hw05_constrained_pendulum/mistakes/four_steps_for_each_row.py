"""The number of steps for each row is fixed.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
names: take smaller steps
"""


def simulate(t, state, *, length, **parameters):
    def rates(y):
        return np.append(y[2:], acceleration(y, length=length, **parameters))

    rows = [np.array(state)]
    for step in np.diff(t) / 4:
        y = rows[-1]
        for _ in range(4):
            k = rates(y)
            y = consistent_state(y + step / 2 * (k + rates(y + step * k)), length=length)
        rows.append(y)
    return np.array(rows)
