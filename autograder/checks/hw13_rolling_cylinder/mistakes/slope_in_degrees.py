"""The slope is treated as degrees; it is in radians.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, *, slope, **c):
    return _right(phi, phi_dot, slope=math.radians(slope), **c)
