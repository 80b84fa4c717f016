"""Your angle to the axes is the arctan of a ratio, which is 0/0 for a circle; use arctan2.

fails: orbit_has_its_centre_at_the_equilibrium, orbit_is_the_ellipse_of_the_motion
names: NaN or infinity for a circle
"""


def orbit(position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    centre = np.array([0.0, 0.0, -gravity / k**2])
    p, q = position - centre, velocity / k
    if not np.any(velocity):
        return centre, np.array([p, 0 * p])
    with np.errstate(all="ignore"):
        turn = np.arctan(2 * (p @ q) / (p @ p - q @ q)) / 2
    axes = [p * np.cos(turn) + q * np.sin(turn), q * np.cos(turn) - p * np.sin(turn)]
    return centre, np.array(sorted(axes, key=lambda axis: -(axis @ axis)))
