"""Bar 2 is drawn at th2 - th1; th2 is measured from straight down.

fails: wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
"""

absolute = wireframe


def wireframe(theta, *, lengths):
    return absolute(theta - np.array([0.0, theta[0]]), lengths=lengths)
