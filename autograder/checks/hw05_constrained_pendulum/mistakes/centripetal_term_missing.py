"""The centripetal term is missing: the derivative of r . v = 0 is v . v + r . a = 0.

fails: force_keeps_the_particle_on_the_circle
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, _, _ = state
    return mass * gravity * y / length**2 * np.array([x, y])
