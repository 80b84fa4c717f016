"""These are Runge-Kutta steps, not a closed form.

fails: trajectory_with_any_drag
names: NaN or infinity for great drag
"""


def trajectory(t, speed, angle, *, mass, drag, gravity):
    steps, zero = 2000, 0 * np.asarray(t, float)
    h = t / steps
    state = np.array([zero, zero, zero + speed * math.cos(angle), zero + speed * math.sin(angle)])

    def rates(y):
        return np.array([y[2], y[3], -drag / mass * y[2], -drag / mass * y[3] - gravity])

    for _ in range(steps):
        k1 = rates(state)
        k2 = rates(state + h / 2 * k1)
        k3 = rates(state + h / 2 * k2)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + rates(state + h * k3))
    return state.T
