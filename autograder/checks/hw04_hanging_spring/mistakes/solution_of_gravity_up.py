"""Gravity pulls up; it should pull down.

fails: solution_is_the_motion
"""

_right_solution = solution


def solution(t, position, velocity, *, mass, stiffness, gravity):
    return _right_solution(t, position, velocity, mass=mass, stiffness=stiffness, gravity=-gravity)
