"""The acceleration is the sum of the forces, not divided by the mass.

fails: acceleration_is_that_of_both_forces
"""

def acceleration(state, *, mass, length, gravity):
    return constraint_force(state, mass=mass, length=length, gravity=gravity) + [0, -mass * gravity]
