"""simulate_euler makes one Runge-Kutta step from sample to sample.

fails: euler_simulation_follows_the_motion
numerics: steps that grow with the distance of the times
names: do your steps depend on t
"""


def simulate_euler(t, state, **disk):
    def rates(y):
        return np.array(euler_state_derivative(0, y, **disk))

    states = [np.asarray(state, float)]
    for h in np.diff(t):
        y = states[-1]
        k1 = rates(y)
        k2 = rates(y + h / 2 * k1)
        k3 = rates(y + h / 2 * k2)
        k4 = rates(y + h * k3)
        states.append(y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    return np.array(states)
