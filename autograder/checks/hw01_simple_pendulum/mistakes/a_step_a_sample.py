"""One Runge-Kutta step goes from each time to the next, however far.

fails: simulate_needs_no_dense_times, simulate_turns_over_the_top, simulate_keeps_the_energy
numerics: steps as long as the times are apart
names: take smaller steps
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
    for h in np.diff(t):
        rows.append(_rk4_step(rows[-1], h, gravity / length))
    return np.array(rows)
