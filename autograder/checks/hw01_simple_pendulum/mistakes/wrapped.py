"""The angle is brought back between -pi and pi; angles are never wrapped.

fails: simulate_turns_over_the_top
names: Only whole turns are missing
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    states = _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
    states[:, 0] = (states[:, 0] + np.pi) % (2 * np.pi) - np.pi
    return states
