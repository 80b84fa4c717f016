"""Left and right are exchanged in the projection.

fails: projection_is_orthographic
"""

_right_project = project


def project(points, azimuth, elevation):
    return _right_project(points, azimuth, elevation) * [-1, 1]
