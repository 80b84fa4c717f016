"""The drag force is not divided by the mass.

fails: trajectory_is_the_motion, both_paths_are_drawn
"""

with_mass = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    return with_mass(t, speed, angle, mass=1.0, drag=drag, gravity=gravity)
