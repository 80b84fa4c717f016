"""In omega(t) your term with theta0 lacks the factor sqrt(g/l).

fails: small_angle_solution_is_harmonic
"""


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    theta = theta0 * np.cos(k * t) + omega0 / k * np.sin(k * t)
    return np.column_stack([theta, omega0 * np.cos(k * t) - theta0 * np.sin(k * t)])
