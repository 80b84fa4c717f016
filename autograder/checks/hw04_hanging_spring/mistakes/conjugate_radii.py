"""The axes are position and velocity from the centre; these are radii, which need not be axes.

fails: orbit_is_the_ellipse_of_the_motion
names: two radii that give the ellipse need not be its axes
"""

def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    radii = sorted([position - centre, velocity * np.sqrt(mass / stiffness)], key=lambda r: -(r @ r))
    return centre, np.array(radii)
