"""The height y is always -sqrt(l^2 - x^2), which is right only below the hinge.

fails: acceleration_is_that_of_both_forces
"""

def acceleration(state, *, mass, length, gravity):
    x, y, vx, vy = state
    y = -math.sqrt(max(length**2 - x**2, 0))
    pull = (gravity * y - vx**2 - vy**2) / length**2
    return np.array([pull * x, pull * y - gravity])
