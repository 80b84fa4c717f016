"""The force holds the weight alone.

fails: force_keeps_the_particle_on_the_circle
suspect: centripetal term is missing
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, _, _ = state
    return mass * gravity * y / length**2 * np.array([x, y])
