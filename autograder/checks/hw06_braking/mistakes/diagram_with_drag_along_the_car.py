"""You drew the drag along the car; it opposes the velocity of the locked axle.

fails: forces_on_the_car
names: drag opposes its velocity
"""

_right = free_body_diagram


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    (locked_axle, against), (free, left) = _right(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    forward = np.array([left[1], -left[0]])
    return [(locked_axle, (against @ forward) * forward), (free, left)]
