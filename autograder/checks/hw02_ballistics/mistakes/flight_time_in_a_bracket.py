"""The search for the flight time begins at 1e-5 s, which may be after the landing.

fails: flight_time_with_great_drag_and_straight_up
names: ValueError for a nearly flat launch
"""

_right_time = flight_time


def flight_time(speed, angle, *, mass, drag, gravity):
    from scipy.optimize import brentq

    def height(time):
        _, phi1, phi2 = _decays(drag / mass * time)
        return speed * math.sin(angle) * phi1 - gravity * time * phi2

    return brentq(height, 1e-5, 2 * speed * math.sin(angle) / gravity * (1 + 1e-9), xtol=1e-15)


def horizontal_range(speed, angle, **known):
    return trajectory(np.array([_right_time(speed, angle, **known)]), speed, angle, **known)[0, 0]
