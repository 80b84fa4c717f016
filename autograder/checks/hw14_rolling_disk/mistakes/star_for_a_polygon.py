"""With an odd number of sides every second corner is joined to the next: a star.

fails: wireframe_is_a_rolling_disk
names: Is the polygon closed and regular
"""

_right = wireframe


def wireframe(state, *, radius, sides):
    lines = np.array(_right(state, radius=radius, sides=sides))
    if sides % 2 and sides > 3:
        corners = lines[np.arange(sides + 1) * 2 % sides, 0]
        lines[:sides] = np.stack([corners[:-1], corners[1:]], axis=1)
    return lines
