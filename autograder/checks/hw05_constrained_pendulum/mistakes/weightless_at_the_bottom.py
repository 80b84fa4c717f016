"""The weight is left out where the rod is vertical.

fails: force_keeps_the_particle_on_the_circle
"""

_right_force = constraint_force


def constraint_force(state, *, mass, length, gravity):
    return _right_force(state, mass=mass, length=length, gravity=gravity if state[0] else 0.0)
