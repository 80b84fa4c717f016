"""Two Runge-Kutta steps go from each time to the next, however far.

fails: simulation_follows_the_motion
names: take smaller steps | tighten
numerics: the length of the steps
"""


def simulate(t, speed, angle, **known):
    rate = lambda state: state_derivative(0.0, state, **known)
    states = [np.array([0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle)])]
    for step in np.diff(t) / 2:
        state = states[-1]
        for _ in range(2):
            a = rate(state)
            b = rate(state + step / 2 * a)
            c = rate(state + step / 2 * b)
            state = state + step / 6 * (a + 2 * b + 2 * c + rate(state + step * c))
        states.append(state)
    return np.array(states)
