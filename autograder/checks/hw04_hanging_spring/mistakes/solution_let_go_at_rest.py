"""The closed form leaves out the velocity at the start.

fails: solution_is_the_motion
"""

_right_solution = solution


def solution(t, position, velocity, **parameters):
    return _right_solution(t, position, 0 * velocity, **parameters)
