"""You wrote forward and left components; the diagram has the axes of the ground.

fails: forces_on_the_car
names: forward and left components
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    (locked_axle, _), (free, _) = _right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    drag = friction_force(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    return [(locked_axle, drag), (free, (0.0, 1.0))]
