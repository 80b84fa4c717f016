"""A fixed small number smooths the singular end of the integral, whatever the amplitude.

fails: period_of_small_and_of_huge_amplitudes
names: Do you add a small number under a root
"""


def period(amplitude, *, curvature, gravity):
    angles, weights = np.polynomial.legendre.leggauss(600)
    angle = np.pi / 4 * (1 + angles)
    height = amplitude**2 * np.cos(angle) ** 2  # A^2 - x^2
    rise = 1 + (2 * curvature * amplitude * np.sin(angle)) ** 2
    total = np.sum(weights * np.sqrt(rise * height / (height + 1e-15))) * np.pi / 4
    return float(4 * total / np.sqrt(2 * gravity * curvature))
