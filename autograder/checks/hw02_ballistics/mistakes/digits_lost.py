"""The path is the textbook formula, which loses all digits where there is little drag.

fails: trajectory_with_any_drag
names: a difference of nearly equal numbers
"""


def trajectory(t, speed, angle, *, mass, drag, gravity):
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    if drag == 0:
        return np.column_stack([vx * t, vy * t - gravity * t**2 / 2, vx + 0 * t, vy - gravity * t])
    k = drag / mass
    decay = np.exp(-k * t)
    y = (vy + gravity / k) * (1 - decay) / k - gravity * t / k
    return np.column_stack([vx * (1 - decay) / k, y, vx * decay, (vy + gravity / k) * decay - gravity / k])
