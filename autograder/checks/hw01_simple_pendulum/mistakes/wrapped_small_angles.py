"""The angle of the small-angle solution is brought back between -pi and pi; angles are never wrapped.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, *state, **rod):
    states = _right_solution(t, *state, **rod)
    states[:, 0] = (states[:, 0] + np.pi) % (2 * np.pi) - np.pi
    return states
