"""The closed form is right for a mass of 1 kg.

fails: trajectory_is_the_motion, both_paths_are_drawn
suspect: not divided by the mass
"""

with_mass = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    return with_mass(t, speed, angle, mass=1.0, drag=drag, gravity=gravity)
