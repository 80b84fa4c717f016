"""The energy lacks the motion of the centre.

fails: energy_is_kinetic_and_potential
"""


def energy(state, *, mass, radius, inertia, gravity):
    A, C = inertia
    tilt, yaw_rate, tilt_rate = state[3], state[5], state[6]
    kinetic = A * (tilt_rate**2 + (yaw_rate * math.sin(tilt)) ** 2) + C * _spin(state) ** 2
    return kinetic / 2 + mass * gravity * radius * math.sin(tilt)
