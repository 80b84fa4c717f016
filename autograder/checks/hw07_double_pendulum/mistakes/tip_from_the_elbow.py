"""The tip is measured from the elbow; it should be from the ceiling.

fails: wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
"""

_right = wireframe


def wireframe(theta, *, lengths):
    one, (elbow, tip) = _right(theta, lengths=lengths)
    return np.array([one, [elbow, tip - elbow]])
