"""simulate_euler makes one midpoint step from sample to sample.

fails: euler_simulation_follows_the_motion
numerics: steps that grow with the distance of the times
names: take smaller steps
"""


def simulate_euler(t, state, **disk):
    def rates(y):
        return np.array(euler_state_derivative(0, y, **disk))

    states = [np.asarray(state, float)]
    for h in np.diff(t):
        y = states[-1]
        states.append(y + h * rates(y + h / 2 * rates(y)))
    return np.array(states)
