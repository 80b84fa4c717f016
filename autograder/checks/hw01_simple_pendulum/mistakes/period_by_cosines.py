"""The period integrates a difference of cosines, which has no digits left at a tiny amplitude.

fails: period_grows_towards_the_top
names: NaN or infinity for an amplitude of less than 1e-4
numerics: digits that cancel
"""

def period(amplitude, *, length, gravity):
    from scipy.integrate import quad

    slowness = lambda theta: 1 / np.sqrt(2 * (np.cos(theta) - np.cos(amplitude)))
    return 4 * math.sqrt(length / gravity) * quad(slowness, 0, amplitude)[0]
