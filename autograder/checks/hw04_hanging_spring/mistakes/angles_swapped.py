"""Azimuth and elevation are swapped.

fails: projection_is_orthographic
"""

def project(points, azimuth, elevation):
    (ca, ce), (sa, se) = np.cos([elevation, azimuth]), np.sin([elevation, azimuth])
    right, up = np.array([-sa, ca, 0]), np.array([-se * ca, -se * sa, ce])
    return np.column_stack([points @ right, points @ up])
