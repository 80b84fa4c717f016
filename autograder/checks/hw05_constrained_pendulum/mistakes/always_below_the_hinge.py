"""y from x and the constraint, below the hinge.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
names: every row but the first is below the hinge
"""

_right = simulate


def simulate(t, state, *, length, **known):
    states = np.array(_right(t, state, length=length, **known))
    states[:, 1] = -np.sqrt(np.maximum(0.0, length**2 - states[:, 0] ** 2))
    return states
