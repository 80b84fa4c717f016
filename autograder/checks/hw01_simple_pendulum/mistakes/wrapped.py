"""The angle brought back between -pi and pi.

fails: simulate_turns_over_the_top
names: off by whole turns alone
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    states = _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
    states[:, 0] = (states[:, 0] + np.pi) % (2 * np.pi) - np.pi
    return states
