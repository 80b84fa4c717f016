"""Friction points straight back along the car, whatever way the locked axle moves.

fails: friction_opposes_the_sliding, equations_of_motion
"""

_right = friction_force


def friction_force(state, locked, **car):
    size = math.hypot(*_right(state, locked, **car))
    return np.array([-size * np.sign(state[3]), 0.0])


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    speed, yaw_rate = state[3:]
    slowing = -car["drag"] / mass * np.sign(speed) - car["free"] * yaw_rate**2
    turning = mass * car["free"] * speed * yaw_rate / car["inertia"]
    return np.array([*_rates(t, state, **car)[:3], slowing, turning])
