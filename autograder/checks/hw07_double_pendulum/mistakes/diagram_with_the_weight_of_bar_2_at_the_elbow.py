"""You drew the weight of bar 2 at the elbow of bar 1.

fails: forces_on_each_bar
names: You drew the weight of bar 2 on bar 1
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    elbow = wireframe(theta, lengths=lengths)[1, 0]
    return [*_right(bar, theta, masses=masses, lengths=lengths, gravity=gravity), *([(elbow, (0.0, -1.0))] if bar == 1 else [])]
