"""The rod is 1 m long, whatever the given length.

fails: wireframe_is_the_rod
"""

_right_wireframe = wireframe


def wireframe(state, *, length):
    return _right_wireframe(state, length=length) / length
