"""The diameters are drawn along e1 and e2, which do not roll.

fails: wireframe_is_a_rolling_disk
names: Do they roll with the disk
"""


_drawn = wireframe


def wireframe(state, *, radius, sides):
    still = np.array(state)
    still[4] = 0.0
    return [*_drawn(state, radius=radius, sides=sides)[:sides], *_drawn(still, radius=radius, sides=sides)[sides:]]
