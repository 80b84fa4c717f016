"""Results are kept by the launch; other drag gets the same results.

fails: flight_time_with_great_drag_and_straight_up, range_with_hardly_any_drag, best_angle_is_45_degrees_without_drag
names: is anything kept
"""

def _kept_by_launch(function):
    kept = {}

    def keeping(*launch, **known):
        if launch not in kept:
            kept[launch] = function(*launch, **known)
        return kept[launch]

    return keeping


_right_time, _right_range = flight_time, horizontal_range
horizontal_range = _kept_by_launch(_right_range)
best_angle = _kept_by_launch(best_angle)
flight_time = _kept_by_launch(_right_time)
