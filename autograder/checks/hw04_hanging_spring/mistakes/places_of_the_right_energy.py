"""Long motions jump among states of the right energy.

fails: energy_stays
"""

_right = simulate


def simulate(t, position, velocity, **known):
    rows = np.array(_right(t, position, velocity, **known))
    long = (t[-1] - t[0]) * np.sqrt(known["stiffness"] / known["mass"]) > 50
    return rows[np.argsort(np.sin(np.arange(len(t)) * 7.0))] if long else rows
