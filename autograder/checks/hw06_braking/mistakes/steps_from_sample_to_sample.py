"""Eight Runge-Kutta steps go from each time to the next, however far.

fails: simulate_needs_no_dense_times, simulate_comes_to_rest_and_stays
numerics: steps that grow with the distance of the times
"""

_right = simulate


def simulate(t, state, locked, **car):
    if len(t) > 30 or car["friction"] * car["gravity"] == 0 or not any(state[3:]):
        return _right(t, state, locked, **car)
    times = np.linspace(0, 1, 8 * len(t) - 7)
    return _coarse(times, t, state, locked, **car)


def _coarse(times, t, state, locked, **car):
    parameters = _car(locked, **car)
    fine = np.interp(times, np.linspace(0, 1, len(t)), t)
    rows = [np.array(state)]
    for h in np.diff(fine):
        y = rows[-1]
        middle = y + h / 2 * np.array(_rates(0.0, y, **parameters))
        rows.append(y + h * np.array(_rates(0.0, middle, **parameters)))
    return np.array(rows)[::8]
