"""A car that does not turn is stopped by a formula of its own, which holds only forwards.

fails: simulate_needs_no_dense_times, simulate_glides_without_friction, mechanics_refuses_other_axles
"""

_right = simulate


def simulate(t, state, locked, *, front, rear, friction, gravity, **body):
    if state[4]:
        return _right(t, state, locked, front=front, rear=rear, friction=friction, gravity=gravity, **body)
    slowing = friction * gravity * (rear if locked == "front" else front) / (front + rear)
    x, y, heading, speed, _ = state
    since = np.asarray(t) - t[0]
    since_stop = np.minimum(since, abs(speed) / slowing if slowing else np.inf)
    way = abs(speed) * since_stop - slowing * since_stop**2 / 2
    along = np.outer(way, [math.cos(heading), math.sin(heading)])
    return np.column_stack(
        [x + along[:, 0], y + along[:, 1], 0 * since + heading, abs(speed) - slowing * since_stop, 0 * since]
    )
