"""In your small-angle solution sin(w t), w = sqrt(g/l), is not divided by w in theta, nor multiplied by it in omega.

fails: small_angle_solution_is_harmonic
"""

def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    c, s = np.cos(k * t), np.sin(k * t)
    return np.column_stack([theta0 * c + omega0 * s, omega0 * c - theta0 * s])
