"""The kinetic energy of a flat wire, v for the speed.

fails: simulate_slides
"""

def simulate(t, x, v, *, curvature, gravity):
    k = math.sqrt(2 * gravity * curvature)
    c, s = np.cos(k * (t - t[0])), np.sin(k * (t - t[0]))
    return np.column_stack([x * c + v * s / k, v * c - x * k * s])
