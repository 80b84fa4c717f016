"""Lengths are in units of g m/k, which is zero without gravity.

fails: solution_holds_without_gravity_and_from_any_time
names: ZeroDivisionError for no gravity
"""

_right_solution = solution


def solution(t, position, velocity, *, mass, stiffness, gravity):
    unit = gravity * mass / stiffness
    with np.errstate(all="ignore"):
        return unit * _right_solution(t, position / unit, velocity / unit, mass=mass, stiffness=stiffness, gravity=gravity / unit)
