"""Without gravity every motion is refused, as if nothing could roll then.

fails: rolling_precession_is_zero_where_nothing_turns_it
names: raised ValueError for no gravity
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    if disk["gravity"] == 0.0:
        raise ValueError("nothing makes it turn")
    return _precession(lean, track_radius, **disk)
