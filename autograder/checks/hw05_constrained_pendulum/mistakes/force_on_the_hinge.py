"""The force on the hinge, not on the particle.

fails: force_keeps_the_particle_on_the_circle
suspect: the force on the hinge
"""

_right_force = constraint_force


def constraint_force(state, **parameters):
    return -_right_force(state, **parameters)
