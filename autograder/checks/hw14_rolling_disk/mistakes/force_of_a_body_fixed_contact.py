"""The contact point is treated as fixed in the body, but its place in the disk changes.

fails: contact_force_moves_the_centre
"""


def contact_force(state, *, mass, radius, inertia, gravity):
    e1, e2, e3 = _frame(state)
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    A, C = inertia
    m, c = mass * radius**2, math.cos(state[3])
    w1, w2, w3, turn = state[6], state[5] * math.sin(state[3]), _spin(state), state[5] * c
    first = (w2 * ((A + m) * turn - (C + 2 * m) * w3) - mass * gravity * radius * c) / (A + m) + w2 * (w3 - turn)
    third = m * w1 * w2 / (C + m)
    acceleration = radius * (-third * e1 + first * e3)
    omega = w1 * e1 + w2 * e2 + w3 * e3
    acceleration = acceleration + np.cross(omega, np.cross(omega, radius * e2))
    return mass * (acceleration + np.array([0.0, 0.0, gravity]))
