"""The closed form is a numerical integration.

fails: trajectory_is_the_motion
names: what is off limits in it
"""


def trajectory(t, speed, angle, *, mass, drag, gravity):
    start = (0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle))
    return solve(_rates, t, start, parameters={"rate": drag / mass, "gravity": gravity}, rtol=1e-13)
