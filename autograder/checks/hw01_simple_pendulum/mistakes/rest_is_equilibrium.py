"""A pendulum that starts at rest is left where it is; gravity should move it.

fails: simulate_needs_no_dense_times
names: Every row is the start
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    if omega0 == 0:
        return np.tile([theta0, 0.0], (len(t), 1))
    return _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
