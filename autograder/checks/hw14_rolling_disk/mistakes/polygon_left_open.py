"""The last side of the polygon is missing, its place taken by another diameter.

fails: wireframe_is_a_rolling_disk
names: two sides are drawn in one place
"""


_drawn = wireframe


def wireframe(state, *, radius, sides):
    lines = _drawn(state, radius=radius, sides=sides)
    lines[sides - 1] = lines[0]
    return lines
