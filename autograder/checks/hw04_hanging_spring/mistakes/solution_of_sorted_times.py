"""The closed form is given at the times in ascending order, not in yours.

fails: solution_holds_without_gravity_and_from_any_time
names: Row i is the state at t[i]
"""

_right_solution = solution


def solution(t, *start, **parameters):
    return _right_solution(np.sort(t), *start, **parameters)
