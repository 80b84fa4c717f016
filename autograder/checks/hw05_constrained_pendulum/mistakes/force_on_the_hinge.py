"""The force on the hinge, which is opposite.

fails: force_keeps_the_particle_on_the_circle
"""

_right_force = constraint_force


def constraint_force(state, **parameters):
    return -_right_force(state, **parameters)
