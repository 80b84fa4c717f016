"""A single time is treated as the time of the given state.

fails: solution_holds_without_gravity_and_from_any_time
"""

_right_solution = solution


def solution(t, position, velocity, **parameters):
    if len(t) == 1:
        return np.array([[*position, *velocity]])
    return _right_solution(t, position, velocity, **parameters)
