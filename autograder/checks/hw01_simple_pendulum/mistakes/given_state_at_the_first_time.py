"""The start is used at t[0]; it is the state at t = 0.

fails: small_angle_solution_is_harmonic
"""

def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    c, s = np.cos(k * (t - t[0])), np.sin(k * (t - t[0]))
    return np.column_stack([theta0 * c + omega0 * s / k, omega0 * c - theta0 * k * s])
