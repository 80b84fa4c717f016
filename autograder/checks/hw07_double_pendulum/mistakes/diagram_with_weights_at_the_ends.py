"""You drew the weight at the end of the bar; it acts at its middle.

fails: forces_on_each_bar
names: You drew the weight at the wrong point
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    _, *hinges = _right(bar, theta, masses=masses, lengths=lengths, gravity=gravity)
    return [(wireframe(theta, lengths=lengths)[bar - 1, 1], (0.0, -1.0)), *hinges]
