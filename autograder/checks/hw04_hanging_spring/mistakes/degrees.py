"""The angles are treated as degrees; they are in radians.

fails: projection_is_orthographic
"""

_right_project = project


def project(points, azimuth, elevation):
    return _right_project(points, np.radians(azimuth), np.radians(elevation))
