"""g/l stands where its square root belongs.

fails: small_angle_solution_is_harmonic
"""


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = gravity / length
    c, s = np.cos(k * t), np.sin(k * t)
    return np.column_stack([theta0 * c + omega0 * (s / k if k else t), omega0 * c - theta0 * k * s])
