"""A triangle has two sides and the way back is left out: a side is drawn twice.

fails: wireframe_is_a_rolling_disk
names: two sides are drawn in one place, and one is missing for 3 sides
"""

_right = wireframe


def wireframe(state, *, radius, sides):
    lines = np.array(_right(state, radius=radius, sides=sides))
    if sides == 3:
        lines[2] = lines[0]
    return lines
