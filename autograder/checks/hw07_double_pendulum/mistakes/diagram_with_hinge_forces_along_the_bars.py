"""You drew the hinge forces along the bar; a bar with weight can carry them in any direction.

fails: forces_on_each_bar
names: no component of it is known
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    weight, *hinges = _right(bar, theta, masses=masses, lengths=lengths, gravity=gravity)
    along = np.diff(wireframe(theta, lengths=lengths)[bar - 1], axis=0)[0]
    return [weight, *((point, along) for point, _ in hinges)]
