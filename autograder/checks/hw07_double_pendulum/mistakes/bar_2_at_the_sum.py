"""Bar 2 is drawn at th1 + th2, as if th2 were measured from bar 1.

fails: wireframe_shows_the_bars, tip_path_is_drawn
suspect: drawn at th1 + th2
"""

absolute = wireframe


def wireframe(theta, *, lengths):
    return absolute(np.cumsum(theta), lengths=lengths)
