"""There is no constraint force: the particle falls freely.

fails: acceleration_is_that_of_both_forces
also: The force lacks the term with the square of the speed
"""

def acceleration(state, *, mass, length, gravity):
    return np.array([0.0, -gravity])
