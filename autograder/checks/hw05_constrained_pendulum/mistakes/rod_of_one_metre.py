"""A rod of one metre in the right direction.

fails: wireframe_is_the_rod
suspect: a rod of one metre
"""

_right_wireframe = wireframe


def wireframe(state, *, length):
    return _right_wireframe(state, length=length) / length
