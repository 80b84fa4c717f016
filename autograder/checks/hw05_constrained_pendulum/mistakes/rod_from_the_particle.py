"""The rod goes from the particle to the hinge; it should begin at the hinge.

fails: wireframe_is_the_rod
"""

_right_wireframe = wireframe


def wireframe(state, *, length):
    return _right_wireframe(state, length=length)[:, ::-1]
