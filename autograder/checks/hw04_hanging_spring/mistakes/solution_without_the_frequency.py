"""The sine's amplitude is not divided by the frequency.

fails: solution_is_the_motion
"""

_right_solution = solution


def solution(t, position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    return _right_solution(t, position, velocity * k, mass=mass, stiffness=stiffness, gravity=gravity)
