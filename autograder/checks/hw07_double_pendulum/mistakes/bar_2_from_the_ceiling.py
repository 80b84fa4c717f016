"""Bar 2 begins at the ceiling; it hangs from the elbow.

fails: wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
"""

_right = wireframe


def wireframe(theta, *, lengths):
    one, (elbow, tip) = _right(theta, lengths=lengths)
    return np.array([one, [np.zeros(2), tip - elbow]])
