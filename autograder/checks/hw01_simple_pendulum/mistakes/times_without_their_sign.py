"""The small-angle solution takes a time before zero for one after it.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, *state, **rod):
    return _right_solution(np.abs(t), *state, **rod)
