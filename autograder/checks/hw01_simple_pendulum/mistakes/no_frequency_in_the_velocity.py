"""The frequency is missing from the derivative of the cosine.

fails: small_angle_solution_is_harmonic
suspect: lack a factor, the frequency
"""


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    theta = theta0 * np.cos(k * t) + omega0 / k * np.sin(k * t)
    return np.column_stack([theta, omega0 * np.cos(k * t) - theta0 * np.sin(k * t)])
