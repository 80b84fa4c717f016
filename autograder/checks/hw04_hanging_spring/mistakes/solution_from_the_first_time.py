"""The given state is taken at t[0]; it is the state at t = 0.

fails: solution_holds_without_gravity_and_from_any_time
names: the given one that at t = 0
"""

_right_solution = solution


def solution(t, *start, **parameters):
    return _right_solution(t - t[0], *start, **parameters)
