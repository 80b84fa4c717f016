"""The best angle is the maximum of the range, found too coarsely at a huge speed, where it is very flat.

fails: best_angle_at_a_huge_speed
names: the largest range is very flat there
"""


def best_angle(speed, **known):
    from scipy.optimize import minimize_scalar

    found = minimize_scalar(
        lambda angle: -horizontal_range(speed, angle, **known) / speed,
        bounds=(1e-4, 1.5), method="bounded", options={"xatol": 1e-9},
    )
    return found.x
