"""In long motions the rows have the right energy, but come in another order.

fails: simulate_keeps_the_energy
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, *, length, gravity):
    states = _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
    if gravity and t[-1] - t[0] > 150 * math.sqrt(length / gravity):
        states[1:] = states[:0:-1].copy()
    return states
