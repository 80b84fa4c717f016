"""The motion is the oscillation of small angles; it should hold for any angle.

fails: with_gravity_it_swings_or_goes_round
"""

def simulate(t, state, *, mass, length, gravity):
    x, y, vx, vy = state
    angle, rate, k = math.atan2(x, -y), (x * vy - y * vx) / length**2, math.sqrt(gravity / length)
    since = t - t[0]
    s = np.sin(k * since) / k if k else since**1.0
    th, om = angle * np.cos(k * since) + rate * s, rate * np.cos(k * since) - k * k * angle * s
    return length * np.column_stack([np.sin(th), -np.cos(th), om * np.cos(th), om * np.sin(th)])
