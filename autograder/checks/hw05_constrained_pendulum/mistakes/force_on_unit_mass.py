"""The force lacks the mass, which is right only for 1 kg.

fails: force_keeps_the_particle_on_the_circle
"""

_right = constraint_force


def constraint_force(state, *, mass, length, gravity):
    return _right(state, mass=1.0, length=length, gravity=gravity)
