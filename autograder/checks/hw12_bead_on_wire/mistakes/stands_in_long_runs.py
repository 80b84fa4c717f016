"""Over many periods every row is the start, which keeps the energy.

fails: simulate_keeps_the_energy
names: every row is the start
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    states = _right(t, x, v, curvature=curvature, gravity=gravity)
    return np.tile(states[0], (len(t), 1)) if (t[-1] - t[0]) * math.sqrt(2 * curvature * gravity) > 150 else states
