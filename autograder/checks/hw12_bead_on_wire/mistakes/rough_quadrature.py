"""The period's integral has sixty points, enough near 1/c, but too few for steep wires.

fails: period_of_small_and_of_huge_amplitudes
"""

def period(amplitude, *, curvature, gravity):
    nodes = (np.arange(60) + 0.5) * np.pi / 60
    mean = np.mean(np.hypot(1, 2 * curvature * amplitude * np.sin(nodes)))
    return 2 * np.pi * mean / math.sqrt(2 * gravity * curvature)
