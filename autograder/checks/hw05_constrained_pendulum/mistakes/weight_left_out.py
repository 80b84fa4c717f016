"""The acceleration has only the constraint force; the weight acts, too.

fails: acceleration_is_that_of_both_forces
"""

def acceleration(state, *, mass, length, gravity):
    return constraint_force(state, mass=mass, length=length, gravity=gravity) / mass
