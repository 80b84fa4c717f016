"""The constraint differentiated once, to r . v = 0, and r . a = 0 for the second time: the centripetal term is
missing.

fails: force_keeps_the_particle_on_the_circle
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, _, _ = state
    return mass * gravity * y / length**2 * np.array([x, y])
