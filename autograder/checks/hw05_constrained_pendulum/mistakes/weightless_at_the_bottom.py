"""Straight below the hinge or above it the weight is left out of the force, as if it had no moment there to balance.

fails: force_keeps_the_particle_on_the_circle
names: at the bottom
"""

_right_force = constraint_force


def constraint_force(state, *, mass, length, gravity):
    return _right_force(state, mass=mass, length=length, gravity=gravity if state[0] else 0.0)
