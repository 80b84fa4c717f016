"""Gravity divided by the mass in the motion.

fails: with_gravity_it_swings_or_goes_round
suspect: gravity divided by the mass
"""

_right = simulate


def simulate(t, state, *, mass, length, gravity):
    return _right(t, state, mass=mass, length=length, gravity=gravity / mass)
