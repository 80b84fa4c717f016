"""Five Runge-Kutta steps go from each time to the next, however far.

fails: simulate_needs_no_dense_times, simulate_keeps_the_energy
numerics: steps that grow with the distance of the times
names: too few steps for this duration
"""


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    def rates(y):
        return np.array([y[1], acceleration(y[0], y[1], **c)])

    rows = [np.array([phi, phi_dot])]
    for h in np.diff(t):
        y = rows[-1]
        n = 5
        for _ in range(n):
            k1 = rates(y)
            k2 = rates(y + h / n / 2 * k1)
            k3 = rates(y + h / n / 2 * k2)
            k4 = rates(y + h / n * k3)
            y = y + h / n / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    return np.array(rows)
