"""You find the direction to the right as the vertical x the direction of the eye; from straight above that is zero.

fails: projection_is_orthographic
"""


def project(points, azimuth, elevation):
    eye = np.array([
        np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)
    ])
    right = np.cross([0.0, 0.0, 1.0], eye)
    right = right / max(np.linalg.norm(right), 1e-9)
    return points @ np.column_stack([right, np.cross(eye, right)])
