"""A closed form that takes a drag below 1e-4 kg/s for none.

fails: trajectory_with_any_drag
names: taken for none
"""

_right_trajectory = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    known = {"mass": mass, "drag": drag if drag > 1e-4 else 0.0, "gravity": gravity}
    return _right_trajectory(t, speed, angle, **known)
