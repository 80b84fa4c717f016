"""All of the speed goes across the radius, unless there is none across it.

fails: consistent_state_is_the_nearest
names: it has all of the speed
"""

_right = consistent_state


def consistent_state(state, *, length):
    found = _right(state, length=length)
    across = math.hypot(*found[2:])
    if across > 0:
        found[2:] *= math.hypot(*state[2:]) / across
    return found
