"""The end of bar 1 at the ceiling has the acceleration of a bar without angular velocity.

fails: free_bars_accelerate_as_lagranges
suspect: left out at the ceiling's hinge
"""

_right = _weights_and_centripetal


def _weights_and_centripetal(along, spins, masses, gravity):
    known = _right(along, spins, masses, gravity)
    known[CEILING] = 0.0
    return known
