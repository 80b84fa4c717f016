"""The polygon is drawn in the frame e1, e2, which does not roll.

fails: wireframe_is_a_rolling_disk
names: the drawing's place in the disk
"""


_drawn = wireframe


def wireframe(state, *, radius, sides):
    still = np.array(state)
    still[4] = 0.0
    return _drawn(still, radius=radius, sides=sides)
