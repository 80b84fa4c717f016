"""The motion without gravity raises an error; it should go round uniformly.

fails: without_gravity_it_goes_round_uniformly
names: simulate raised
"""

_right_simulate = simulate


def simulate(t, state, *, mass, length, gravity):
    with np.errstate(all="ignore"):
        return _right_simulate(t * np.sqrt(np.float64(gravity) / length) / np.sqrt(np.float64(gravity) / length), state,
                               mass=mass, length=length, gravity=gravity)
