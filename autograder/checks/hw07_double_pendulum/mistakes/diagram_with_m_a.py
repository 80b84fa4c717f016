"""You drew m a as a force; no other body exerts it.

fails: forces_on_each_bar
names: Nothing exerts m a
"""

_right = free_body_diagram


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    weight, *hinges = _right(bar, theta, masses=masses, lengths=lengths, gravity=gravity)
    return [weight, *hinges, (weight[0], (np.cos(theta[0]), np.sin(theta[0])))]
