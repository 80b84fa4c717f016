"""th2 is measured from bar 1, so that bar 2 is drawn at th1 + th2.

fails: wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
"""

absolute = wireframe


def wireframe(theta, *, lengths):
    return absolute(np.cumsum(theta), lengths=lengths)
