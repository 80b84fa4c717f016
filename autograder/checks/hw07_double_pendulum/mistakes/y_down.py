"""The bars are drawn with y down.

fails: wireframe_shows_the_bars, tip_path_is_drawn
suspect: y pointing down
"""

y_up = wireframe


def wireframe(theta, *, lengths):
    return y_up(theta, lengths=lengths) * [1, -1]
