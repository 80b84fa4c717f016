"""The angle is measured from the vertical; it should be from the horizontal.

fails: simulation_follows_the_motion, trajectory_is_the_motion, path_at_a_huge_speed_has_the_limit_shape, both_paths_are_drawn
"""

_simulate, _trajectory, _shape = simulate, trajectory, limit_shape


def simulate(t, speed, angle, **known):
    return _simulate(t, speed, math.pi / 2 - angle, **known)


def trajectory(t, speed, angle, **known):
    return _trajectory(t, speed, math.pi / 2 - angle, **known)


def limit_shape(angle):
    return _shape(math.pi / 2 - angle)
