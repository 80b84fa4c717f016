"""You divide sin(w t) by w = sqrt(g/l), which is 0/0 without gravity.

fails: small_angle_solution_without_gravity
names: small_angle_solution returned NaN or infinity
"""

def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = np.sqrt(gravity / length)
    c, s = np.cos(k * t), np.sin(k * t)
    return np.column_stack([theta0 * c + omega0 * s / k, omega0 * c - theta0 * k * s])
