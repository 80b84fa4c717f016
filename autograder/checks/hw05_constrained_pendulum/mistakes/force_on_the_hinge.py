"""This is the force on the hinge; the force on the particle is opposite.

fails: force_keeps_the_particle_on_the_circle
"""

_right_force = constraint_force


def constraint_force(state, **parameters):
    return -_right_force(state, **parameters)
