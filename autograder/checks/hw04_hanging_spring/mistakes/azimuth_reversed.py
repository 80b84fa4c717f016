"""The azimuth has the wrong sign.

fails: projection_is_orthographic
"""

_right = project


def project(points, azimuth, elevation):
    return _right(points, -azimuth, elevation)
