"""The azimuth is measured from the y axis; it should be from the x axis.

fails: projection_is_orthographic
"""

_right_project = project


def project(points, azimuth, elevation):
    return _right_project(points, np.pi / 2 - azimuth, elevation)
