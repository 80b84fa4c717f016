"""The rows are at the times in ascending order.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, *state, **rod):
    return _right_solution(np.sort(t), *state, **rod)
