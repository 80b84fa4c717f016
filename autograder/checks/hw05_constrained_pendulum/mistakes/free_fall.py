"""The constraint force is left out: the particle falls freely.

fails: acceleration_is_that_of_both_forces
also: The centripetal term is missing
"""

def acceleration(state, *, mass, length, gravity):
    return np.array([0.0, -gravity])
