"""A drag below 1e-4 kg/s counts as none.

fails: trajectory_with_any_drag
within: 1e-8
"""

_right_trajectory = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    known = {"mass": mass, "drag": drag if drag > 1e-4 else 0.0, "gravity": gravity}
    return _right_trajectory(t, speed, angle, **known)
