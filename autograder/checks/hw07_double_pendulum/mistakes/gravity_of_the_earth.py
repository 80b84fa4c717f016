"""The gravity is 9.81 m/s^2, whatever is given.

fails: free_bars_accelerate_as_lagranges
"""

_right = on_the_fly


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    return _right(theta, omega, masses=masses, lengths=lengths, gravity=9.81)
