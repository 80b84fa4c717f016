"""Time is measured in units of sqrt(l/g), which is infinite without gravity.

fails: simulate_without_gravity
names: simulate raised ValueError
"""

def simulate(t, theta0, omega0, *, length, gravity):
    from tam570.integrate import solve

    k = np.sqrt(gravity / length)
    scaled = (t - t[0]) * k
    states = solve(lambda s, y: (y[1], -math.sin(y[0])), scaled, (theta0, omega0 / k), rtol=1e-12)
    return states * [1, k]
