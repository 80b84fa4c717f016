"""Your constraint at the ceiling leaves out the centripetal acceleration of bar 1's mass centre.

fails: free_bars_accelerate_as_lagranges
"""

_right = _weights_and_centripetal


def _weights_and_centripetal(along, spins, masses, gravity):
    known = _right(along, spins, masses, gravity)
    known[CEILING] = 0.0
    return known
