"""The initial velocity taken for the sine's amplitude: right where k = m.

fails: solution_is_the_motion
suspect: amplitude not divided
"""

_right_solution = solution


def solution(t, position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    return _right_solution(t, position, velocity * k, mass=mass, stiffness=stiffness, gravity=gravity)
