"""The angular velocity of bar 2 is om1 + om2; it should be om2.

fails: free_bars_accelerate_as_lagranges
"""

_right = on_the_fly


def on_the_fly(theta, omega, **known):
    return _right(theta, np.array([omega[0], omega[0] + omega[1]]), **known)
