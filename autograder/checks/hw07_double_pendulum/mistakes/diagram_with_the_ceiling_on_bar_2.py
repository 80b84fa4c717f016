"""You drew the force of the ceiling on bar 2; it touches only bar 1.

fails: forces_on_each_bar
names: force of the ceiling on bar 2
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    return [*_right(bar, theta, masses=masses, lengths=lengths, gravity=gravity), *([((0.0, 0.0), None)] if bar == 2 else [])]
