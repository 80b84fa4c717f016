"""Beyond eight periods every row is the start, which keeps the energy.

fails: energy_stays
names: every row is the start
"""

_right_simulate = simulate


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    if (t[-1] - t[0]) * np.sqrt(stiffness / mass) > 16 * np.pi:
        return np.tile([*position, *velocity], (len(t), 1))
    return _right_simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
