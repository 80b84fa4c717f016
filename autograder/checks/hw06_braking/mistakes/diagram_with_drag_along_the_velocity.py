"""You drew the drag along the velocity; it opposes the velocity.

fails: forces_on_the_car
names: this is the force on the ground
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    (locked_axle, against), side = _right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    return [(locked_axle, -against), side]
