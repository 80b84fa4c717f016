"""The search for the best angle begins in a bracket that may not hold it.

fails: best_angle_has_the_largest_range
names: best_angle raised ValueError
"""


def best_angle(speed, *, mass, drag, gravity):
    from scipy.optimize import brentq

    def slope(angle):
        near = [horizontal_range(speed, a, mass=mass, drag=drag, gravity=gravity) for a in (angle - 1e-5, angle + 1e-5)]
        return near[1] - near[0]

    return brentq(slope, 0.7, 0.8)
