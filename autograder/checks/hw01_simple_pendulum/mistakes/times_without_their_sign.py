"""The small-angle solution treats a time before zero as one after it.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, *state, **rod):
    return _right_solution(np.abs(t), *state, **rod)
