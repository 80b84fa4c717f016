"""Up comes first; the result is (right, up).

fails: projection_is_orthographic
"""

_right = project


def project(points, azimuth, elevation):
    return _right(points, azimuth, elevation)[:, ::-1]
