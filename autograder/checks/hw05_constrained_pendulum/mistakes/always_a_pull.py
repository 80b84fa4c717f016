"""The force never pushes, as in a string; a rod can push.

fails: force_keeps_the_particle_on_the_circle
"""

_right_force = constraint_force


def constraint_force(state, **parameters):
    force = _right_force(state, **parameters)
    return force if force @ state[:2] < 0 else 0 * force
