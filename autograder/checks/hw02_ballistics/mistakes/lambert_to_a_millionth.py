"""Lambert's W is used as it is where c v/(m g) is above 1e-6; next to its branch point it loses digits.

fails: flight_time_with_hardly_any_drag, range_with_hardly_any_drag
numerics: a right equation, solved to too few digits
names: near its branch point
"""

_right_flight_time = flight_time


def flight_time(speed, angle, *, mass, drag, gravity):
    from scipy.special import lambertw

    b = drag * speed * math.sin(angle) / (mass * gravity)
    if b < 1e-6:
        return _right_flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return mass / drag * (1 + b + lambertw(-(1 + b) * math.exp(-1 - b)).real)
