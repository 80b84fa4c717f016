"""Time is measured in units of 1/sqrt(2 g c), which is infinite without gravity.

fails: simulate_without_gravity
names: raised ValueError for gravity 0
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    rate = np.sqrt(2 * gravity * curvature)
    states = _right_simulate((t - t[0]) * rate, x, v / rate, curvature=curvature, gravity=gravity / rate**2)
    return states * [1, rate]
