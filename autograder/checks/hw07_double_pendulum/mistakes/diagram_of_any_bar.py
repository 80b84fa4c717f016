"""You return a diagram for a bar that is not there; raise ValueError.

fails: forces_on_each_bar
names: does not raise ValueError
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    bar = 1 if bar == 1 else 2
    return _right(bar, theta, masses=masses, lengths=lengths, gravity=gravity)
