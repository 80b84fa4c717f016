"""The smaller axis is along a cross product with the normal of the plane, which a line does not have.

fails: orbit_may_be_a_line_or_a_point
names: NaN or infinity for a line | NaN or infinity for a point
"""

def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    p, q = position - centre, velocity * np.sqrt(mass / stiffness)
    phase = np.arctan2(2 * p @ q, p @ p - q @ q) / 2
    first, normal = p * np.cos(phase) + q * np.sin(phase), np.cross(p, q)
    with np.errstate(all="ignore"):
        return centre, np.array([first, np.cross(normal, first) / (first @ first)])
