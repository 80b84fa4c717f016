"""The motion follows a flat wire: the term 4 c^2 x v^2 and the factor 1 + 4 c^2 x^2 are missing.

fails: simulate_slides
"""

def simulate(t, x, v, *, curvature, gravity):
    k = math.sqrt(2 * gravity * curvature)
    c, s = np.cos(k * (t - t[0])), np.sin(k * (t - t[0]))
    return np.column_stack([x * c + v * s / k, v * c - x * k * s])
