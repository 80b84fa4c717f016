"""You drew the drag at the free axle and the side force at the locked one.

fails: forces_on_the_car
names: at the wrong point; it acts at the locked axle
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    (locked_axle, against), (free, left) = _right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    return [(free, against), (locked_axle, left)]
