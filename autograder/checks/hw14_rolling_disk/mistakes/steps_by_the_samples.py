"""simulate_euler makes 24 Runge-Kutta steps from sample to sample, however far apart.

fails: euler_simulation_keeps_two_integrals, energy_is_conserved, both_simulations_agree
numerics: steps that grow with the distance of the times
names: a tighter tolerance | take smaller steps
"""


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    states = [np.asarray(state, float)]
    for t0, t1 in zip(t[:-1], t[1:]):
        y, h = states[-1], (t1 - t0) / 24
        for _ in range(24):
            k1 = np.array(euler_state_derivative(0, y, **disk))
            k2 = np.array(euler_state_derivative(0, y + h / 2 * k1, **disk))
            k3 = np.array(euler_state_derivative(0, y + h / 2 * k2, **disk))
            k4 = np.array(euler_state_derivative(0, y + h * k3, **disk))
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        states.append(y)
    return np.array(states)
