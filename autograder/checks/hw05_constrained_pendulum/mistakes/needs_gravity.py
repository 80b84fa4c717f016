"""Time in units of sqrt(l/g), which there is none of without gravity.

fails: without_gravity_it_goes_round_uniformly
names: ValueError for no gravity
"""

_right_simulate = simulate


def simulate(t, state, *, mass, length, gravity):
    with np.errstate(all="ignore"):
        return _right_simulate(t * np.sqrt(np.float64(gravity) / length) / np.sqrt(np.float64(gravity) / length), state,
                               mass=mass, length=length, gravity=gravity)
