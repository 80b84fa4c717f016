"""Over many periods the rows have the right energy, but come in another order.

fails: simulate_keeps_the_energy
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    states = _right(t, x, v, curvature=curvature, gravity=gravity)
    if (t[-1] - t[0]) * math.sqrt(2 * curvature * gravity) > 150:
        states[1:] = states[:0:-1].copy()
    return states
