"""The contact point is treated as fixed in the body, but its place in the disk changes.

fails: steady_residual_is_the_tilt_acceleration
within: 1e-10
"""


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    A, C = inertia
    m, c, s = mass * radius**2, math.cos(lean), math.sin(lean)
    gyroscopic = precession * c * ((A + m) * precession * s + (C + 2 * m) * spin)
    return (mass * gravity * radius * s - gyroscopic) / (A + m)
