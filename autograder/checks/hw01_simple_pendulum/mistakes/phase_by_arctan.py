"""The phase of the small-angle solution is the arctan of a ratio, which loses the quadrant: use arctan2.

fails: small_angle_solution_is_harmonic
"""

def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = np.sqrt(gravity / length)
    if k == 0:
        return np.column_stack([theta0 + omega0 * t, omega0 + 0 * t])
    size = np.hypot(theta0, omega0 / k)
    phase = np.arctan(-omega0 / k / theta0) if theta0 else -np.sign(omega0) * np.pi / 2
    return np.column_stack([size * np.cos(k * t + phase), -k * size * np.sin(k * t + phase)])
