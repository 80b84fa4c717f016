"""A single time gets the given state, as if it were t = 0.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, theta0, omega0, **rod):
    return _right_solution(t, theta0, omega0, **rod) if len(t) > 1 else np.array([[theta0, omega0]])
