"""The diameters go only from the centre to the rim.

fails: wireframe_is_a_rolling_disk
names: a diameter goes from rim to rim
"""


_drawn = wireframe


def wireframe(state, *, radius, sides):
    lines = _drawn(state, radius=radius, sides=sides)
    lines[sides:, 0] = lines[sides:].mean(axis=1)
    return lines
