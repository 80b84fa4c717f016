"""Lambert's W is used as it is, with only half of its digits next to its branch point.

fails: flight_time_with_hardly_any_drag, range_with_hardly_any_drag
names: NaN or infinity for very little drag | near its branch point
"""


def flight_time(speed, angle, *, mass, drag, gravity):
    from scipy.special import lambertw

    if drag < 1e-9:
        return 2 * speed * math.sin(angle) / gravity
    a = 1 + drag * speed * math.sin(angle) / (mass * gravity)
    return mass / drag * (a + lambertw(-a * np.exp(-a)).real)
