"""Four edges are drawn twice, and the lid's four are missing.

fails: the_box_has_its_twelve_edges
names: is one drawn twice
"""

_right_wireframe = wireframe


def wireframe(R, *, size):
    edges = _right_wireframe(np.eye(3), size=size)
    edges[..., 2] = np.where(np.ptp(edges[..., 2], axis=1, keepdims=True) > 0, edges[..., 2], -size[2] / 2)
    return edges @ R.T
