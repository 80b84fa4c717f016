"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_car
names: Nothing exerts m a
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    return [*_right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity), (state[:2], (np.cos(state[2] + 1.0), np.sin(state[2] + 1.0)))]
