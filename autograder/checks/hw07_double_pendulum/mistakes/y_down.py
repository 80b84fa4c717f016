"""The wireframe has y downwards; it should be upwards.

fails: wireframe_shows_the_bars, tip_path_is_drawn, forces_on_each_bar
"""

y_up = wireframe


def wireframe(theta, *, lengths):
    return y_up(theta, lengths=lengths) * [1, -1]
