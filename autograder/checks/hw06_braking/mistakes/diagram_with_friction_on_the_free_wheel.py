"""You drew friction along the free wheel; it rolls, and the ground pushes it only sideways.

fails: forces_on_the_car
names: friction on the free axle
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    drag, (free, left) = _right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    return [drag, (free, left), (free, (-left[1], left[0]))]
