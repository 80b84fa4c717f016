"""The constant of integration has vy(0) - m g/c in it, where vy(0) + m g/c belongs.

fails: trajectory_is_the_motion, both_paths_are_drawn
"""


def trajectory(t, speed, angle, *, mass, drag, gravity):
    decay, phi1, phi2 = np.vectorize(_decays, otypes=[float] * 3)(drag / mass * t)
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    final = mass * gravity / drag if drag else 0.0
    ends = vy * t * phi1 - final * t * (phi1 + 1.0), (vy - final) * decay - final
    return np.column_stack([vx * t * phi1, ends[0], vx * decay, ends[1]])
