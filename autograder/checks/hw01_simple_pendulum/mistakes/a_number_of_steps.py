"""The number of Runge-Kutta steps does not grow with the duration.

fails: simulate_needs_no_dense_times, simulate_keeps_the_energy
numerics: steps that grow with the duration
names: does not do for every duration
"""

def _rk4_step(state, h, ratio):
    def f(y):
        return np.array([y[1], -ratio * math.sin(y[0])])

    k1 = f(state)
    k2 = f(state + h / 2 * k1)
    k3 = f(state + h / 2 * k2)
    k4 = f(state + h * k3)
    return state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def simulate(t, theta0, omega0, *, length, gravity):
    rows = [np.array([theta0, omega0])]
    for span in np.diff(t):
        state, steps = rows[-1], math.ceil(700 * span / (t[-1] - t[0]))
        for _ in range(steps):
            state = _rk4_step(state, span / steps, gravity / length)
        rows.append(state)
    return np.array(rows)
