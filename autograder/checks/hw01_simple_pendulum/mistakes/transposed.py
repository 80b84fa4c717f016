"""The rows and columns are exchanged: solve_ivp returns (2, n).

fails: simulate_swings
names: not an array of shape (1000, 2)
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    return _right_simulate(t, theta0, omega0, length=length, gravity=gravity).T
