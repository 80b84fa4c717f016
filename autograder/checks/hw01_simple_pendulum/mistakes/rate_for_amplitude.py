"""The sine has the amplitude omega0; it should have omega0 over the frequency.

fails: small_angle_solution_is_harmonic
"""


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = np.sqrt(gravity / length)
    theta = theta0 * np.cos(k * t) + omega0 * np.sin(k * t)
    omega = k * (omega0 * np.cos(k * t) - theta0 * np.sin(k * t))
    return np.column_stack([theta, omega])
