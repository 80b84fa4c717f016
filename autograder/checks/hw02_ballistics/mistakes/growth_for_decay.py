"""The decay is a quotient by e^(c t/m), which overflows; multiply by e^(-c t/m).

fails: trajectory_with_any_drag
names: NaN or infinity for great drag
"""

_right_trajectory = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    states = np.array(_right_trajectory(t, speed, angle, mass=mass, drag=drag, gravity=gravity))
    if drag * t[-1] > mass:
        with np.errstate(all="ignore"):
            growth = np.exp(drag / mass * t)
            states[:, 0] = speed * math.cos(angle) * mass / drag * (growth - 1) / growth
    return states
