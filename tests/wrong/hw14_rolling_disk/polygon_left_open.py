"""The last side of the polygon is missing, its place taken by another diameter.

fails: wireframe_is_a_rolling_disk
"""


_drawn = wireframe


def wireframe(state, *, radius, sides):
    lines = _drawn(state, radius=radius, sides=sides)
    lines[sides - 1] = lines[0]
    return lines
