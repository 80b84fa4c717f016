"""Angles in degrees.

fails: projection_is_orthographic
suspect: angles taken for degrees
"""

_right_project = project


def project(points, azimuth, elevation):
    return _right_project(points, np.radians(azimuth), np.radians(elevation))
