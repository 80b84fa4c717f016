"""Gravity below 0.1 m/s^2 counts as none.

fails: small_angle_solution_is_harmonic, simulate_needs_no_dense_times
"""

_right_solution, _right_simulate = small_angle_solution, simulate


def small_angle_solution(t, *state, length, gravity):
    return _right_solution(t, *state, length=length, gravity=gravity if gravity > 0.1 else 0.0)


def simulate(t, *state, length, gravity):
    return _right_simulate(t, *state, length=length, gravity=gravity if gravity > 0.1 else 0.0)
