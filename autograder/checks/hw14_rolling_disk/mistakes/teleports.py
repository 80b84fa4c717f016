"""simulate_euler turns the start about z by random angles: the energy and both integrals are right, the motion is not.

fails: euler_simulation_follows_the_motion
unnamed: its numbers are random
"""


def simulate_euler(t, state, **disk):
    states = np.tile(np.asarray(state, float), (len(t), 1))
    states[1:, 2] += np.random.default_rng(1).uniform(-3, 3, len(t) - 1)
    return states
