"""The closed form treats a time before zero as one after it.

fails: solution_holds_without_gravity_and_from_any_time
"""

_right_solution = solution


def solution(t, *start, **parameters):
    return _right_solution(np.abs(t), *start, **parameters)
