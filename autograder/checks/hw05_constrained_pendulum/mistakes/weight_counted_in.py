"""The force is the sum of the rod's and the weight.

fails: force_keeps_the_particle_on_the_circle
names: the weight is counted in
"""

_right_force, _right_acceleration = constraint_force, acceleration


def constraint_force(state, *, mass, length, gravity):
    return mass * _right_acceleration(state, mass=mass, length=length, gravity=gravity)
