"""The frequency is kept by the start; another rod gets the same frequency.

fails: small_angle_solution_is_harmonic
names: is anything kept
"""

_right_solution, _kept = small_angle_solution, {}


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    ratio = _kept.setdefault((theta0, omega0), gravity / length) if gravity else 0.0
    return _right_solution(t, theta0, omega0, length=1.0, gravity=ratio)
