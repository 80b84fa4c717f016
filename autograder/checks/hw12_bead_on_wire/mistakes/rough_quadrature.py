"""A rule of two hundred points: enough near 1/c, not for steep wires.

fails: period_of_small_and_of_huge_amplitudes
names: the error grows with the amplitude
"""

def period(amplitude, *, curvature, gravity):
    nodes = (np.arange(200) + 0.5) * np.pi / 200
    mean = np.mean(np.hypot(1, 2 * curvature * amplitude * np.sin(nodes)))
    return 2 * np.pi * mean / math.sqrt(2 * gravity * curvature)
