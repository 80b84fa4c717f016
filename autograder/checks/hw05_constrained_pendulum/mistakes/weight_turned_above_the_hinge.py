"""The weight's share has the wrong sign above the hinge.

fails: force_keeps_the_particle_on_the_circle
"""


def constraint_force(state, *, mass, length, gravity):
    r, v = state[:2], state[2:]
    return -mass * (gravity * abs(r[1]) + v @ v) / length**2 * r
