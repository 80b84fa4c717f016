"""The sign of the elevation.

fails: projection_is_orthographic
suspect: elevation's sign
"""

_right_project = project


def project(points, azimuth, elevation):
    return _right_project(points, azimuth, -elevation)
