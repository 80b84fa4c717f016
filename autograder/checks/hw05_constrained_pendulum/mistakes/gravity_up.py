"""Gravity pulls up; it should pull down.

fails: with_gravity_it_swings_or_goes_round
"""

def _rates(t, state, *, pull):
    x, y, turning = state
    return -turning * y, turning * x, pull * x
