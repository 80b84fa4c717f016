"""The velocity is not divided by the frequency.

fails: orbit_is_the_ellipse_of_the_motion
where: ellipse
"""

def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    _, lengths, directions = np.linalg.svd(np.array([position - centre, velocity]), full_matrices=False)
    return centre, lengths[:, None] * directions
