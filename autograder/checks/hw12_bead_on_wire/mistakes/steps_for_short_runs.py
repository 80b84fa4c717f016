"""The steps are longer in longer runs.

fails: simulate_keeps_the_energy
numerics: steps that grow with the duration
names: Do your steps grow with the duration
"""

def _rk4_step(x, v, h, wire):
    a, b = v, acceleration_newton(x, v, **wire)
    e, f = v + h / 2 * b, acceleration_newton(x + h / 2 * a, v + h / 2 * b, **wire)
    i, j = v + h / 2 * f, acceleration_newton(x + h / 2 * e, v + h / 2 * f, **wire)
    p, q = v + h * j, acceleration_newton(x + h * i, v + h * j, **wire)
    return x + h / 6 * (a + 2 * e + 2 * i + p), v + h / 6 * (b + 2 * f + 2 * j + q)


def simulate(t, x, v, *, curvature, gravity):
    wire = {"curvature": curvature, "gravity": gravity}
    rows = [(x, v)]
    for span in np.diff(t):
        steps = math.ceil(span * math.sqrt(2 * curvature * max(gravity, 10.0)) / (0.002 if t[-1] - t[0] < 100 / math.sqrt(2 * curvature * max(gravity, 1.0)) else 0.25))
        for _ in range(steps):
            x, v = _rk4_step(x, v, span / steps, wire)
        rows.append((x, v))
    return np.array(rows)
