"""The position is moved along y, not along its radius.

fails: consistent_state_is_the_nearest
"""

def consistent_state(state, *, length):
    x, y, vx, vy = state
    if x == y == 0:
        raise ValueError("origin")
    y = math.copysign(math.sqrt(max(length**2 - x**2, 0)), y)
    u = (x * vx + y * vy) / length**2
    return np.array([x, y, vx - u * x, vy - u * y])
