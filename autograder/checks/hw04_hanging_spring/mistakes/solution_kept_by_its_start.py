"""Closed forms are kept by times and start: another spring gets the first one's.

fails: solution_holds_without_gravity_and_from_any_time
names: Is anything kept between calls?
"""

_right_solution, _kept = solution, {}


def solution(t, position, velocity, **parameters):
    key = (*t, *position, *velocity)
    if key not in _kept:
        _kept[key] = _right_solution(t, position, velocity, **parameters)
    return _kept[key].copy()
