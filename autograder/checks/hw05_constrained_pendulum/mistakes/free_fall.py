"""The acceleration of a free particle.

fails: acceleration_is_that_of_both_forces
suspect: a free fall
"""

def acceleration(state, *, mass, length, gravity):
    return np.array([0.0, -gravity])
