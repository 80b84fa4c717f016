"""The weight is counted in the constraint force, which is only the rod's.

fails: force_keeps_the_particle_on_the_circle
"""

_right_force, _right_acceleration = constraint_force, acceleration


def constraint_force(state, *, mass, length, gravity):
    return mass * _right_acceleration(state, mass=mass, length=length, gravity=gravity)
