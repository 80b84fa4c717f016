"""The particle is held at launch height; it should go on below, as there is no ground.

fails: simulation_follows_the_motion, both_paths_are_drawn
names: there is no ground
"""

_right_simulate = simulate


def simulate(*launch, **known):
    states = np.array(_right_simulate(*launch, **known))
    states[states[:, 1] < 0, 1] = 0.0
    return states
