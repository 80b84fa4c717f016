"""Gravity is divided by the mass, but a heavy particle falls as a light one does.

fails: with_gravity_it_swings_or_goes_round
"""

_right = simulate


def simulate(t, state, *, mass, length, gravity):
    return _right(t, state, mass=mass, length=length, gravity=gravity / mass)
