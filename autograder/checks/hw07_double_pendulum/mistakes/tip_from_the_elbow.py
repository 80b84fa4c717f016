"""The end of bar 2 is given as seen from the elbow.

fails: wireframe_shows_the_bars, tip_path_is_drawn
suspect: the tip as seen from the elbow
"""

_right = wireframe


def wireframe(theta, *, lengths):
    one, (elbow, tip) = _right(theta, lengths=lengths)
    return np.array([one, [elbow, tip - elbow]])
